"""Dual numbers v + d·ε, ε² = 0: the value of an expression and its derivative by one parameter, in one evaluation.

Forward-mode automatic differentiation over any arithmetic of evaluate.py. What does not depend on the parameter stays
a plain number of that arithmetic, so a Dual is met only where there is a derivative.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.evaluation import FunctionsWhenAsked
from vibcli.symbolic.rationals import HALF, ONE

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath

    from vibcli.symbolic.defined_functions import DefinedFunction
    from vibcli.symbolic.floats import Floats


class Dual:
    """value + slope·ε. `abs` is the magnitude of each part, as the sizes of sums need it; |v| itself is a function."""

    __slots__ = ("slope", "value")

    def __init__(self, value: "float | mpmath.mpc | mpmath.mpf", slope: "float | mpmath.mpc | mpmath.mpf") -> None:
        self.value, self.slope = value, slope

    def __add__(self, other: "int | mpmath.mpf | Dual") -> "mpmath.mpf | Dual":
        if other.__class__ is Dual:
            return dual(self.value + other.value, self.slope + other.slope)
        return Dual(self.value + other, self.slope)

    def __mul__(self, other: "mpmath.mpf | Dual") -> "mpmath.mpf | Dual":
        if other.__class__ is Dual:
            return dual(self.value * other.value, self.value * other.slope + self.slope * other.value)
        return dual(self.value * other, self.slope * other)

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self) -> "Dual":
        return Dual(-self.value, -self.slope)

    def __sub__(self, other: Any) -> "mpmath.mpf | Dual":
        return self + -other

    def __rsub__(self, other: Any) -> "mpmath.mpf | Dual":
        return -self + other

    def __abs__(self) -> "Dual":
        return Dual(abs(self.value), abs(self.slope))

    def __bool__(self) -> bool:
        return bool(self.value) or bool(self.slope)


def dual(value: "float | mpmath.mpc | mpmath.mpf", slope: "float | mpmath.mpc | mpmath.mpf") -> "mpmath.mpf | Dual":
    """The dual number, or the plain one where the slope is exactly zero."""
    return Dual(value, slope) if slope else value


def value(x: "mpmath.mpf | Dual") -> "float | mpmath.mpf":
    return x.value if x.__class__ is Dual else x


def slope(x: "int | mpmath.mpf | Dual") -> "float | mpmath.mpf":
    return x.slope if x.__class__ is Dual else 0


class Duals:
    """The arithmetic of dual numbers over the numbers of another one."""

    ordered = False

    def __init__(self, inner: Any) -> None:
        self.inner, self.number, self.pi = inner, inner.number, inner.pi
        self.functions = FunctionsWhenAsked(self._function)

    def power(self, base: "mpmath.mpf | Dual", exponent: "Fraction | int") -> "mpmath.mpf | Dual":
        if base.__class__ is not Dual:
            return self.inner.power(base, exponent)
        steep = self.number(exponent) * self.inner.power(base.value, exponent - ONE)
        return dual(self.inner.power(base.value, exponent), steep * base.slope)

    def record(self, name: str, samples: Any) -> Callable[..., Any]:
        plain = self.inner.record(name, samples)

        def at(u: Any, order: int) -> Any:
            return dual(plain(value(u), order), plain(value(u), order + 1) * slope(u))
        return at

    def called(self, function: "DefinedFunction") -> Callable[..., Dual]:
        from vibcli.symbolic.defined_functions import slopes_at

        plain = self.inner.called(function)

        def at(*args: "Dual | float") -> Dual:
            values, moving = [value(x) for x in args], [i for i, x in enumerate(args) if x.__class__ is Dual]
            steep = slopes_at(function, self.inner, values, moving)
            return dual(plain(*values), sum(by * slope(args[i]) for by, i in zip(steep, moving, strict=True)))
        return at

    def _function(self, name: str) -> Callable[..., Dual | float]:
        plain, slopes = self.inner.functions[name], _SLOPES[name]

        def call(*args: "Dual | float") -> "Dual | float":
            values = [value(x) for x in args]
            found: Dual | float = plain(*values)
            if not any(x.__class__ is Dual for x in args):
                return found
            outer = slopes(self.inner, found, *values)
            return dual(found, sum(by * slope(x) for by, x in zip(outer, args, strict=True) if slope(x)))
        return call


def _arc(inner: "type[Floats]", x: float) -> float:
    return inner.power(1 - x * x, -HALF)


def _extreme(direction: int) -> "Callable[[type[Floats], float, float, float], tuple[float, float]]":
    def slopes(inner: "type[Floats]", y: float, a: float, b: float) -> "tuple[float, float]":
        step = direction * inner.functions["sign"](a - b)
        return (1 + step) / 2, (1 - step) / 2
    return slopes


def _power(inner: Any, y: Any, base: Any, exponent: Any) -> tuple[Any, Any]:
    by_base = exponent * inner.functions["power"](base, exponent - 1)
    return by_base, y * inner.functions["log"](base) if base else 0


# the derivatives of f at x, y being f(x): by each argument
_SLOPES: dict[str, Callable[..., tuple[Any, ...]]] = {
    "sin": lambda inner, y, x: (inner.functions["cos"](x),),
    "cos": lambda inner, y, x: (-inner.functions["sin"](x),),
    "tan": lambda inner, y, x: (1 + y * y,),
    "asin": lambda inner, y, x: (_arc(inner, x),),
    "acos": lambda inner, y, x: (-_arc(inner, x),),
    "atan": lambda inner, y, x: (1 / (1 + x * x),),
    "atan2": lambda inner, z, y, x: (x / (x * x + y * y), -y / (x * x + y * y)),
    "sinh": lambda inner, y, x: (inner.functions["cosh"](x),),
    "cosh": lambda inner, y, x: (inner.functions["sinh"](x),),
    "tanh": lambda inner, y, x: (1 - y * y,),
    "exp": lambda inner, y, x: (y,),
    "log": lambda inner, y, x: (1 / x,),
    "abs": lambda inner, y, x: (inner.functions["sign"](x),),
    "sign": lambda inner, y, x: (0,),
    "step": lambda inner, y, x: (0,),
    "ramp": lambda inner, y, x: (inner.functions["step"](x),),
    "impulse": lambda inner, y, *args: (0,) * len(args),
    "square": lambda inner, y, *args: (0,) * len(args),
    "sawtooth": lambda inner, y, x, *order: (0, 0) if order else (inner.functions["sawtooth"](x, 1),),
    "min": _extreme(-1),
    "max": _extreme(1),
    "power": _power,
}
