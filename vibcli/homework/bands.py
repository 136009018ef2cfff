"""How far an answer may lie from its key: what rounding on the way to it does, and its own last figure."""

from math import floor, log10, sqrt

from vibcli.base.named_tuple import NamedTuple

FIGURES = 3, 4, 5       # that a sheet may ask for
ROUNDED = 0.005         # of a key, by what is rounded on the way, where no line of its solution tells it
TAIL = 2.7              # standard deviations: 993 of 1000 of a normal distribution, as errors in a variant are no draws
FLATTER = (TAIL**3 - 3 * TAIL) / 24     # by so many more for an excess kurtosis of 1 (Cornish & Fisher 1938)
SELDOM = 0.001          # of cases in which two even errors are larger together than what is allowed for them
WIDEST = 0.02           # of a key


class Band(NamedTuple):
    """An answer with so many figures may lie so far from its key, in its unit."""

    figures: int
    width: float


class KeyBand(NamedTuple):
    """What the Bands of a key hang on: the relative tolerance that the file gives, None where it gives none; Σ a, Σ a²,
    Σ a⁴ and the largest a of what lines of its solution with 3, 4 and 5 figures carry to it, relative to it, None where
    none tells it."""

    rtol: float | None
    carried: tuple[tuple[float, ...], ...] | None

    def band(self, value: float, figures: int) -> Band:
        """The Band of a key, or of what a mistake makes of it, for answers with so many figures, lines being rounded to
        as many: of independent errors, even within ±a each of a line that every other student rounds, and within ±b of
        the answer,

            σ² = Σ a²/6 + b²/3      κ σ⁴ = Σ a⁴/60 − 2 b⁴/15      |Δ| ≤ min(Σ a + b, (2.7 + 0.48 κ) σ)

        in 99 of 100 cases and more; and as half of the students round the line with the largest a, not less than what
        one of a thousand of these exceeds, a + b − √(4 ab/1000).
        """
        return Band(figures, self.width(value, figures))

    def most(self, figures: int) -> float:
        """No band is wider, relative to what it is of."""
        last = 0.5 * 10.0**(1 - figures)
        if self.rtol is not None:
            return self.rtol
        return last + (ROUNDED * 10.0**(FIGURES[0] - figures) if self.carried is None else
                       self.carried[FIGURES.index(figures)][0])

    def width(self, value: float, figures: int) -> float:
        """That of the Band."""
        if self.rtol is not None:
            return self.rtol * abs(value)
        last, finer = half_a_unit(value, figures), 10.0**(FIGURES[0] - figures)
        if self.carried is None:
            return ROUNDED * finer * abs(value) + last
        size, (total, squares, fourths, most) = abs(value), self.carried[FIGURES.index(figures)]
        total, squares, fourths, most = total * size, squares * size**2, fourths * size**4, most * size
        variance = squares / 6 + last**2 / 3
        kurtosis = (fourths / 60 - 2 * last**4 / 15) / variance**2 if variance else 0.0
        least = most + last - 2 * sqrt(SELDOM * most * last)
        return min(total + last, max(least, (TAIL + FLATTER * kurtosis) * sqrt(variance)))


def half_a_unit(value: float, figures: int) -> float:
    """Half a unit of the last figure of a value that is written with so many."""
    return 0.5 * 10.0**(floor(log10(abs(value))) - figures + 1) if value else 0.0
