"""Running error analysis: numbers that carry a bound of their own error (Wilkinson; Higham, Accuracy and Stability of
Numerical Algorithms, section 3.3).

    fl(x ∘ y) = (x ∘ y)(1 + δ), |δ| ≤ u     a sum passes the errors of its parts on, f passes |f′| of them on

Sums, products and powers are bounded rigorously, other functions to first order.
"""

from collections.abc import Sequence
from fractions import Fraction
from math import inf
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.evaluation import FunctionsWhenAsked

if TYPE_CHECKING:
    from collections.abc import Callable

    from vibcli.symbolic.defined_functions import DefinedFunction

UNIT = 2.0**-52     # one ulp of a float, twice the error of one operation
GENTLE = ("abs", "ramp", "min", "max")      # of which the slope is at most 1
LEAPING = ("sign", "step")                  # which jump at 0


class Rounded:
    """A number (float, complex or one of mpmath's) and an absolute bound of its error; `unit`: that of rounding."""

    __slots__ = ("error", "unit", "value")

    def __init__(self, value: Any, error: Any, unit: Any = UNIT) -> None:
        self.value, self.error, self.unit = value, error, unit

    def __add__(self, other: Any) -> "Rounded":
        value = self.value + number_in(other)
        return Rounded(value, self.error + error_in(other) + self.unit * abs(value), self.unit)

    def __mul__(self, other: Any) -> "Rounded":
        b, eb = number_in(other), error_in(other)
        value = self.value * b
        error = abs(self.value) * eb + abs(b) * self.error + self.error * eb + self.unit * abs(value)
        return Rounded(value, error, self.unit)

    __radd__, __rmul__ = __add__, __mul__

    def __abs__(self) -> "Rounded":
        return Rounded(abs(self.value), self.error, self.unit)

    def __bool__(self) -> bool:
        return bool(self.value) or bool(self.error)


def number_in(x: Any) -> Any:
    """The number without its bound."""
    return x.value if x.__class__ is Rounded else x


def error_in(x: Any) -> Any:
    """The bound; 0 of a plain number, which is exact."""
    return x.error if x.__class__ is Rounded else 0


class RunningErrors:
    """The arithmetic of Rounded numbers over the numbers of another one, whose unit of rounding is `unit`."""

    ordered = False

    def __init__(self, inner: Any, unit: Any = UNIT) -> None:
        self.inner, self.unit = inner, unit
        self._duals: Any = None
        self.pi = Rounded(inner.pi, unit * abs(inner.pi), unit)
        self.functions = FunctionsWhenAsked(self._function)

    def number(self, value: "Fraction | int") -> Rounded:
        found = self.inner.number(value)
        is_exact = value.denominator == 1 and abs(value.numerator) < 2**53
        return Rounded(found, 0 if is_exact else self.unit * abs(found), self.unit)

    def power(self, base: Any, exponent: "Fraction | int") -> Rounded:
        found, error = self.inner.power(number_in(base), exponent), error_in(base)
        rounding = 2 * self.unit * abs(found)
        return Rounded(found, rounding + self._moved(abs(number_in(base)), error, exponent) if error else rounding,
                       self.unit)

    def _moved(self, size: float, error: float, p: Fraction | int) -> float:
        """How far xᵖ moves at most while x moves by its error: by the steepest slope in between."""
        power = self.inner.power
        if p.numerator >= p.denominator:
            found: float = self.inner.number(p) * power(size + error, p - 1) * error
            return found
        if size > 2 * error:
            result: float = abs(self.inner.number(p)) * power(size - error, p - 1) * error
            return result
        return power(size + error, p) if p.numerator > 0 else inf

    def record(self, name: str, samples: Any) -> "Callable[..., Any]":
        at = self.inner.record(name, samples)

        def call(u: Any, order: int) -> Rounded:
            steep = abs(at(number_in(u), order + 1)) if error_in(u) else 0
            return Rounded(at(number_in(u), order), steep * error_in(u), self.unit)
        return call

    def called(self, function: "DefinedFunction") -> "Callable[..., Rounded]":
        from vibcli.symbolic.defined_functions import slopes_at

        plain = self.inner.called(function)

        def call(*args: Rounded) -> Rounded:
            values = [number_in(x) for x in args]
            found, error = plain(*values), 0
            for steep, x in zip(slopes_at(function, self.inner, values, range(len(args))), args, strict=True):
                error = error + abs(steep) * (error_in(x) + 4 * self.unit * abs(number_in(x)))
            error = error + function.rounding(self.unit, found, values)
            return Rounded(found, error if error == error else inf, self.unit)
        return call

    def _function(self, name: str) -> "Callable[..., Rounded]":
        plain = self.inner.functions[name]

        def call(*args: "float | Rounded") -> Rounded:
            values, errors = [number_in(x) for x in args], [error_in(x) for x in args]
            found = plain(*values)
            if name in GENTLE:
                return Rounded(found, _felt(name, values, errors), self.unit)
            error = 2 * self.unit * abs(found)
            for i, own in enumerate(errors):
                if own:
                    error = error + abs(self._slope(name, values, i)) * own
            leaps = name in LEAPING and abs(values[0]) <= errors[0] and errors[0]
            return Rounded(found, inf if leaps else error, self.unit)
        return call

    def _slope(self, name: str, values: Sequence[float], i: int) -> float:
        """∂f/∂xᵢ at the values of its arguments."""
        from vibcli.symbolic.dual_numbers import Dual, Duals, slope

        self._duals = self._duals or Duals(self.inner)
        return slope(self._duals.functions[name](*[Dual(x, 1) if i == j else x for j, x in enumerate(values)]))


def _felt(name: str, values: list[float], errors: list[float]) -> float:
    """The error of a GENTLE function: of min, max and ramp that of what may be the smallest or largest."""
    if name == "abs":
        return errors[0]
    if name == "ramp":
        values, errors = [*values, 0], [*errors, 0]
    least = -inf
    sides = [-x if name == "min" else x for x in values]
    for x, error in zip(sides, errors, strict=True):
        least = max(least, x - error)
    return max(error for x, error in zip(sides, errors, strict=True) if not x + error < least)
