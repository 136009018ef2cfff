"""Numbers that all terms of a sum within a product have, taken out of it: (2x + 4y)·z/2 = (x + 2y)·z."""

from collections.abc import Iterable
from fractions import Fraction
from math import gcd
from typing import TYPE_CHECKING

from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def without_contents(node: "Node", found: "dict[Node, Node] | None" = None) -> "Node":
    """The same expression with the contents of sums taken out, nothing multiplied out; `found`: of other nodes."""
    found = {} if found is None else found
    if node not in found:
        table = node.table
        if node.op == "sum":
            terms = [(without_contents(part, found), c) for part, c in node.args]
            found[node] = table.sum((table.number(node.coefficient), ONE), *terms)
        elif node.op == "product":
            found[node] = table.product((table.number(node.coefficient), ONE), *(
                pair for base, e in node.args for pair in _factors(without_contents(base, found), e)))
        else:
            found[node] = node
    return found[node]


def _factors(base: "Node", e: Fraction | int) -> "list[tuple[Node, Fraction | int]]":
    """base^e as a number and a sum without content; of roots and of what is no sum itself."""
    values = [c for _, c in base.args] + [base.coefficient] * bool(base.coefficient) if base.op == "sum" else [ONE]
    content = Fraction(gcd(*(value.numerator for value in values)), _common(value.denominator for value in values))
    if content == 1 or e.denominator != 1:
        return [(base, e)]
    return [(base.table.number(content), e), (base.table.scaled(base, 1 / content), e)]


def _common(denominators: Iterable[int]) -> int:
    """The denominator that all have, else 1."""
    found = set(denominators)
    return found.pop() if len(found) == 1 else 1
