"""How far an answer may lie from its key: what rounding on the way to it does, and its own last figure."""

from math import floor, log10, sqrt
from typing import NamedTuple

FIGURES = 3, 4, 5       # that a sheet may ask for
ROUNDED = 0.005         # of a key, by what is rounded on the way, where no line of its solution tells it
TAIL = 2.576            # standard deviations: 99 of 100 of a normal distribution
WIDEST = 0.02           # of a key


class Band(NamedTuple):
    """An answer with so many figures may lie so far from its key, in its unit."""

    figures: int
    width: float


class KeyBand(NamedTuple):
    """What the Bands of a key hang on: the relative tolerance that the file gives, None where it gives none; Σ a and
    Σ a² of what lines of its solution with three figures carry to it, relative to it, None where none tells it."""

    rtol: float | None
    carried: tuple[float, float] | None

    def band(self, value: float, figures: int) -> Band:
        """The Band of a key, or of what a mistake makes of it, for answers with so many figures, lines being rounded to
        as many: of independent errors, even within ±a each,

            |Δ| ≤ min(Σ a, 2.576 √(Σ a²/3))     in 99 of 100 cases or more
        """
        return Band(figures, self.width(value, figures))

    def width(self, value: float, figures: int) -> float:
        """That of the Band."""
        if self.rtol is not None:
            return self.rtol * abs(value)
        last, finer = half_a_unit(value, figures), 10.0**(FIGURES[0] - figures)
        if self.carried is None:
            return ROUNDED * finer * abs(value) + last
        total, squares = self.carried[0] * finer * abs(value), self.carried[1] * (finer * value)**2
        return max(last, min(total + last, TAIL * sqrt((squares + last**2) / 3)))


def half_a_unit(value: float, figures: int) -> float:
    """Half a unit of the last figure of a value that is written with so many."""
    return 0.5 * 10.0**(floor(log10(abs(value))) - figures + 1) if value else 0.0
