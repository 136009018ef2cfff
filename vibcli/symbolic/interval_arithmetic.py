"""Interval arithmetic on arrays: every result holds all values that a function takes on its arguments.

Bounds are rounded outwards by more than the error of NumPy's functions. What is undefined somewhere on an interval
may be any number there: such bounds prove nothing, but nothing false.
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.defined_functions import DefinedFunction

PAD = 2.0**-50      # relative error allowed to NumPy's functions
FARTHEST = 1e8      # of an angle whose turn is still known


class Interval:
    """[low, high], arrays of one shape."""

    __slots__ = ("high", "low")

    def __init__(self, low: float | np.ndarray, high: float | np.ndarray) -> None:
        unknown = np.isnan(low) | np.isnan(high)
        if unknown.any():
            low, high = np.where(unknown, -np.inf, low), np.where(unknown, np.inf, high)
        self.low, self.high = low, high

    def __add__(self, other: "Interval") -> "Interval":
        return outward(self.low + other.low, self.high + other.high)

    def __sub__(self, other: "Interval") -> "Interval":
        return outward(self.low - other.high, self.high - other.low)

    def __mul__(self, other: "Interval") -> "Interval":
        with np.errstate(invalid="ignore", over="ignore"):
            a, b, c, d = (one * two for one in (self.low, self.high) for two in (other.low, other.high))
        return outward(np.minimum(np.minimum(a, b), np.minimum(c, d)), np.maximum(np.maximum(a, b), np.maximum(c, d)))

    @property
    def size(self) -> float | np.ndarray:
        """The largest magnitude, of each where they are arrays."""
        return np.maximum(np.abs(self.low), np.abs(self.high))

    def holds_zero(self) -> bool | np.ndarray:
        return (self.low <= 0) & (self.high >= 0)


def outward(low: float | np.ndarray, high: float | np.ndarray) -> Interval:
    return Interval(np.nextafter(low, -np.inf), np.nextafter(high, np.inf))


def padded(low: float | np.ndarray, high: float | np.ndarray, least: float = -np.inf, most: float = np.inf) -> Interval:
    """An interval widened by the error of a function, whose values lie between `least` and `most`."""
    return Interval(np.maximum(np.nextafter(low - PAD * np.abs(low), -np.inf), least),
                    np.minimum(np.nextafter(high + PAD * np.abs(high), np.inf), most))


def exact(value: float | np.ndarray) -> Interval:
    value = np.asarray(value, dtype=float)
    return Interval(value, value)


def _known(where: bool | np.ndarray, found: Interval) -> Interval:
    """An interval where it is known, else any number."""
    return Interval(np.where(where, found.low, -np.inf), np.where(where, found.high, np.inf))


def inverse(u: Interval) -> Interval:
    """1/u, without a bound on the side of 0 where that is an end, and without any where it lies within."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        low, high = 1 / u.high, 1 / u.low
    low, high = np.where(u.high == 0, -np.inf, low), np.where(u.low == 0, np.inf, high)
    return _known(((u.low >= 0) | (u.high <= 0)) & (u.low < u.high) | (u.low == u.high) & (u.low != 0),
                  outward(low, high))


def _whole(u: Interval, n: int) -> Interval:
    """uⁿ for n = 1, 2, …"""
    with np.errstate(over="ignore"):
        low, high = np.power(u.low, n), np.power(u.high, n)
    if n % 2:
        return padded(low, high)
    least = np.where(u.holds_zero(), 0.0, np.minimum(low, high))
    return padded(least, np.maximum(low, high), 0.0)


def _power(u: Interval, exponent: "Fraction | int") -> Interval:
    """u to a rational power."""
    if exponent < 0:
        return inverse(_power(u, -exponent))
    if exponent.denominator == 1:
        return _whole(u, int(exponent))
    with np.errstate(invalid="ignore", over="ignore"):
        low, high = ((np.sqrt(end) if exponent == HALF else np.power(end, float(exponent))) for end in (u.low, u.high))
    wider = PAD * (1 + np.abs(np.log(np.maximum(u.high, 1e-300))))     # of a power that is rounded itself
    return _known(u.low >= 0, padded(low - wider * np.abs(low), high + wider * np.abs(high), 0.0))


