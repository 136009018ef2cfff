"""Bars, along their axis: (EA u′)′ = ρA ü."""

from typing import TYPE_CHECKING

from vibcli.elements.member import built
from vibcli.elements.member_fields import BAR, member_element

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder

ELEMENT = member_element(
    BAR,
    "An elastic bar that moves along its axis: `{length: L, E: E, A: A, rho: rho, left: clamped}`.",
    "bars")


def build(record: "Record", scene: "Builder") -> None:
    """Add a bar to the scene."""
    built(record.name, scene)
