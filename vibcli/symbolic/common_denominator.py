"""One fraction bar: a sum of quotients over a common denominator, all coefficients whole, common factors cancelled."""

from collections.abc import Mapping
from fractions import Fraction
from math import gcd, lcm
from typing import TYPE_CHECKING

from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters, nested
from vibcli.symbolic.node import is_measure, remembered
from vibcli.symbolic.normal_form import TooLong, cleared, expanded, factors_of, reduced
from vibcli.symbolic.rationals import ONE, ZERO

if TYPE_CHECKING:
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Monomial, Node, Terms


def single(node: "Node") -> "Node":
    """The node as one fraction."""
    return node.table.product(*fraction(node))


@remembered
def shorter(node: "Node") -> "Node":
    """The node, as one fraction where it divides by a sum and that is shorter."""
    return min((node, single(node)), key=letters) if divides(node) else node


def divides(node: "Node") -> bool:
    """Does a part of the node divide by a sum?"""
    return any(base.op == "sum" and e < 0 for part in reachable([node]) if part.op == "product"
               for base, e in part.args)


@remembered
def fraction(node: "Node") -> "Monomial":
    """((base, exponent), …): the node as a rational and powers of letters and of sums with whole coefficients. The node
    alone where it is too long."""
    table = node.table
    try:
        terms = reduced(expanded(node))
        below = _denominator(terms)
        above, factors = cleared(terms, below), []
        for atom, e in below:
            for base, power in _parts(table, atom):
                above, left = _cancelled(above, base, -power * e)
                factors.append((base, left))
    except (TooLong, ZeroDivisionError):
        return ((node, ONE),)
    return *_written(table, above), *factors


def _denominator(terms: "Mapping[Monomial, Fraction | int]") -> "Monomial":
    """((atom, exponent), …): the lowest negative exponent of each atom but letters of units, as a positive one."""
    lowest = {}
    for monomial in terms:
        for atom, e in monomial:
            if e < 0 and not is_measure(atom):
                lowest[atom] = min(lowest.get(atom, ZERO), e)
    return tuple((atom, -e) for atom, e in sorted(lowest.items(), key=lambda pair: pair[0].index))


def _parts(table: "Table", atom: "Node") -> "Monomial":
    """A base of the denominator as factors with whole coefficients."""
    return _written(table, reduced(expanded(atom, ()))) if atom.op == "sum" else ((atom, ONE),)


def _written(table: "Table", terms: "Mapping[Monomial, Fraction | int]") -> "Monomial":
    """A polynomial as factors: a rational, common letters, and a sum with whole coefficients, but for those with units
    beside others."""
    bare = [value for monomial, value in terms.items() if not any(is_measure(atom) for atom, _ in monomial)]
    values = bare or list(terms.values())
    scale = Fraction(gcd(*(v.numerator for v in values)), lcm(*(v.denominator for v in values))) if values else ONE
    factors = factors_of(table, {monomial: value / scale for monomial, value in terms.items()})
    return ((table.number(scale), ONE),
            *((nested(table, expanded(base, ())) if base.op == "sum" else base, e) for base, e in factors))


def _cancelled(above: "Terms", base: "Node", e: Fraction | int) -> "tuple[Terms, Fraction | int]":
    """(polynomial, exponent left) after dividing by a sum of the denominator as often as it goes."""
    if base.op != "sum":
        return above, e
    from vibcli.symbolic.exact_division import divided

    divisor = expanded(base, ())
    while e <= -1:
        found = divided(above, divisor)
        if found is None:
            break
        above, e = found, e + 1
    return above, e