def _rising(function: Callable[..., Any], least: float = -np.inf, most: float = np.inf, low: float = -np.inf,
            high: float = np.inf) -> Callable[[Interval], Interval]:
    """A rising function, defined from `low` to `high`, with values from `least` to `most`."""
    def call(u: Interval) -> Interval:
        with np.errstate(all="ignore"):
            found = padded(function(u.low), function(u.high), least, most)
        return _known((u.low >= low) & (u.high <= high), found)
    return call


def _cos(u: Interval) -> Interval:
    """The cosine is ±1 where a multiple of π, even or odd, lies within, or nearly so."""
    near = PAD * (4 + u.size)
    first, last = np.ceil((u.low - near) / np.pi - PAD), np.floor((u.high + near) / np.pi + PAD)
    count, even = last - first + 1, np.mod(first, 2) == 0
    top, bottom = (count >= 2) | ((count == 1) & even), (count >= 2) | ((count == 1) & ~even)
    with np.errstate(invalid="ignore"):
        a, b = np.cos(u.low), np.cos(u.high)
    found = Interval(np.where(bottom, -1.0, np.maximum(np.minimum(a, b) - PAD, -1.0)),
                     np.where(top, 1.0, np.minimum(np.maximum(a, b) + PAD, 1.0)))
    known = u.size < FARTHEST
    return Interval(np.where(known, found.low, -1.0), np.where(known, found.high, 1.0))


def _sin(u: Interval) -> Interval:
    return _cos(u - Intervals.pi * exact(0.5))


def _cosh(u: Interval) -> Interval:
    with np.errstate(over="ignore"):
        a, b = np.cosh(u.low), np.cosh(u.high)
    return padded(np.where(u.holds_zero(), 1.0, np.minimum(a, b)), np.maximum(a, b), 1.0)


def _acos(u: Interval) -> Interval:
    turned = _rising(np.arcsin, low=-1.0, high=1.0)(u)
    return Intervals.pi * exact(0.5) - turned


def _abs(u: Interval) -> Interval:
    return Interval(np.where(u.holds_zero(), 0.0, np.minimum(np.abs(u.low), np.abs(u.high))), u.size)


def _sign(u: Interval) -> Interval:
    return Interval(np.where(u.low > 0, 1.0, np.where((u.low == 0) & (u.high == 0), 0.0, -1.0)),
                    np.where(u.high < 0, -1.0, np.where((u.low == 0) & (u.high == 0), 0.0, 1.0)))


def _step(u: Interval) -> Interval:
    return Interval(np.where(u.low >= 0, 1.0, 0.0), np.where(u.high >= 0, 1.0, 0.0))


class Intervals:
    """The arithmetic of `evaluate`; functions that are missing here raise KeyError."""

    pi = outward(np.asarray(np.pi), np.asarray(np.pi))

    @staticmethod
    def number(value: "Fraction | int") -> Interval:
        found = value.numerator / value.denominator
        return exact(found) if found == value else outward(np.asarray(found), np.asarray(found))

    power = staticmethod(_power)

    @staticmethod
    def record(name: str, samples: Sequence[dict[str, float]]) -> None:
        raise KeyError(name)

    @staticmethod
    def called(function: "DefinedFunction") -> None:
        raise KeyError(function.name)

    functions: dict[str, Callable[..., Any]] = {
        "sin": _sin, "cos": _cos, "tan": lambda u: _sin(u) * inverse(_cos(u)), "cosh": _cosh, "acos": _acos,
        "asin": _rising(np.arcsin, low=-1.0, high=1.0), "atan": _rising(np.arctan), "sinh": _rising(np.sinh),
        "tanh": _rising(np.tanh, -1.0, 1.0), "exp": _rising(np.exp, 0.0),
        "log": _rising(np.log, low=np.nextafter(0.0, 1.0)), "abs": _abs, "sign": _sign, "step": _step,
        "min": lambda u, v: Interval(np.minimum(u.low, v.low), np.minimum(u.high, v.high)),
        "max": lambda u, v: Interval(np.maximum(u.low, v.low), np.maximum(u.high, v.high)),
        "ramp": lambda u: Interval(np.maximum(u.low, 0.0), np.maximum(u.high, 0.0))}
