"""Shafts, which turn about their axis: (GI_o φ′)′ = ρI_o φ̈."""

from typing import TYPE_CHECKING

from vibcli.elements.member import built
from vibcli.elements.member_fields import SHAFT, member_element

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder

ELEMENT = member_element(
    SHAFT,
    "An elastic shaft that turns about its axis: `{length: L, G: G, rho: rho, section: {circle: d}, left: "
    "clamped}`.",
    "shafts")


def build(record: "Record", scene: "Builder") -> None:
    """Add a shaft to the scene."""
    built(record.name, scene)
