"""A free motion with the numbers of its constants in their place, as x = 0.2·exp(−t)·sin(19.97·t)."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from vibcli.notation.numbers import figure
from vibcli.report.blocks import Name, WithNumbers, Words
from vibcli.report.steps.degree import Degree
from vibcli.symbolic.derivatives import substitute

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def tell_motion_in_numbers(degree: Degree, motion: "Node", known: "Iterable[tuple[Node, float | None]]",
                           uses: Sequence[int]) -> None:
    """Write down a motion with numbers for its letters, without what is zero; nothing where one has none, or where
    nothing moves."""
    values = {letter: value for letter, value in known if value is not None}
    table = motion.table
    plainly = {letter: table.zero if not value else table.one if figure(abs(value)) == "1" else letter
               for letter, value in values.items()}
    signed = {letter: -node if values[letter] < 0 else node for letter, node in plainly.items()}
    shown, = substitute([motion], signed)
    if shown.is_zero or any(value is None for _, value in known):
        return
    told = WithNumbers(shown, {letter.name: figure(abs(value)) for letter, value in values.items()})
    degree.sheet.write(Words("so  "), Name(degree.name), " = ", told, Words(f"   (in {degree.unit})"), uses=uses,
                       settles=f"motion of {degree.name}")
