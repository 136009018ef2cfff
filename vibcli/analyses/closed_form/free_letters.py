"""Letters for what equations name themselves, none of which a scene has."""

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

FREQUENCY = ("omega", "nu", "iota")
ARGUMENTS = ("theta", "eta", "kappa", "zeta")
IMPEDANCES = ("Z", "Q", "P")
STIFFNESSES = ("k", "D", "B", "A")      # of the displacement of an end, or of its only motion; of its turn, of both
TURNS = ("R", "H", "K")
BOTH = ("G", "F", "C")


def free_letter(taken: Collection[str], letters: Sequence[str]) -> str:
    """The first letter that is not taken; the last one with the least number where all are."""
    count = len(taken) + 1
    return next(one for one in (*letters, *(f"{letters[-1]}{n}" for n in range(1, count + 1))) if one not in taken)


def free_letters(taken: Collection[str], letters: Sequence[str], count: int) -> list[str]:
    """So many names: one letter, or one with numbers, none of which is taken."""
    if count == 1:
        return [free_letter(taken, letters)]
    return next(names for names in ([f"{one}{n + 1}" for n in range(count)] for one in (
        *letters, *(letter + "_" for letter in letters))) if not any(name in taken for name in names))


def in_order(*arguments: "Node") -> None:
    """Functions of arguments are written in this order from now on."""
    for argument in arguments:
        for name in ("cos", "sin", "cosh", "sinh"):
            argument.table.call(name, argument)
