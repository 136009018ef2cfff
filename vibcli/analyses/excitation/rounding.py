"""From exact rationals to numbers: floats, or mpmath numbers at the working precision."""

import cmath
import math
from fractions import Fraction
from numbers import Rational
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.evaluation import Floats, multiprecision
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    import mpmath

PI = Fraction(3141592653589793238462643383279502884197169399375105820974944592307816406286208998628034825342117068,
              10**99)


class Floating:
    """Python floats; phases are reduced before they are rounded."""

    arithmetic, pi, same = Floats, PI, Fraction(1, 2**46)
    number, real, complex = float, float, complex

    @staticmethod
    def exact(value: float) -> Fraction:
        return Fraction(value) if math.isfinite(value) else None

    @staticmethod
    def turned(growth: Fraction, phase: Fraction, quarters: int = 0) -> Any:
        """i^quarters e^{growth + i phase} of rationals, quarters 0 or 1."""
        phase = phase - 2 * PI * round(phase / (2 * PI)) if phase else 0
        found = cmath.rect(math.exp(growth), float(phase))
        return found * 1j if quarters else found

    @staticmethod
    def polar(size: Any) -> tuple[float, Fraction]:
        return abs(size), Fraction(cmath.phase(size))

    @staticmethod
    def arc_sine(x: float) -> Fraction:
        return Fraction(math.asin(x))


def multiprecise() -> type[Any]:
    """The same in mpmath numbers."""
    import mpmath

    with mpmath.workprec(mpmath.mp.prec + 200):
        exact_pi = fraction_of(+mpmath.mp.pi)

    class Multiple:
        arithmetic = multiprecision()
        same = Fraction(1, 2 ** (mpmath.mp.prec - 7))
        real, complex = mpmath.mpf, mpmath.mpc
        pi = exact_pi

        @staticmethod
        def number(value: "float | Fraction | mpmath.mpf") -> "float | mpmath.mpf":
            return mpmath.mpf(value.numerator) / value.denominator if isinstance(value, Rational) else value

        @staticmethod
        def exact(value: "mpmath.mpf") -> "Fraction | None":
            return fraction_of(mpmath.mpf(value)) if mpmath.isfinite(value) else None

        @classmethod
        def turned(cls, growth: Fraction, phase: Fraction, quarters: int = 0) -> "mpmath.mpc":
            phase = phase - 2 * cls.pi * round(phase / (2 * cls.pi)) if phase else 0
            found = mpmath.exp(mpmath.mpc(cls.number(growth), cls.number(phase)))
            return found * 1j if quarters else found

        @staticmethod
        def polar(size: "mpmath.mpc") -> "tuple[mpmath.mpf, Fraction]":
            return abs(size), fraction_of(mpmath.arg(size))

        @staticmethod
        def arc_sine(x: "mpmath.mpf") -> Fraction:
            return fraction_of(mpmath.asin(x))

    return Multiple
