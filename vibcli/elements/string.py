"""Strings, across their axis: (T u′)′ = μ ü, T being the tension."""

from typing import TYPE_CHECKING

from vibcli.elements.member import built
from vibcli.elements.member_fields import STRING, member_element

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder

ELEMENT = member_element(
    STRING,
    "A string under tension, across its axis: `{length: L, mass_per_length: mu, preload: T, left: clamped, "
    "right: clamped}`.",
    "strings")


def build(record: "Record", scene: "Builder") -> None:
    """Add a string to the scene."""
    built(record.name, scene)
