"""The two roots of a quadratic equation with letters for coefficients: rational ± factor·√D as one fraction."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.radicals import root
from vibcli.symbolic.rationals import ONE, square_part

if TYPE_CHECKING:
    from sympy.polys.rings import PolyElement

    from vibcli.symbolic.node import Node
    from vibcli.symbolic.rational_functions import Quotients


class Pair:
    """x = rational ± factor·√D of p₂x² + p₁x + p₀ = 0, D a polynomial without square factors, factor > 0 at the sample.
    `modulus`: [p₀, p₁, p₂] as elements of the field of `quotients`; `sample`: a value of each letter."""

    def __init__(self, quotients: Any, modulus: Sequence[Any], sample: Mapping[str, float]) -> None:
        c, b, a = quotients.cleared(modulus)[0]
        self.quotients, self.sample, field = quotients, sample, quotients.field
        self.parts = [field(part) for part in (a, b, c)]
        outside, inside = _square_and_rest(quotients, quotients.settled(field(b * b - 4 * a * c)).numer)
        self.rational, self.factor = field(-b) / field(2 * a), field(outside) / field(2 * a)
        if self._negative(quotients.node(self.factor)):
            self.factor = -self.factor
        self.inside = self._shortest(inside, outside)
        turned = self.inside.op == "product" and self.inside.coefficient < 0
        self.root = root(self.inside) if turned else quotients.table.sqrt(self.inside)
        self.in_letters = not inside.is_ground

    def _shortest(self, inside: "PolyElement", outside: "PolyElement") -> "Node":
        """D factored, or as b² − 4ac, whichever is shorter."""
        quotients, table = self.quotients, self.quotients.table
        node: Node = quotients.node(quotients.field(inside))
        a, b, c = (part / quotients.field(outside) for part in self.parts)
        if not all(part.denom.is_ground for part in (b, a * c)):
            return node
        whole = table.sum((table.product((quotients.node(b), ONE + ONE)), ONE), (quotients.node(a * c), -4 * ONE))
        found: Node = min((node, whole), key=letters)
        return found

    def equation(self) -> "list[Node]":
        """The coefficients as nodes, from the highest, which is positive."""
        found = [self.quotients.node(part) for part in self.parts]
        return [-node for node in found] if self._negative(found[0]) else found

    def both(self, surd: Any) -> "Node":
        """The root with `surd` in place of √D."""
        front, rest = self.written(self.rational, self.factor, surd)
        return front * rest

    def written(self, rational: Any, factor: Any, surd: Any = None) -> "tuple[Node, Node]":
        """(front, rest): rational + factor·√D as front·rest, rest a sum that holds the root; `surd` stands for it."""
        quotients, table = self.quotients, self.quotients.table
        if not factor:
            return quotients.node(rational), table.one
        above, below = quotients.cleared([rational, factor])
        common = above[0].gcd(above[1])
        x, y = (quotients.node(quotients.field(part.quo(common))) for part in above)
        front = quotients.node(quotients.field(common) / quotients.field(below))
        if self._negative(front):
            x, y, front = -x, -y, -front
        if self._negative(x) and self._negative(y):
            x, y, front = -x, -y, -front
        surd = self.root if surd is None else surd
        whole = front, table.sum((x, ONE), (y * surd, ONE))
        apart = table.one, table.sum((quotients.node(rational), ONE), (quotients.node(factor) * surd, ONE))
        return min((whole, apart), key=lambda pair: letters(pair[0] * pair[1]))

    def _negative(self, node: "Node") -> bool:
        return bool(evaluate([node], Floats, self.sample)[0] < 0)


def _square_and_rest(quotients: "Quotients", polynomial: "PolyElement") -> "tuple[PolyElement, PolyElement]":
    """(S, D) with S²·D the polynomial, D without square factors."""
    value, factors = quotients.factors(polynomial)
    out, rest = square_part(quotients.rational(value))
    outside, inside = quotients.number(out).numer, quotients.number(rest).numer
    scale = quotients.number(out).denom
    for factor, power in factors:
        outside *= factor ** (power // 2)
        inside *= factor ** (power % 2)
    return outside.quo_ground(scale.LC), inside
