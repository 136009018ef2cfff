"""Functions that rise everywhere, shown by the form of their slopes alone."""

from typing import TYPE_CHECKING

from vibcli.symbolic.derivatives import gradient

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

POSITIVE = ("abs", "exp", "cosh")


def rises_where(function: "Node", x: "Node") -> "list[Node] | None":
    """What has to be positive, free of x, so that a function rises for all x; None where its form shows no such
    thing, as where it is level on a stretch or bends."""
    slope = gradient(function).get(x)
    return None if slope is None else _positive_where(slope, x)


def _positive_where(node: "Node", x: "Node") -> "list[Node] | None":
    """Conditions under which an expression is positive but at single places; None where none are known."""
    if not node.mask & x.mask:
        return [node]
    if node.op == "sum":
        return _sum(node, x)
    if node.op == "product":
        return _product(node, x)
    called = node.table.functions.get(node.name)
    if called is not None:
        return called.positive_where(node, x)
    return [] if node.op == "call" and node.name in POSITIVE else None


def _sum(node: "Node", x: "Node") -> "list[Node] | None":
    table = node.table
    fixed = table.sum((table.number(node.coefficient), 1), *((part, c) for part, c in node.args
                                                             if not part.mask & x.mask))
    found = [] if fixed.is_zero else [fixed]
    for part, c in node.args:
        if part.mask & x.mask:
            more = _positive_where(table.scaled(part, c), x)
            if more is None:
                return None
            found += more
    return found


def _product(node: "Node", x: "Node") -> "list[Node] | None":
    """Even powers, positive functions, and as many factors again that have the sign of one of them."""
    table, signs, found = node.table, {}, []
    fixed = table.product((table.number(node.coefficient), 1), *((base, e) for base, e in node.args
                                                                 if not base.mask & x.mask))
    for base, e in node.args:
        if not base.mask & x.mask or (e.denominator == 1 and e % 2 == 0):
            continue
        of = base.args[0] if base.op == "call" and base.name == "sign" else base
        if e.denominator == 1 and (of is not base or base is x):
            signs[of] = signs.get(of, 0) + 1
            continue
        more = _positive_where(base, x)
        if more is None:
            return None
        found += more
    if any(count % 2 for count in signs.values()):
        return None
    return found if fixed.op == "number" and fixed.coefficient > 0 else [fixed, *found]
