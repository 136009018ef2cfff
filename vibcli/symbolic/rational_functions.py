"""Expressions as quotients of polynomials over ℚ in their atoms, by SymPy's sparse rings: cancelled and factored.

Atoms are symbols, functions and roots. Squares of roots and of sines are replaced by what they are (`settled`).
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.irreducible_factors import irreducible_factors
from vibcli.symbolic.nested_form import grouped, letters
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import HALF, ONE
from vibcli.symbolic.time_limit import within

if TYPE_CHECKING:
    from sympy.polys.fields import FracElement
    from sympy.polys.rings import PolyElement

    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

CALLS = 4_000_000       # for one factorisation
LONG = 100          # terms of a polynomial that is not written in factors


class Quotients:
    """The field of quotients in the atoms of some nodes, and one unknown more."""

    def __init__(self, table: "Table", nodes: "Sequence[Node]", unknown: str = "λ") -> None:
        from sympy import QQ
        from sympy.polys.rings import PolyRing

        self.table, self.symbol = table, table.variable(unknown)
        self.atoms = sorted(_atoms(nodes), key=lambda pair: (pair[0].index, pair[1]))
        self.ring = PolyRing([f"a{i}" for i in range(len(self.atoms))] + ["unknown"], QQ, "lex")
        self.field = self.ring.to_field()
        *gens, self.unknown = self.field.gens
        self._gens = dict(zip(self.atoms, gens, strict=True)) | {(self.symbol, ONE): self.unknown}
        self._factored: dict[PolyElement, Any] = {}

    def number(self, value: Fraction | int) -> Any:
        return self.field(self.ring.domain(value.numerator, value.denominator))

    def __call__(self, node: Any) -> Any:
        """A node as an element of the field."""
        done = {}
        for part in reachable([node]):
            if part.op == "sum":
                done[part] = sum((done[arg] * self.number(c) for arg, c in part.args), self.number(part.coefficient))
            elif part.op == "product":
                done[part] = self._product(part, done)
            else:
                done[part] = self.number(part.coefficient) if part.op == "number" else self._gens.get((part, ONE))
        return self.settled(done[node])

    def settled(self, element: Any) -> Any:
        """The element with what stands under a root in place of the root's square, and 1 − cos² in place of sin²."""
        for (base, e), gen in self._gens.items():
            if (e == HALF or base.name == "sin") and max(
                    part.degree(gen.numer) for part in (element.numer, element.denom)) > 1:
                inner = self(base) if e == HALF else 1 - self(base.table.call("cos", *base.args)) ** 2
                element = self._reduced(element.numer, gen, inner) / self._reduced(element.denom, gen, inner)
        return element

    def _reduced(self, polynomial: "PolyElement", gen: "FracElement", inner: "FracElement") -> "FracElement":
        i, found = self.ring.gens.index(gen.numer), {}
        for powers, value in polynomial.terms():
            found.setdefault(powers[i] // 2, {})[(*powers[:i], powers[i] % 2, *powers[i + 1:])] = value
        return sum((self.field(self.ring.from_dict(terms)) * inner ** half for half, terms in found.items()),
                   self.field(0))

    def _product(self, node: "Node", done: "Mapping[Node, Any]") -> Any:
        total = self.number(node.coefficient)
        for base, e in node.args:
            factor = done[base] if e.denominator == 1 else self._gens[base, Fraction(1, e.denominator)]
            total *= factor ** e.numerator
        return total

    def polynomial(self, element: Any) -> "Node":
        """A polynomial of the ring as a node: nested, not factored."""
        factors = [*self.atoms, (self.symbol, ONE)]
        return grouped(self.table.sum(*(self._term(powers, value, factors) for powers, value in element.terms())))

    def _term(self, powers: tuple[int, ...], value: Fraction | int,
              factors: "Sequence[tuple[Node, Fraction | int]]") -> "tuple[Node, Fraction]":
        product = self.table.product(*((base, e * power) for (base, e), power in zip(factors, powers, strict=True)))
        return product, self.rational(value)

    @staticmethod
    def rational(value: Any) -> Fraction:
        """A number of the ring's domain as a Fraction."""
        return Fraction(int(value.numerator), int(value.denominator))

    def factors(self, polynomial: Any) -> Any:
        """(rational, [(irreducible factor, multiplicity)]) of a polynomial of the ring; each is factored once."""
        if polynomial not in self._factored:
            found = within(CALLS, lambda: irreducible_factors(polynomial), None)
            if found is None:
                return polynomial.ring.domain(1), [(polynomial, 1)]
            self._factored[polynomial] = found
        return self._factored[polynomial]

    def cleared(self, elements: Sequence[Any]) -> tuple[list[dict[tuple[Any, ...], Any]], dict[tuple[int, ...], Any]]:
        """(polynomials, denominator): elements of the field over a common denominator."""
        below = self.ring(1)
        for element in elements:
            below = below.lcm(element.denom)
        whole = [element * self.field(below) for element in elements]
        return [element.numer.quo_ground(element.denom.LC) for element in whole], below

    def generator(self, atom: "Node", exponent: Any = ONE) -> Any:
        """The polynomial that stands for an atom."""
        return self._gens[atom, exponent].numer

    def coefficients(self, polynomial: Any, atom: "Node | None" = None, exponent: Fraction | int = ONE) -> list[Any]:
        """The coefficients of a polynomial in an atom, or in the unknown, from the lowest, as elements of the field."""
        i, found = self.ring.gens.index(self.generator(self.symbol if atom is None else atom, exponent)), {}
        for powers, value in polynomial.terms():
            found.setdefault(powers[i], {})[(*powers[:i], 0, *powers[i + 1:])] = value
        return [self.field(self.ring.from_dict(found.get(i, {}))) for i in range(max(found, default=0) + 1)]

    def node(self, element: Any) -> "Node":
        """An element of the field as a node: one fraction, above and below the line factored."""
        parts = []
        for polynomial, sign in ((element.numer, ONE), (element.denom, -ONE)):
            content, rest = polynomial.primitive()
            parts += [(self.table.number(self.rational(content)), sign), (self._shortest(rest), sign)]
        return self.table.product(*parts)

    def _shortest(self, polynomial: Any) -> "Node":
        """A polynomial as the product of its factors or as a whole, long ones as they are."""
        if len(polynomial) > LONG:
            return self.polynomial(polynomial)
        value, factors = self.factors(polynomial)
        parts = ((self.polynomial(factor), power) for factor, power in factors)
        product = self.table.product((self.table.number(self.rational(value)), ONE), *parts)
        return product if len(factors) == 1 else min((self.polynomial(polynomial), product), key=letters)


def _atoms(nodes: "Sequence[Node]") -> "set[tuple[Node, Fraction | int]]":
    """{(base, e)}: symbols and functions with e = 1, bases of roots with e = 1/2 and the like."""
    found: set[tuple[Node, Fraction | int]] = set()
    cosines = [part.table.call("cos", *part.args) for part in reachable(nodes) if part.name == "sin"]
    for part in reachable([*nodes, *cosines]):
        if part.op in ("symbol", "call", "pi"):
            found.add((part, ONE))
        elif part.op == "product":
            found |= {(base, Fraction(1, e.denominator)) for base, e in part.args if e.denominator > 1}
    return found


def factored(node: "Node") -> "Node":
    """A quotient of polynomials cancelled and factored; the node itself where that takes too long."""
    return within(2 * CALLS, lambda: _factored(textbook(node)), node)


def _factored(node: "Node") -> "Node":
    quotients = Quotients(node.table, [node])
    return quotients.node(quotients(node))
