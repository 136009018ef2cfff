"""Truncated polynomials in several variables: an expression evaluated over them gives its Taylor expansion.

    (Σ aᵢ xⁱ)(Σ bⱼ xʲ) = Σ aᵢ bⱼ xⁱ⁺ʲ        f(u₀ + w) = Σ f⁽ᵏ⁾(u₀) wᵏ/k!        (u₀ + w)ᵉ = Σ (e over k) u₀ᵉ⁻ᵏ wᵏ

(Griewank & Walther, Evaluating Derivatives, 2008, chapter 13). Coefficients are numbers of an inner arithmetic, those
of running errors or of nodes among them; `keep` says which powers are kept.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from itertools import product as all_of
from math import factorial
from typing import Any

from vibcli.base.errors import NotInLetters
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import FunctionsWhenAsked, evaluate
from vibcli.symbolic.expression import Table
from vibcli.symbolic.node import Node
from vibcli.symbolic.running_errors import error_in, number_in

Powers = tuple[int, ...]


class NoDerivative(ArithmeticError):
    """A function has no derivative of the order that is wanted at the place; `name`: of the function, "power" of a
    root."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.name = name


class Polynomial:
    """{powers: coefficient} of what is kept."""

    __slots__ = ("ring", "terms")

    def __init__(self, ring: "Polynomials", terms: Mapping[Powers, Any]) -> None:
        self.ring, self.terms = ring, terms

    def __add__(self, other: "Polynomial") -> "Polynomial":
        terms = dict(self.terms)
        for powers, c in other.terms.items():
            terms[powers] = terms[powers] + c if powers in terms else c
        return Polynomial(self.ring, terms)

    def __mul__(self, other: "Polynomial") -> "Polynomial":
        sums, terms = self.ring.sums, {}
        for i, a in self.terms.items():
            for j, b in other.terms.items():
                powers = sums(i, j)
                if powers is not None:
                    terms[powers] = terms[powers] + a * b if powers in terms else a * b
        return Polynomial(self.ring, terms)

    def scaled(self, factor: Any) -> "Polynomial":
        """factor·polynomial, the factor of the inner arithmetic."""
        return Polynomial(self.ring, {powers: c * factor for powers, c in self.terms.items()})

    @property
    def constant(self) -> Any:
        """The value at the place of the expansion."""
        return self.terms.get(self.ring.none, self.ring.inner.number(0))

    @property
    def moving(self) -> "Polynomial":
        """What is left without the constant."""
        return Polynomial(self.ring, {powers: c for powers, c in self.terms.items() if any(powers)})


