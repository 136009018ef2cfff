"""Nodes of expressions.

A node is one of

    number   an exact rational                     symbol   a parameter or a variable (coordinate, velocity)
    sum      c₀ + Σ cᵢ·nodeᵢ                        product  c·Π nodeᵢ^eᵢ, rational cᵢ, c, eᵢ
    call     a function of nodes                   pi
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import wraps
from typing import TYPE_CHECKING, Any, TypeVar, cast

from vibcli.symbolic.rationals import HALF, ONE, ZERO, exact_root

if TYPE_CHECKING:
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.variable_sets import VariableSet

OfNode = TypeVar("OfNode", bound=Callable[..., Any])
BARS = {"abs", "sign"}
UNITS = {base: f"1 {base}" for base in ("kg", "m", "s")}   # {unit: its letter, which is 1}: what it multiplies has it
FEW = 4096      # variables that ints tell apart, a bit for each

ALL_PURE: "frozenset[Any]" = frozenset()    # numbers whose units no letter tells: none, as all have theirs by letters


class Node:
    """One immutable expression, owned by its Table. `mask` is the set of the variables that it depends on;
    `args`: (node, rational) pairs of a sum or product, nodes of a call; `parts`: the nodes among them."""

    __slots__ = ("args", "coefficient", "gradient", "index", "mask", "name", "op", "parts", "table")
    table: "Table"
    op: str
    args: tuple[Any, ...]
    parts: "tuple[Node, ...]"
    coefficient: Fraction | int
    mask: "VariableSet | int"
    name: str
    index: int
    gradient: "dict[Node, Node] | None"

    def keep_gradient(self, gradient: Any) -> None:
        """Keep {variable: derivative}, which is worked out once."""
        self.gradient = gradient

    def __add__(self, other: "Fraction | int | Node") -> "Node":
        return self.table.sum((self, ONE), (self.table.node(other), ONE))

    def __sub__(self, other: "Fraction | int | Node") -> "Node":
        return self.table.sum((self, ONE), (self.table.node(other), -ONE))

    def __mul__(self, other: "Fraction | int | Node") -> "Node":
        table = self.table
        other = other if other.__class__ is Node else table.node(other)
        for one, factor in ((self, other), (other, self)):
            if one is table.one and factor.op != "sum":     # a sum may be written the other way round
                return factor
        return table.product((self, ONE), (other, ONE))

    def __truediv__(self, other: "Fraction | int | Node") -> "Node":
        return self.table.product((self, ONE), (self.table.node(other), -ONE))

    def __pow__(self, exponent: Fraction | int) -> "Node":
        return self.table.power(self, exponent)

    def __neg__(self) -> "Node":
        return self.table.scaled(self, -ONE)

    def __rsub__(self, other: Fraction | int) -> "Node":
        return self.table.node(other) - self

    def __rtruediv__(self, other: Fraction | int) -> "Node":
        return self.table.node(other) / self

    __radd__, __rmul__ = __add__, __mul__

    @property
    def is_zero(self) -> bool:
        return self.op == "number" and not self.coefficient

    def __repr__(self) -> str:
        if self.op in ("sum", "product"):
            return f"{self.op}({self.coefficient}, {', '.join(f'{a!r}^{e}' for a, e in self.args)})"
        return str(self.coefficient) if self.op == "number" else f"{self.name}({', '.join(map(repr, self.args))})"


def remembered(function: OfNode) -> OfNode:
    """A function of a node by itself: what it gives is kept until the table decides signs by other values."""
    @wraps(function)
    def known(node: "Node") -> Any:
        kept, key = node.table.kept, (function, node)
        if key not in kept:
            kept[key] = function(node)
        return kept[key]
    return cast(OfNode, known)


@remembered
def cofunction(node: "Node") -> "Node":
    """cos u of sin u, and sin u of cos u."""
    return node.table.call("cos" if node.name == "sin" else "sin", *node.args)


def one_variable(number: int) -> "VariableSet | int":
    """The set of one variable."""
    if number < FEW:
        return 1 << number
    from vibcli.symbolic.variable_sets import VariableSet

    return VariableSet(0, frozenset((number,)))


def union(sets: "list[VariableSet | int]") -> "VariableSet | int":
    """All variables that are in any of these sets."""
    if len(sets) == 1:
        return sets[0]
    found = 0
    for one in sets:
        if one.__class__ is not int:
            from vibcli.symbolic.variable_sets import union_of

            return union_of(sets)
        found |= one
    return found


def first_variable(variables: "VariableSet | int") -> int:
    """The lowest number of a variable in a set, counted from 1; 0 where it is empty."""
    return (variables & -variables).bit_length() if isinstance(variables, int) else variables.first


def rooted_square(base: Node, exponent: Fraction) -> tuple[Node, Fraction]:
    """(base, exponent) of a factor, |x| for the root of a square x², x² for that of x⁴."""
    if exponent.denominator == 2 and base.op == "product" and all(
            e.denominator == 1 and e % 2 == 0 for _, e in base.args) and (
            size := exact_root(base.coefficient) if base.coefficient > 0 else None):
        inner = base.table.product((base.table.number(size), ONE), *((one, e * HALF) for one, e in base.args))
        even = inner.op == "product" and all(e % 2 == 0 for _, e in inner.args)
        return inner if even else base.table.call("abs", inner), 2 * exponent
    return base, exponent


def without_bars(factors: "Mapping[Node, Fraction | int]") -> "list[tuple[Node, Fraction | int]] | None":
    """(base, exponent) of factors {base: exponent} with x² for |x|², x for |x| sign x and without sign² x; None where
    there are none of these."""
    odd = {(base.name, base.args[0]): e % 2 == 1 for base, e in factors.items() if base.op == "call"
           and base.name in BARS and e.denominator == 1}
    found = []
    for base, e in factors.items():
        key = base.name, base.args[0] if base.op == "call" else None
        both = odd.get(("abs", key[1])) and odd.get(("sign", key[1]))
        if key not in odd or (odd[key] and not both and (base.name == "abs" or e == 1)):
            found.append((base, e))
        elif base.name == "abs":
            found.append((key[1], e))
        elif odd[key] and not both:
            found.append((base, ONE))
    return found if found != list(factors.items()) else None


def times(a: "Monomial", b: "Monomial", power: int = 1) -> "Monomial":
    """The monomial a·b^power; the atoms of a are in the order of their indices."""
    exponents, as_in_a = dict(a), True
    for atom, e in b:
        total = e * power
        if atom in exponents:
            total = exponents[atom] + total
            if not total:
                del exponents[atom]
                continue
        elif total:
            as_in_a = False
        else:
            continue
        exponents[atom] = total
    return tuple(exponents.items()) if as_in_a else tuple(sorted(exponents.items(), key=by_index))


def is_measure(node: "Node") -> bool:
    """Is it the letter of a unit, or a number with one?"""
    return node.op == "symbol" and node.name[:1].isdigit()


def is_measured(node: "Node") -> bool:
    """Is it a number with a unit, or a product of one?"""
    return is_measure(node) or (node.op == "product" and any(is_measure(base) for base, _ in node.args))


def is_number(node: "Node") -> bool:
    """Is it a number, perhaps with a unit?"""
    return node.op == "number" or is_measure(node) or (node.op == "product" and all(
        is_measure(base) for base, _ in node.args))


def _stays(atom: Node, monomials: "Sequence[Monomial]", with_units: bool) -> bool:
    """Does the letter of a unit stay with the numbers of a sum?"""
    return is_measure(atom) and not (with_units and len({dict(monomial).get(atom, 0) for monomial in monomials}) == 1)


def content_of(monomials: "Sequence[Monomial]", with_units: bool) -> "Monomial":
    """((atom, exponent), …): the monomial that all have as a factor, letters of units where all have them in one
    power and `with_units`."""
    common = {atom: min(dict(monomial).get(atom, ZERO) for monomial in monomials)
              for atom in {atom for monomial in monomials for atom, _ in monomial}}
    found = [(atom, e) for atom, e in common.items() if e and not _stays(atom, monomials, with_units)]
    return tuple(sorted(found, key=by_index))


def by_index(pair: "tuple[Node, Any]") -> int:
    """The rank of a factor (node, exponent): nodes in the order in which they were made."""
    return pair[0].index


if TYPE_CHECKING:
    Monomial = tuple[tuple[Node, Fraction | int], ...]      # ((atom, exponent), …)
    Terms = dict[Monomial, Fraction | int]      # {monomial: coefficient} of a polynomial
