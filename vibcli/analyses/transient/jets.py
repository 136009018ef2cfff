"""Interval arithmetic with rates: bounds of the value, slope and curvature of a function of time on stretches of it.

(f∘u)' = f'(u)·u' and (f∘u)'' = f''(u)·u'² + f'(u)·u''. At a corner the slope lies between those of its sides and the
curvature has no bound; at a jump the slope has none either.
"""

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np

from vibcli.symbolic.interval_arithmetic import Interval, Intervals, exact, inverse

if TYPE_CHECKING:
    from vibcli.symbolic.defined_functions import DefinedFunction

ONE, TWO = exact(1.0), exact(2.0)
SIN, COS, TAN, ATAN, SIGN, STEP = (Intervals.functions[name] for name in ("sin", "cos", "tan", "atan", "sign", "step"))
SINH, COSH, TANH, EXP = (Intervals.functions[name] for name in ("sinh", "cosh", "tanh", "exp"))


class Jet:
    """Intervals that hold the values, the slopes and the curvatures."""

    __slots__ = ("curvature", "slope", "value")

    def __init__(self, value: Interval, slope: Interval | None = None, curvature: Interval | None = None) -> None:
        self.value, self.slope, self.curvature = value, slope or exact(0.0), curvature or exact(0.0)

    def __add__(self, other: "Jet") -> "Jet":
        return Jet(_kept(self.value + other.value, self.value, other.value), self.slope + other.slope,
                   self.curvature + other.curvature)

    def __mul__(self, other: "Jet") -> "Jet":
        return Jet(_kept(self.value * other.value, self.value, other.value),
                   self.slope * other.value + self.value * other.slope,
                   self.curvature * other.value + TWO * self.slope * other.slope + self.value * other.curvature)

    def through(self, value: Interval, first: Interval, second: Interval) -> "Jet":
        """f(u) with the bounds of f, f' and f'' on u."""
        return Jet(value, first * self.slope, second * self.slope * self.slope + first * self.curvature)


def _kept(found: Interval, one: Interval, other: Interval) -> Interval:
    """A sum or product of what is nowhere negative is not, either."""
    return Interval(np.where((one.low >= 0) & (other.low >= 0), np.maximum(found.low, 0.0), found.low), found.high)


def unbounded(where: bool | np.ndarray, found: Interval) -> Interval:
    """The interval, any number where it has no bound."""
    return Interval(np.where(where, -np.inf, found.low), np.where(where, np.inf, found.high))


def _smooth(rule: Callable[..., Any]) -> Callable[..., Jet]:
    return lambda u: u.through(*rule(u.value))


def _tan(u: Interval) -> tuple[Interval, Interval, Interval]:
    t = TAN(u)
    first = ONE + t * t
    return t, first, TWO * t * first


def _tanh(u: Interval) -> tuple[Interval, Interval, Interval]:
    t = TANH(u)
    first = ONE - t * t
    return t, first, exact(-2.0) * t * first


def _atan(u: Interval) -> tuple[Interval, Interval, Interval]:
    first = inverse(ONE + Intervals.power(u, Fraction(2)))
    return ATAN(u), first, exact(-2.0) * u * first * first


def _asin(u: Interval) -> tuple[Interval, Interval, Interval]:
    first = Intervals.power(ONE - Intervals.power(u, Fraction(2)), Fraction(-1, 2))
    return Intervals.functions["asin"](u), first, u * first * first * first


def _acos(u: Interval) -> tuple[Interval, Interval, Interval]:
    _, first, second = _asin(u)
    return Intervals.functions["acos"](u), exact(-1.0) * first, exact(-1.0) * second


def _log(u: Interval) -> tuple[Interval, Interval, Interval]:
    first = inverse(u)
    return Intervals.functions["log"](u), first, exact(-1.0) * first * first


def _jumping(u: Jet, value: Interval, jumps: np.ndarray) -> Jet:
    """A function that is constant between its jumps."""
    none = exact(np.zeros(np.shape(jumps)))
    return Jet(value, unbounded(jumps, none), unbounded(jumps, none))


def _cornered(function: Callable[..., Interval], slope: Callable[[Interval], Interval]) -> Callable[[Jet], Jet]:
    """A function with a corner at 0."""
    def call(u: Jet) -> Jet:
        first, corner = slope(u.value), u.value.holds_zero()
        return Jet(function(u.value), first * u.slope, unbounded(corner, first * u.curvature))
    return call


