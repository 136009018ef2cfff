"""Long lengths under a root get a symbol of their own, ℓ₁ = √(…), so that equations stay readable."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import HALF, ONE

if TYPE_CHECKING:
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

SHORT = 2           # roots of fewer terms are left in place
SHORTER = 0.75      # of the letters, or columns, of what is multiplied out, in which it is shown as it was before


def abbreviated(nodes: "Sequence[Node]", known: "dict[Node, Node]",
                fixed: bool = False) -> "tuple[list[Node], list[tuple[Node, Node]]]":
    """(nodes with long roots replaced, [(symbol, root)] of those that are new). `known` {sum: symbol} is added to; of
    sums that differ in form alone the symbol is one. fixed: of parameters alone, too?"""
    table, new, grouped = nodes[0].table if nodes else None, [], None
    for node in nodes:
        for base in _rooted(node, fixed):
            if base not in known:
                whole = textbook(base)
                if whole not in known:
                    known[whole] = table.variable(f"ℓ{len(set(known.values())) + 1}")
                    grouped = _by_legs(table) if grouped is None else grouped
                    new.append((known[whole], table.power(_shorter(grouped.get(whole, whole), whole), HALF)))
                known[base] = known[whole]
    return [_replaced(table, node, known) for node in nodes], new


def _shorter(grouped: "Node", square: "Node") -> "Node":
    """The first where it is shorter by far: the law of cosines stays."""
    return grouped if letters(grouped) < SHORTER * letters(square) else square


def _by_legs(table: "Table") -> "dict[Node, Node]":
    """{the square of a distance: the same by its two legs, (x + a)² + (y + b)²}."""
    grouped = [dx * dx + dy * dy for dx, dy in (map(textbook, legs) for legs in table.legs)]
    return {textbook(square): square for square in grouped}


def _rooted(node: "Node", fixed: bool) -> "list[Node]":
    """The long sums that stand under a root, or below a line as the square of a length does, anywhere in a node."""
    pending, found = [node], []
    while pending:
        part = pending.pop()
        if part.op == "product":
            found += [base for base, e in part.args if base.op == "sum" and len(base.args) >= SHORT
                      and ((e.denominator == 2 and (base.mask or fixed)) or (e < 0 and base.mask))]
        if part.op in ("sum", "product"):
            pending.extend(arg for arg, _ in part.args)
        elif part.op == "call":
            pending.extend(part.args)
    return sorted(found, key=lambda base: base.index)


def _replaced(table: "Table", node: "Node", roots: "dict[Node, Node]") -> "Node":
    """The node with each Σ^(e) of a long root written as ℓ^(2e)."""
    if node.op == "sum":
        terms = [(_replaced(table, part, roots), c) for part, c in node.args]
        return table.sum((table.number(node.coefficient), ONE), *terms)
    if node.op == "product":
        factors = []
        for base, e in node.args:
            if base in roots:
                factors.append((roots[base], 2 * e))
            else:
                factors.append((_replaced(table, base, roots), e))
        return table.product((table.number(node.coefficient), ONE), *factors)
    return roots[node] ** 2 if node in roots else node
