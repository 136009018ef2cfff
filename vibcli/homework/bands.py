"""How far an answer may lie from its key: what rounding on the way to it does, and its own last figure."""

from typing import TYPE_CHECKING, NamedTuple

from vibcli.homework.keys import half_a_unit

if TYPE_CHECKING:
    from vibcli.homework.keys import AnswerKey

FIGURES = 3, 4, 5       # that a sheet may ask for
ROUNDED = 0.005         # of a key, by lines of its solution that are rounded to three figures
WIDEST = 0.02           # of a key


class Band(NamedTuple):
    """An answer with so many figures may lie so far from its key, in its unit."""

    figures: int
    width: float


def band(key: "AnswerKey", value: float, figures: int) -> Band:
    """The Band of a key for answers with so many figures."""
    if key.rtol is not None:
        return Band(figures, key.rtol * abs(value))
    share = ROUNDED * 10.0**(FIGURES[0] - figures)
    return Band(figures, max(share * abs(value), half_a_unit(value, figures)))
