"""Solutions in letters of one condition with one unknown: polynomials of first and second degree, pure powers, and
equations in its sine and cosine. SymPy factors the condition; each factor is solved by its kind.

Solutions are candidates: a root is squared away, and branches are all offered, so that they have to be checked.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.angle_addition import opened
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.radicals import root
from vibcli.symbolic.rational_functions import Quotients
from vibcli.symbolic.rationals import HALF
from vibcli.symbolic.surds import Pair
from vibcli.symbolic.time_limit import within

if TYPE_CHECKING:
    from sympy.polys.rings import PolyElement

    from vibcli.symbolic.node import Node

CALLS = 8_000_000


class SymbolicSolution(NamedTuple):
    """value: the unknown; sine, cosine: of it where it is an angle, else None; one_sided: is it of a condition that
    holds for one sign of the unknown alone?"""

    value: Any
    sine: Any = None
    cosine: Any = None
    one_sided: bool = False


def solutions(node: "Node", unknown: "Node", samples: Sequence[dict[str, float]]) -> list[Any]:
    """The Solutions of node = 0; none where its form is not known. `samples`: admissible values of the letters."""
    node, = opened([node], unknown)
    sides = [textbook(one) for one in _sides(node, unknown)]
    return within(CALLS, lambda: [found._replace(one_sided=len(sides) > 1) for one in sides
                                  for found in _Condition(one, unknown, samples).solutions()], [])


def _sides(node: "Node", unknown: "Node") -> "list[Node]":
    """A condition as it is for a positive unknown, and for a negative one, where its size or sign stands in it."""
    size, sign = (unknown.table.call(name, unknown) for name in ("abs", "sign"))
    if {size, sign}.isdisjoint(reachable([node])):
        return [node]
    return [substitute([node], {size: side * unknown, sign: side * unknown.table.one})[0] for side in (1, -1)]


class _Condition:
    """A condition as polynomials in the letters and x, sin x, cos x and roots that hold these."""

    def __init__(self, node: "Node", unknown: "Node", samples: Sequence[dict[str, float]]) -> None:
        table = self.table = node.table
        self.x, self.samples = unknown, samples
        self.sine, self.cosine = table.call("sin", unknown), table.call("cos", unknown)
        under_roots = [base for part in reachable([node]) if part.op == "product" for base, e in part.args
                       if e.denominator == 2 and base.mask & unknown.mask]
        self.quotients = Quotients(table, [node, self.sine, self.cosine, *under_roots])
        self.node = node

    def solutions(self) -> list[Any]:
        moving = [atom for atom in self.quotients.atoms if atom[0].mask & self.x.mask]
        if any(base not in (self.x, self.sine, self.cosine) and e != HALF for base, e in moving):
            return []
        roots = [base for base, e in moving if e == HALF]
        factors = self._factors(self.quotients(self.node).numer)
        return [solution for factor in factors for solution in self._of_factor(factor, roots)]

    def _factors(self, polynomial: "PolyElement") -> "list[PolyElement]":
        return [factor for factor, _ in self.quotients.factors(polynomial)[1]]

    def _of_factor(self, factor: "PolyElement", roots: "Sequence[Node]") -> list[SymbolicSolution]:
        present = [base for base in roots if self._degree(factor, base, HALF)]
        if len(present) > 1:
            return []
        if present:
            return self._without_root(factor, present[0])
        kinds = {atom for atom in (self.x, self.sine, self.cosine) if self._degree(factor, atom)}
        if kinds == {self.x}:
            return [SymbolicSolution(value) for value in self._polynomial_roots(factor, self.x)]
        if not kinds or self.x in kinds:
            return []
        if len(kinds) == 2:
            return self._both(factor)
        atom, = kinds
        return [solution for value in self._polynomial_roots(factor, atom)
                for solution in (self._of_sine(value) if atom is self.sine else self._of_cosine(value))]

    def _degree(self, polynomial: "PolyElement", atom: "Node", e: Fraction | int = 1) -> int:
        return polynomial.degree(self.quotients.generator(atom, e)) if (atom, e) in self.quotients.atoms else 0

    def _without_root(self, factor: "PolyElement", base: "Node") -> list[SymbolicSolution]:
        """A + B√D = 0 gives A² = B²D."""
        parts = self.quotients.coefficients(factor, base, HALF)
        if len(parts) != 2:
            return []
        squared = parts[0] ** 2 - parts[1] ** 2 * self.quotients(base)
        return [solution for factor in self._factors(self._one_of_two(squared.numer))
                for solution in self._of_factor(factor, [])]

    def _one_of_two(self, polynomial: "PolyElement") -> "PolyElement":
        """sin² replaced by 1 − cos²."""
        field = self.quotients.field
        cosine = field(self.quotients.generator(self.cosine))
        total = field(0)
        for d, c in enumerate(self.quotients.coefficients(polynomial, self.sine)):
            total += c * (1 - cosine ** 2) ** (d // 2) * field(self.quotients.generator(self.sine)) ** (d % 2)
        return total.numer

    def _polynomial_roots(self, polynomial: "PolyElement", atom: "Node") -> "list[Node]":
        """The roots in an atom of a polynomial of degree one or two, or c₀ + cₙ xⁿ."""
        c = self.quotients.coefficients(polynomial, atom)
        n = len(c) - 1
        if n == 1:
            return [self.quotients.node(-c[0] / c[1])]
        if n == 2:
            pair = Pair(self.quotients, c, self.samples[0])
            parts = (pair.written(pair.rational, sign * pair.factor) for sign in (1, -1))
            return [front * rest for front, rest in parts]
        if any(c[1:-1]):
            return []
        power = self.quotients.node(-c[0] / c[n])
        return [sign * (sign * power) ** Fraction(1, n) for sign in (1, -1)]

    def _of_sine(self, u: "Node") -> list[SymbolicSolution]:
        table = self.table
        if u.is_zero:
            return [SymbolicSolution(table.zero, u, table.one),
                    *(SymbolicSolution(sign * table.pi, u, -table.one) for sign in (1, -1))]
        if u.op == "number" and abs(u.coefficient) == 1:
            return [SymbolicSolution(table.pi * (u.coefficient * turn), u, table.zero) for turn in (HALF, HALF - 2)]
        inner, across = table.call("asin", u), self._beside(u)
        return [SymbolicSolution(inner, u, across), SymbolicSolution(table.pi - inner, u, -across),
                SymbolicSolution(-table.pi - inner, u, -across)]

    def _of_cosine(self, u: "Node") -> list[SymbolicSolution]:
        table = self.table
        if u.is_zero:
            return [SymbolicSolution(sign * table.pi / 2, sign * table.one, u) for sign in (1, -1)]
        if u.op == "number" and abs(u.coefficient) == 1:
            turns = (0, 2, -2) if u.coefficient == 1 else (1, -1)
            return [SymbolicSolution(table.pi * turn, table.zero, u) for turn in turns]
        inner, across = table.call("acos", u), self._beside(u)
        return [SymbolicSolution(inner, across, u), SymbolicSolution(-inner, -across, u)]

    def _beside(self, u: "Node") -> "Node":
        """√(1 − u²)."""
        return root(single(1 - u * u), self.samples)

    def _both(self, factor: "PolyElement") -> list[SymbolicSolution]:
        """a sin x + b cos x + d = 0."""
        by_sine = self.quotients.coefficients(factor, self.sine)
        if len(by_sine) != 2 or self._degree(by_sine[1].numer, self.cosine):
            return []
        rest = self.quotients.coefficients(by_sine[0].numer, self.cosine)
        if len(rest) > 2:
            return []
        a, b, d = by_sine[1], rest[1], rest[0]
        table, square = self.table, a ** 2 + b ** 2
        length = root(self.quotients.node(square), self.samples)
        lean = table.call("atan", self.quotients.node(b / a))
        if not d:
            sine, cosine = self.quotients.node(-b) / length, self.quotients.node(a) / length
            return [SymbolicSolution(-lean + k * table.pi, sign * sine, sign * cosine)
                    for sign in (1, -1) for k in (0, 1, -1)]
        span = root(self.quotients.node(square - d ** 2), self.samples)
        inner = table.call("asin", self.quotients.node(-d) / length)
        found = []
        for sign in (1, -1):
            sine = self.quotients.node(-a * d / square) - sign * self.quotients.node(b / square) * span
            cosine = self.quotients.node(-b * d / square) + sign * self.quotients.node(a / square) * span
            for branch in (inner, table.pi - inner, -table.pi - inner):
                found += [SymbolicSolution(branch - lean + k * table.pi, sine, cosine) for k in (0, 1, -1)]
        return found
