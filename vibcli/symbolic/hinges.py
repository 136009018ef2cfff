"""Bends within bends, as in max(−y, min(x, y)) or max(|x| − g, 0), written as sums of bends of straight lines of x.

With h = a + c max(p, 0), a free of x and p linear in it, q = max(−a/c, 0):

    c > 0   max(h, 0) = c max(p − q, 0) + max(a, 0)
    c < 0   max(h, 0) = −c (q − max(p, 0) + max(p − q, 0)) where a > 0, else 0

and with h = a + c |p|:

    c > 0   max(h, 0) = c (max(p − q, 0) + max(−p − q, 0)) + max(a, 0)
    c < 0   max(h, 0) = −c (max(p + q, 0) − 2 max(p, 0) + max(p − q, 0))
"""

from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import TooLong, collected, expanded, reduced
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

BENT = ("abs", "min", "max", "ramp")


class Hinged(NamedTuple):
    """straight + Σ factor·max(p, 0), {p: factor}; straight and all p are linear in x."""

    straight: Any
    bends: "dict[Node, Node]"


def unnested(node: "Node", x: "Node") -> "Node":
    """The same function of x, bends within bends written as sums of single ones wherever these rules say how."""
    if not any(_holds_another(part, x) for part in reachable([node])):
        return node
    found: dict[Node, Node] = {}
    for part in reachable([node]):
        if _holds_another(part, x):
            hinged = _of(part, x)
            if hinged is not None:
                found[part] = _written(hinged, x.table)
    outer = [part for part in found if not any(part in reachable(list(other.args)) for other in found)]
    return substitute([node], {part: found[part] for part in outer})[0] if outer else node


def _holds_another(node: "Node", x: "Node") -> bool:
    return _bends(node, x) and any(_bends(part, x) for part in reachable(list(node.args)))


def _bends(node: "Node", x: "Node") -> bool:
    return node.op == "call" and node.name in BENT and bool(node.mask & x.mask)


def _written(hinged: Hinged, table: "Table") -> "Node":
    return table.total([hinged.straight, *(c * table.call("max", p, table.zero) for p, c in hinged.bends.items())])


def _of(node: "Node", x: "Node") -> Hinged | None:
    """A node as Hinged; None where it is none."""
    if _is_straight(node, x):
        return Hinged(node, {})
    if node.op == "sum":
        table = node.table
        found = Hinged(table.number(node.coefficient), {})
        for part, c in node.args:
            more = _of(part, x)
            if more is None:
                return None
            found = _plus(found, _scaled(more, table.number(c)))
        return found
    if node.op == "product":
        return _of_product(node, x)
    return _of_bend(node, x) if _bends(node, x) else None


def _of_product(node: "Node", x: "Node") -> Hinged | None:
    moving = [base for base, e in node.args if base.mask & x.mask]
    if len(moving) != 1 or dict(node.args)[moving[0]] != 1:
        return None
    inner = _of(moving[0], x)
    return None if inner is None else _scaled(inner, node / moving[0])


def _of_bend(node: "Node", x: "Node") -> Hinged | None:
    zero = node.table.zero
    parts = [_of(arg, x) for arg in node.args]
    if any(part is None for part in parts):
        return None
    first, second = parts if len(parts) == 2 else (parts[0], Hinged(zero, {}))
    minus = node.table.number(-1)
    positive = _positive_part(_plus(first, _scaled(second, minus)), x)      # max(a − b, 0)
    if positive is None:
        return None
    if node.name == "min":
        return _plus(first, _scaled(positive, minus))
    if node.name == "abs":
        return _plus(_scaled(positive, node.table.number(2)), _scaled(first, minus))
    return _plus(second, positive)


def _positive_part(h: Hinged, x: "Node") -> Hinged | None:
    """max(h, 0)."""
    table = x.table
    h = _tidied(h, x)
    if not h.bends:
        return Hinged(table.zero, {h.straight: table.one})
    if len(h.bends) > 1:
        return None
    (p, c), = h.bends.items()
    if not h.straight.mask & x.mask:
        return _of_one_side(h.straight, c, p)
    rest = _plain(h.straight + c * p, x)
    if not rest.mask & x.mask:
        return _of_one_side(rest, c, -p)
    rest = _plain(h.straight + c * p * HALF, x)
    return None if rest.mask & x.mask else _of_both_sides(rest, c * HALF, p)


def _of_one_side(a: "Node", c: "Node", p: "Node") -> Hinged | None:
    """Of a + c max(p, 0)."""
    sense = _sense(c)
    if sense > 0:
        return Hinged(_larger(a), {p - _larger(-a / c): c})
    if sense < 0:
        q = _larger(-a / c)
        return Hinged(-c * q, _bends_at((p, c), (p - q, -c)))
    return None


def _of_both_sides(a: "Node", c: "Node", p: "Node") -> Hinged | None:
    """Of a + c |p|."""
    sense, q = _sense(c), _larger(-a / c)
    if sense > 0:
        return Hinged(_larger(a), _bends_at((p - q, c), (-p - q, c)))
    return Hinged(p.table.zero, _bends_at((p + q, -c), (p, 2 * c), (p - q, -c))) if sense < 0 else None


def _bends_at(*bends: "tuple[Node, Node]") -> "dict[Node, Node]":
    found: dict[Node, Node] = {}
    for p, c in bends:
        found[p] = found[p] + c if p in found else c
    return found


def _sense(c: "Node") -> int:
    return 1 if c.table.is_positive(c) else -1 if c.table.is_positive(-c) else 0


def _larger(a: "Node") -> "Node":
    """max(a, 0) of what is free of x."""
    sense = _sense(a)
    return a if sense > 0 else a.table.zero if sense < 0 or a.is_zero else a.table.call("max", a, a.table.zero)


def _tidied(h: Hinged, x: "Node") -> Hinged:
    """With the bends that lie at one place taken together, as those of max(p, 0) and max(−p, 0)."""
    straight, bends = h.straight, {}
    for p, c in h.bends.items():
        p = _plain(p, x)
        for known in list(bends):
            ratio = _slope(p, x) / _slope(known, x)
            if _plain(p - ratio * known, x).is_zero and (sense := _sense(ratio)):
                bends[known] = bends[known] + (c * ratio if sense > 0 else -c * ratio)
                straight = straight if sense > 0 else straight + c * p
                break
        else:
            bends[p] = c
    kept = {p: _plain(c, x) for p, c in bends.items()}
    return Hinged(_plain(straight, x), {p: c for p, c in kept.items() if not c.is_zero})


def _plus(a: Hinged, b: Hinged) -> Hinged:
    bends = dict(a.bends)
    for p, c in b.bends.items():
        bends[p] = bends[p] + c if p in bends else c
    return Hinged(a.straight + b.straight, bends)


def _scaled(hinged: Hinged, factor: "Node") -> Hinged:
    return Hinged(hinged.straight * factor, {p: c * factor for p, c in hinged.bends.items()})


def _is_straight(node: "Node", x: "Node") -> bool:
    slope = gradient(node).get(x)
    return slope is None or not (slope.mask & x.mask or any(_bends(part, x) for part in reachable([node])))


def _slope(node: "Node", x: "Node") -> "Node":
    return gradient(node).get(x, node.table.zero)


def _plain(node: "Node", x: "Node") -> "Node":
    """With like terms collected."""
    try:
        return collected(x.table, reduced(expanded(node)))
    except (TooLong, ZeroDivisionError):
        return node
