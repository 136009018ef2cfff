"""Beams, across their axis: (EI u″)″ − (N u′)′ + ρA ü = 0, after Euler and Bernoulli; along it (EA w′)′ = ρA ẅ, if at
all."""

from typing import TYPE_CHECKING

from vibcli.elements.member import built
from vibcli.elements.member_fields import BEAM, member_element

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder

ELEMENT = member_element(
    BEAM,
    "A slender beam that bends across its axis: `{length: L, EI: E*I, mass_per_length: mu, left: clamped}`. In the "
    "plane, drawn `from` a place `to` another, one with `EA` stretches too; one without it keeps its length as a link "
    "does. There `guided` keeps the slope and lets it go across alone: along its line it is held as by `clamped` and "
    "`pinned`; springs `k` and supports on it act across.",
    "beams")


def build(record: "Record", scene: "Builder") -> None:
    """Add a beam to the scene."""
    built(record.name, scene)