class Polynomials:
    """The arithmetic of polynomials in `count` variables. `side(u)`: −1 or 1, the sign of a coefficient, 0 where it
    vanishes or only rounding is left of it, None where nothing tells."""

    ordered = False

    def __init__(self, inner: Any, count: int, keep: Callable[[Powers], bool], order: int,
                 side: Callable[[Any], int | None] | None = None) -> None:
        self.inner, self.count, self.keep, self.order = inner, count, keep, order
        self.none, self.side = (0,) * count, side or sign
        self._sums: dict[tuple[Powers, Powers], Powers | None] = {}
        self.pi = self.still(inner.pi)
        self.functions = FunctionsWhenAsked(self._function)

    def still(self, c: Any) -> Polynomial:
        """A constant."""
        return Polynomial(self, {self.none: c})

    def number(self, value: Fraction | int) -> Polynomial:
        return self.still(self.inner.number(value))

    def variable(self, i: int, place: Any) -> Polynomial:
        """place + xᵢ"""
        return Polynomial(self, {self.none: place, tuple(int(j == i) for j in range(self.count)): self.inner.number(1)})

    def sums(self, i: Powers, j: Powers) -> Powers | None:
        """The powers of a product; None where they are not kept."""
        pair = (i, j)
        if pair not in self._sums:
            found = tuple(map(sum, zip(i, j, strict=True)))
            self._sums[pair] = found if self.keep(found) else None
        return self._sums[pair]

    def power(self, u: Polynomial, e: Fraction | int) -> Polynomial:
        u0, w = u.constant, u.moving
        if not w.terms:
            return self.still(self.inner.power(u0, e))
        if e.denominator == 1 and e > 0:
            return self._whole(u, int(e))
        if self.side(u0) == 0:
            raise NoDerivative("power")
        coefficients, inverse = [self.inner.power(u0, e)], self.inner.power(u0, -1)
        for k in range(1, self.order + 1):
            coefficients.append(coefficients[-1] * self.inner.number(Fraction(e - k + 1) / k) * inverse)
        return self.composed(coefficients, w)

    def _whole(self, u: Polynomial, n: int) -> Polynomial:
        if n == 1:
            return u
        half = self._whole(u, n // 2)
        return half * half * u if n % 2 else half * half

    def composed(self, coefficients: Sequence[Any], w: Polynomial) -> Polynomial:
        """Σ cₖ wᵏ by Horner's scheme."""
        found = self.still(coefficients[-1])
        for c in coefficients[-2::-1]:
            found = found * w + self.still(c)
        return found

    def record(self, name: str, samples: Any) -> Callable[..., Polynomial]:
        """A function of the time alone."""
        at = self.inner.record(name, samples)
        return lambda u, order: self.still(at(u.constant, order))

    def called(self, function: Any) -> Callable[..., Polynomial]:
        """A function of its first argument; NoDerivative where it has none, or where its parameters move."""
        def call(*args: Polynomial) -> Polynomial:
            constants = [u.constant for u in args]
            if not any(u.moving.terms for u in args):
                return self.still(self.inner.called(function)(*constants))
            if any(u.moving.terms for u in args[1:]):
                raise NoDerivative(function.symbol)
            return self.composed(function.coefficients(self, constants), args[0].moving)
        return call

    def _function(self, name: str) -> Callable[..., Polynomial]:
        def call(*args: Polynomial) -> Polynomial:
            if not any(u.moving.terms for u in args):
                return self.still(self.inner.functions[name](*(u.constant for u in args)))
            if name in _BENT:
                return self._bent(name, *args)
            return self._smooth(name, args)
        return call

    def _bent(self, name: str, *args: Polynomial) -> Polynomial:
        """What has a kink, off the kink."""
        u = args[0] if len(args) == 1 else args[0] + args[1].scaled(self.inner.number(-1))
        side = self.side(u.constant)
        if side is None:
            raise NotInLetters(f"the sign of what {name} is of is found in numbers", "give values with --set")
        if side == 0:
            raise NoDerivative(name)
        zero = self.number(0)
        if name in ("min", "max"):
            return args[0] if (side > 0) == (name == "max") else args[1]
        return {"abs": u.scaled(self.inner.number(side)), "sign": self.number(side),
                "ramp": u if side > 0 else zero, "step": self.number(int(side > 0))}[name]

    def _smooth(self, name: str, args: tuple[Polynomial, ...]) -> Polynomial:
        """By the derivatives of f, of all its arguments."""
        orders, nodes, names = _derivatives(name, len(args), self.order)
        places = dict(zip(names, (u.constant for u in args), strict=True))
        slopes = [value * self.inner.number(Fraction(1, _factorials(k)))
                  for k, value in zip(orders, evaluate(nodes, self.inner, places), strict=True)]
        if len(args) == 1:
            return self.composed(slopes, args[0].moving)
        powers = [self._powers(u.moving) for u in args]
        found = self.number(0)
        for k, slope in zip(orders, slopes, strict=True):
            factor = self.still(slope)
            for i, n in enumerate(k):
                factor = factor * powers[i][n]
            found = found + factor
        return found

    def _powers(self, w: Polynomial) -> list[Polynomial]:
        found = [self.number(1)]
        for _ in range(self.order):
            found.append(found[-1] * w)
        return found


_BENT = ("abs", "sign", "min", "max", "ramp", "step")


def sign(c: Any) -> int:
    """That of a number with or without a bound; 0 where that does not tell it."""
    value = number_in(c)
    return 0 if not abs(value) > error_in(c) else 1 if value > 0 else -1


def _factorials(orders: Powers) -> int:
    found = 1
    for n in orders:
        found *= factorial(n)
    return found


def _derivatives(name: str, count: int, order: int) -> tuple[list[Powers], list[Node], list[str]]:
    """(orders, derivatives, names of the arguments) of a function, in a table of its own."""
    table = Table()
    arguments = [table.variable(f"u{i}") for i in range(count)]
    found: dict[Powers, Node] = {(0,) * count: table.call(name, *arguments)}
    for orders in sorted(all_of(range(order + 1), repeat=count), key=sum):
        if 0 < sum(orders) <= order:
            i = next(i for i, n in enumerate(orders) if n)
            before = found[tuple(n - (j == i) for j, n in enumerate(orders))]
            found[orders] = gradient(before).get(arguments[i], table.zero)
    return list(found), list(found.values()), [u.name for u in arguments]


class NodeArithmetic:
    """Nodes of a table, for coefficients in letters."""

    def __init__(self, table: Table, names: Sequence[str]) -> None:
        self.table, self.pi, self.number, self.power = table, table.pi, table.number, table.power
        self.functions = {name: self._call(name) for name in names}

    def record(self, name: str, samples: Any) -> Callable[..., Node]:
        """A function of the time alone."""
        return lambda u, order: self.table.call(name, u, *([self.table.number(order)] if order else []))

    def called(self, function: Any) -> None:
        """Of what an element defines: it has no form in letters."""
        raise NotInLetters("an expansion about a place within parts in series or a table is found in numbers",
                           "give all parameters values")

    def _call(self, name: str) -> Callable[..., Node]:
        return lambda *args: self.table.call(name, *args)
