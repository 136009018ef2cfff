"""Polynomials in the shortest nested form: m1·k2 + m2·k1 + m2·k2 becomes m1·k2 + m2·(k1 + k2).

Letters that several terms share are taken out, one after the other, as long as that saves letters.
"""

from typing import TYPE_CHECKING, Any

from vibcli.symbolic.node import remembered
from vibcli.symbolic.normal_form import TooLong, expanded, factors_of, reduced
from vibcli.symbolic.rationals import HALF, ONE

if TYPE_CHECKING:
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node, Terms

MANY = 12       # terms, above which a polynomial is left flat


@remembered
def grouped(node: "Node") -> "Node":
    """The node expanded and nested again; the node itself where it is too long."""
    try:
        terms = reduced(expanded(node, ()))
    except (TooLong, ZeroDivisionError):
        return node
    return nested(node.table, terms)


def nested(table: "Table", terms: Any) -> "Node":
    """{monomial: coefficient} as a node: its content, and its terms nested where that is shorter."""
    return _nested(table, terms, {})


@remembered
def letters(node: "Node") -> int:
    """The number of symbols, functions, numbers other than one, and powers a node shows when it is written out."""
    if node.op == "product":
        powers = sum(abs(e) not in (1, HALF) for _, e in node.args)
        return (node.coefficient not in (1, -1)) + powers + sum(letters(arg) for arg, _ in node.args)
    if node.op == "sum":
        return bool(node.coefficient) + sum((c not in (1, -1)) + letters(arg) for arg, c in node.args)
    return 1 + sum(map(letters, node.args)) if node.op == "call" else 1


def _nested(table: "Table", terms: "Terms", known: "dict[frozenset[Any], Node]") -> "Node":
    key = frozenset(terms.items())
    if key not in known:
        factors = factors_of(table, terms)
        known[key] = table.product(*factors)
        if 2 < len(terms) <= MANY:
            known[key] = table.product(*((_shortest(table, base, known) if base.op == "sum" else base, e)
                                         for base, e in factors))
    return known[key]


def _shortest(table: "Table", total: "Node", known: "dict[frozenset[Any], Node]") -> "Node":
    """The shortest of a sum of terms without a common letter: flat, or with one letter taken out of its terms."""
    terms = expanded(total, ())
    best, size = total, letters(total)
    counts = {}
    for monomial in terms:
        for atom, e in monomial:
            if e >= 1:
                counts[atom] = counts.get(atom, 0) + 1
    for atom in sorted((atom for atom, count in counts.items() if count > 1), key=lambda atom: atom.index):
        inside = {monomial: value for monomial, value in terms.items() if dict(monomial).get(atom, 0) >= 1}
        outside = {monomial: value for monomial, value in terms.items() if monomial not in inside}
        parts = [_nested(table, part, known) for part in (inside, outside)]
        candidate = table.sum(*((part, ONE) for part in parts))
        if letters(candidate) < size:
            best, size = candidate, letters(candidate)
    return best
