"""Beams, across their axis: (EI u″)″ − (N u′)′ + ρA ü = 0, after Euler and Bernoulli."""

from typing import TYPE_CHECKING, Any

from vibcli.elements.member import built
from vibcli.elements.member_fields import BEAM, member_element

if TYPE_CHECKING:
    from vibcli.language.reader import Record

ELEMENT = member_element(
    BEAM,
    "A slender beam that bends across its axis: `{length: L, EI: E*I, mass_per_length: mu, left: clamped}`.",
    "beams")


def build(record: "Record", scene: Any) -> None:
    """Add a beam to the scene."""
    built(record.name, scene)