def _turns(u: Interval, length: float) -> tuple[np.ndarray, np.ndarray]:
    """Which stretches may hold a multiple of a length, and the multiples below their ends."""
    near = 2.0**-46 * (1 + u.size)
    first, last = np.floor((u.low - near) / length), np.floor((u.high + near) / length)
    return first != last, first


def _square(u: Jet, order: int | None = None) -> Jet:
    jumps, below = _turns(u.value, np.pi)
    sign = np.where(np.mod(below, 2) == 0, 1.0, -1.0)
    value = Interval(np.where(jumps, -1.0, sign), np.where(jumps, 1.0, sign))
    return _jumping(u, value if order is None else unbounded(jumps, exact(0.0 * sign)), jumps)


def _sawtooth(u: Jet) -> Jet:
    jumps, below = _turns(u.value, math.tau)
    inside = u.value * inverse(Intervals.pi) + exact(-2 * below - 1)
    value = Interval(np.where(jumps, -1.0, inside.low), np.where(jumps, 1.0, inside.high))
    first = inverse(Intervals.pi)
    return Jet(value, unbounded(jumps, first * u.slope), unbounded(jumps, first * u.curvature))


def _least(sense: int) -> Callable[[Jet, Jet], Jet]:
    """min (sense −1) or max (1) of two."""
    def call(u: Jet, v: Jet) -> Jet:
        apart = u + Jets.number(Fraction(-1)) * v
        first = apart.value.low > 0 if sense > 0 else apart.value.high < 0
        second = apart.value.high < 0 if sense > 0 else apart.value.low > 0
        either = np.logical_not(first) & np.logical_not(second)

        def of(one: Interval, other: Interval) -> Interval:
            return Interval(np.where(first, one.low, np.where(second, other.low, np.minimum(one.low, other.low))),
                            np.where(first, one.high, np.where(second, other.high, np.maximum(one.high, other.high))))
        value = Intervals.functions["max" if sense > 0 else "min"](u.value, v.value)
        return Jet(value, of(u.slope, v.slope), unbounded(either, of(u.curvature, v.curvature)))
    return call


def _power(base: Jet, exponent: Fraction | int) -> Jet:
    p = Fraction(exponent)

    def of(n: Fraction) -> Interval:
        return ONE if n == 0 else base.value if n == 1 else Intervals.power(base.value, n)
    second = exact(0.0) if p == 1 else Intervals.number(p * (p - 1)) * of(p - 2)
    return base.through(of(p), Intervals.number(p) * of(p - 1), second)


class Jets:
    """The arithmetic of `evaluate`; functions that are missing here raise KeyError."""

    pi = Jet(Intervals.pi)
    power = staticmethod(_power)

    @staticmethod
    def number(value: Fraction | int) -> Jet:
        return Jet(Intervals.number(value))

    @staticmethod
    def record(name: str, samples: Sequence[dict[str, float]]) -> NoReturn:
        raise KeyError(name)

    @staticmethod
    def called(function: "DefinedFunction") -> NoReturn:
        raise KeyError(function.name)

    functions: dict[str, Callable[..., Jet]] = {
        "sin": _smooth(lambda u: (SIN(u), COS(u), exact(-1.0) * SIN(u))),
        "cos": _smooth(lambda u: (COS(u), exact(-1.0) * SIN(u), exact(-1.0) * COS(u))),
        "tan": _smooth(_tan), "asin": _smooth(_asin), "acos": _smooth(_acos), "atan": _smooth(_atan),
        "sinh": _smooth(lambda u: (SINH(u), COSH(u), SINH(u))), "cosh": _smooth(lambda u: (COSH(u), SINH(u), COSH(u))),
        "tanh": _smooth(_tanh), "exp": _smooth(lambda u: (EXP(u),) * 3), "log": _smooth(_log),
        "abs": _cornered(Intervals.functions["abs"], SIGN), "ramp": _cornered(Intervals.functions["ramp"], STEP),
        "sign": lambda u: _jumping(u, SIGN(u.value), u.value.holds_zero()),
        "step": lambda u: _jumping(u, STEP(u.value), u.value.holds_zero()),
        "square": _square, "sawtooth": _sawtooth, "min": _least(-1), "max": _least(1),
        "power": lambda u, v: Jets.functions["exp"](v * Jets.functions["log"](u))}
