"""Points and weights of rules for ∫₀¹ f dr as rationals, good to sixty digits.

Gauss's: exact for polynomials of the degree 2n − 1. Of ends at which f is no power series: r = 1/(1 + e^{−π sinh t}) in
equal steps of t (tanh-sinh, Takahasi and Mori 1974).
"""

from fractions import Fraction
from functools import cache
from math import cos, pi
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import mpmath


Points = tuple[tuple[Fraction, Fraction], ...]      # ((r, weight), …)
BITS = 208              # behind the point
STEP, REACH = 16, 67    # points of tanh-sinh at t = k/STEP, |k| <= REACH


@cache
def gauss_points(n: int) -> Points:
    """((r, weight), …) on 0 … 1, n even, from left to right."""
    found = []
    for k in range(n // 2):
        x = Fraction(cos(pi * (k + 0.75) / (n + 0.5)))
        for _ in range(6):
            value, slope = _legendre(n, x)
            x = _short(x - value / slope)
        slope = _legendre(n, x)[1]
        found.append((x, _short(1 / ((1 - x * x) * slope * slope))))
    left = [((1 - x) / 2, w) for x, w in found]
    return (*left, *((1 - r, w) for r, w in reversed(left)))


@cache
def ends_apart() -> Points:
    """((r, weight), …) of tanh-sinh; every second of them, with twice the weight, is a rule too."""
    import mpmath

    found = []
    with mpmath.workdps(80):
        for k in range(-REACH, REACH + 1):
            t = mpmath.mpf(k) / STEP
            grown = mpmath.exp(-mpmath.pi * mpmath.sinh(t))
            r, other = 1 / (1 + grown), grown / (1 + grown)
            weight = mpmath.pi * mpmath.cosh(t) * r * other / STEP
            found.append((_rational(r), _rational(weight)))
    return tuple(found)


def _rational(x: "mpmath.mpf") -> Fraction:
    return Fraction(int(x * 2**BITS), 2**BITS)


def _legendre(n: int, x: Fraction) -> tuple[Fraction, Fraction]:
    """Pₙ and its slope."""
    before, value = Fraction(1), x
    for k in range(2, n + 1):
        before, value = value, _short(((2 * k - 1) * x * value - (k - 1) * before) / k)
    return value, n * (before - x * value) / (1 - x * x)


def _short(x: Fraction) -> Fraction:
    return Fraction(x.numerator * 2**BITS // x.denominator, 2**BITS)
