"""Functions of one variable that are, between places where they bend or jump, sums of its powers times exponentials,

    f(t) = Σ c tᵖ e^{λt},        ∫₀^∞ f e^{−st} dt = Σ c p!/(s − λ)ᵖ⁺¹,

in complex numbers of mpmath: what sums, products, powers, sines, steps and the like of such functions are.
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from math import comb, factorial
from typing import TYPE_CHECKING, Any, cast

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.symbolic.node import Node

BENT = ("abs", "min", "max", "ramp", "sign", "step", "square")
SAME = 20               # digits to which two places are one
MOST = 400              # half turns of square waves
REFUSED = "a reference in time is found of what sums, products, sines, exponentials and steps are made of alone"


def is_some(x: Any) -> bool:
    """Is a number other than zero, or one of an array?"""
    return bool(x.any() if hasattr(x, "any") else x)


class ExponentialPolynomial:
    """Σ c tᵖ e^{λt}; terms: {(λ, p): c}."""

    __slots__ = ("terms",)

    def __init__(self, terms: "Mapping[tuple[Any, int], Any]") -> None:
        self.terms = {key: c for key, c in terms.items() if is_some(c)}

    def __add__(self, other: Any) -> "ExponentialPolynomial":
        found = dict(self.terms)
        for key, c in _terms(other).items():
            found[key] = found.get(key, 0) + c
        return ExponentialPolynomial(found)

    def __mul__(self, other: Any) -> "ExponentialPolynomial":
        found: dict[tuple[Any, int], Any] = {}
        for (rate, power), c in self.terms.items():
            for (more, higher), d in _terms(other).items():
                key = rate + more, power + higher
                found[key] = found.get(key, 0) + c * d
        return ExponentialPolynomial(found)

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self) -> "ExponentialPolynomial":
        return self * -1

    def __sub__(self, other: Any) -> "ExponentialPolynomial":
        return cast("ExponentialPolynomial", self + -1 * other)

    def __rsub__(self, other: Any) -> "ExponentialPolynomial":
        return cast("ExponentialPolynomial", -self + other)

    def at(self, t: Any) -> Any:
        """Its value at a place, a real number."""
        return mpmath.re(mpmath.fsum(c * t**power * mpmath.exp(rate * t) for (rate, power), c in self.terms.items()))

    def from_(self, start: Any) -> "ExponentialPolynomial":
        """The same counted from a place: f(start + t)."""
        return sum((ExponentialPolynomial({(rate, k): c * mpmath.exp(rate * start) * comb(power, k) * start**(power - k)
                                           for k in range(power + 1)}) for (rate, power), c in self.terms.items()),
                   NOTHING)

    def rate(self) -> "ExponentialPolynomial":
        """f′"""
        return sum((ExponentialPolynomial({(rate, power): c * rate, (rate, power - 1): c * power})
                    for (rate, power), c in self.terms.items()), NOTHING)

    def in_floats(self) -> "ExponentialPolynomial":
        """The same in complex numbers of Python."""
        return ExponentialPolynomial({(complex(rate), power): complex(c) for (rate, power), c in self.terms.items()})

    def image(self, s: Any) -> Any:
        """Its Laplace transform."""
        return sum(c * factorial(power) / (s - rate) ** (power + 1) for (rate, power), c in self.terms.items())

    def line(self) -> tuple[Any, Any]:
        """(a, b) of a + b t; PhysicsError of what is none."""
        zero = mpmath.mpc(0)
        if any(key not in ((zero, 0), (zero, 1)) for key in self.terms):
            raise PhysicsError(REFUSED)
        return self.terms.get((zero, 0), zero), self.terms.get((zero, 1), zero)


NOTHING = ExponentialPolynomial({})


def _terms(x: Any) -> dict[tuple[Any, int], Any]:
    if isinstance(x, ExponentialPolynomial):
        return x.terms
    return {(0j, 0): x} if hasattr(x, "dtype") else {(mpmath.mpc(0), 0): mpmath.mpc(x)}


class EvenStretch(NamedTuple):
    """An ExponentialPolynomial of the variable between two places, the last None where it goes on."""

    start: Any
    end: Any
    function: ExponentialPolynomial


def stretches(node: "Node", variable: "Node", known: "Mapping[str, Any]", end: Any = None) -> list[EvenStretch]:
    """A function of a variable from 0 on, or up to an end; known: {name: number} of all else."""
    places = [mpmath.mpf(0)]
    for place in sorted([*_bends(node, variable, known, end), *([] if end is None else [end])]):
        if place > places[-1] + _near(places[-1], place) and (end is None or place <= end + _near(end, end)):
            places.append(place)
    inner = [EvenStretch(a, b, _between(node, variable, known, (a + b) / 2)) for a, b in pairwise(places)]
    last = [EvenStretch(places[-1], None, _between(node, variable, known, places[-1] + 1 + abs(places[-1])))]
    return inner + (last if end is None else [])


def _near(a: mpmath.mpf, b: mpmath.mpf) -> mpmath.mpf:
    return mpmath.mpf(10) ** -SAME * max(abs(a), abs(b))


def _between(node: "Node", variable: "Node", known: "Mapping[str, float | mpmath.mpf]",
             place: mpmath.mpf | None) -> ExponentialPolynomial:
    """The function about a place."""
    found, = evaluate([node], _About(place), {**known, variable.name: ExponentialPolynomial({(mpmath.mpc(0), 1): 1})})
    return found if isinstance(found, ExponentialPolynomial) else ExponentialPolynomial(_terms(found))


def _bends(node: "Node", variable: "Node", known: "Mapping[str, Any]", end: mpmath.mpf) -> Iterator[mpmath.mpf]:
    """Where a function may bend or jump."""
    for part in reachable([node]):
        if part.op == "call" and part.mask & variable.mask and (part.name in BENT or part.name in part.table.records):
            if part.name not in BENT or any(inner.op == "call" and inner.name in BENT and inner.mask & variable.mask
                                            for inner in reachable(part.args)):
                raise PhysicsError(REFUSED)
            argument = part.args[0] - part.args[1] if part.name in ("min", "max") else part.args[0]
            if gradient(argument).get(variable) is not None:
                a, b = map(mpmath.re, _between(argument, variable, known, None).line())
                yield from _half_turns(a, b, end) if part.name == "square" else [-a / b] * bool(b)


def _half_turns(a: Any, b: Any, end: Any) -> list[Any]:
    if end is None:
        raise PhysicsError("of square waves a reference in time is found up to an end")
    first, last = sorted((a / mpmath.pi, (a + b * end) / mpmath.pi))
    if last - first > MOST:
        raise PhysicsError("the reference takes too long: the square wave has very many turns")
    return [(k * mpmath.pi - a) / b for k in range(int(mpmath.ceil(first)), int(mpmath.floor(last)) + 1)]


class _About:
    """The arithmetic of ExponentialPolynomials, where they bend as they are about a place."""

    ordered = False

    def __init__(self, place: Any) -> None:
        self._numbers, self._place = multiprecision(), place
        self.pi, self.number, self.record, self.called = (
            self._numbers.pi, self._numbers.number, self._numbers.record, self._numbers.called)
        self.functions = {name: self._function(name) for name in self._numbers.functions}

    def power(self, base: Any, exponent: Any) -> Any:
        if not isinstance(base, ExponentialPolynomial):
            return self._numbers.power(base, exponent)
        if exponent.denominator != 1 or exponent < 0:
            raise PhysicsError(REFUSED)
        found: Any = mpmath.mpf(1)
        for _ in range(int(exponent)):
            found = base * found
        return found

    def _function(self, name: str) -> Callable[..., Any]:
        plain = self._numbers.functions[name]

        def value(*args: Any) -> Any:
            if not any(isinstance(x, ExponentialPolynomial) for x in args):
                return plain(*args)
            if name in ("sin", "cos", "exp", "sinh", "cosh"):
                return _exponential(name, *args[0].line())
            return self._bent(name, args)

        return value

    def _bent(self, name: str, args: "Sequence[Any]") -> float:
        if name not in BENT or self._place is None:
            raise PhysicsError(REFUSED)
        here = [x.at(self._place) if isinstance(x, ExponentialPolynomial) else x for x in args]
        if name in ("min", "max"):
            return cast("float", args[here.index((min if name == "min" else max)(here))])
        if name in ("abs", "ramp"):
            return cast("float", args[0] * (mpmath.sign(here[0]) if name == "abs" else int(here[0] > 0)))
        return cast("float", self._numbers.functions[name](here[0]))


def _exponential(name: str, a: mpmath.mpc, b: mpmath.mpc) -> ExponentialPolynomial:
    """e^{a + bt}, or its sine and the like."""
    turn = 1 if name in ("exp", "sinh", "cosh") else mpmath.mpc(0, 1)
    rising = ExponentialPolynomial({(mpmath.mpc(turn * b), 0): mpmath.exp(turn * a)})
    if name == "exp":
        return rising
    falling = ExponentialPolynomial({(-mpmath.mpc(turn * b), 0): mpmath.exp(-turn * a)})
    return (rising + falling) * 0.5 if name in ("cos", "cosh") else (rising - falling) * (1 / (2 * mpmath.mpc(turn)))
