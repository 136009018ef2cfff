"""The arithmetic of Python floats for expressions."""

import math
from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.symbolic import discontinuous_functions
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    import mpmath

    from vibcli.symbolic.defined_functions import DefinedFunction
    from vibcli.symbolic.sampled_functions import Samples

UNDEFINED = ValueError, OverflowError, ZeroDivisionError      # what functions of floats raise where they have no value
ELEMENTARY = ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "log")


def sign(x: float) -> int:
    return 1 if x > 0 else -1 if x < 0 else 0       # truths of NumPy cannot be subtracted


def _guarded(function: Callable[..., Any]) -> Callable[..., float]:
    def call(*args: float) -> float:
        try:
            value = function(*args)
        except UNDEFINED:
            return math.nan
        return math.nan if isinstance(value, complex) else value
    return call


class Floats:
    """Python floats. What has no value there (√−1, log 0, overflow, a rational too small) is NaN, for the caller to
    refuse."""

    pi, ordered = math.pi, True
    functions: dict[str, Callable[..., Any]] = {
        **{name: _guarded(getattr(math, name)) for name in ELEMENTARY},
        "abs": abs, "sign": sign, "min": min, "max": max, "power": _guarded(lambda b, e: b**e),
        **{name: _guarded(f) for name, f in discontinuous_functions.on(math.pi, math.floor).items()}}

    @staticmethod
    def number(value: Fraction | int) -> float:
        try:
            found = value.numerator / value.denominator
        except OverflowError:
            return math.nan
        return found if found or not value else math.nan

    @staticmethod
    def power(base: float, exponent: Fraction | int) -> float:
        try:
            if exponent.denominator == 1:
                return base**exponent.numerator
            if exponent == HALF:
                return math.sqrt(base)
            return base ** (exponent.numerator / exponent.denominator) if base >= 0 else math.nan
        except UNDEFINED:
            return math.nan

    @staticmethod
    def isfinite(value: float) -> bool:
        return -math.inf < value < math.inf

    @staticmethod
    def record(name: str, samples: "Samples") -> Callable[..., float]:
        return samples.at

    @staticmethod
    def called(function: "DefinedFunction") -> "Callable[..., float | mpmath.mpf]":
        return function.at
