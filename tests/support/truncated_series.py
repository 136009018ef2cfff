"""Taylor series of spring energies by SymPy's series in rings, to 60 digits; nothing of the package is used.

A place (X + x, Y + y) from (px, py) is l √(1 + w) away, w = (2 (X − px) x + 2 (Y − py) y + x² + y²)/l². All
variables are multiplied by one further, by whose powers the series are cut off.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from sympy import RealField, ring
from sympy.polys.ring_series import rs_nth_root, rs_trunc

FIELD = RealField(200)


def exact(value: float) -> Any:
    """A number as it is written in decimals."""
    fraction = Fraction(repr(value))
    return FIELD(fraction.numerator) / FIELD(fraction.denominator)


class Taylor:
    """Series in some variables about zero, up to an order."""

    def __init__(self, names: Sequence[str], order: int):
        self.ring, *self.variables, self.small = ring([*names, "small"], FIELD)
        self.order = order

    def moving(self, i: int) -> Any:
        """One of the variables."""
        return self.variables[i] * self.small

    def constant(self, series: Any) -> Any:
        """Its value at zero."""
        return series.coeff(1)

    def cut(self, series: Any) -> Any:
        """Without what is of a higher order."""
        return rs_trunc(series, self.small, self.order + 1)

    def root(self, square: Any) -> Any:
        """√ of a series with a positive constant."""
        constant = square.coeff(1)
        return rs_nth_root(square * (1 / constant), 2, self.small, self.order + 1) * constant ** FIELD(0.5)

    def composed(self, coefficients: Sequence[Any], series: Any) -> Any:
        """Σ cₙ sⁿ."""
        found = self.ring(0)
        for c in reversed(coefficients):
            found = self.cut(found * series) + FIELD(c)
        return found

    def first(self, series: Any) -> Any:
        """What is constant or of the first order."""
        return rs_trunc(series, self.small, 2)

    def coefficients(self, series: Any) -> dict[tuple[int, ...], Any]:
        """{powers of the variables: coefficient}."""
        return {powers[:-1]: c for powers, c in series.items()}

    def terms(self, series: Any, least: float = 0.0) -> dict[tuple[int, ...], float]:
        """{powers: coefficient} but for the constant and what is not above `least` of the largest."""
        found = {powers: float(c) for powers, c in self.coefficients(series).items() if any(powers)}
        largest = max(map(abs, found.values()), default=0.0)
        return {powers: c for powers, c in found.items() if abs(c) > least * largest}


