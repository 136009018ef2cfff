"""Where expressions bend or jump: arguments of |u|, sign u, min … that vanish there, and points of functions that are
defined piece by piece."""

from typing import TYPE_CHECKING

from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.numeric_code import SWITCHED

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from vibcli.symbolic.node import Node



def kinks_at(node: "Node") -> "Iterable[Node]":
    """What vanishes where a call itself bends or jumps."""
    if node.op != "call":
        return ()
    if node.name in SWITCHED:
        return (node.args[0] - node.args[1] if node.name in ("min", "max") else node.args[0],)
    function = node.table.functions.get(node.name)
    return () if function is None else function.kinks(node)


def kinks_of(nodes: "Sequence[Node]", q: "Node") -> "list[Node]":
    """What vanishes where expressions bend or jump as functions of q."""
    found: dict[Node, None] = {}
    for part in reachable(nodes):
        if part.mask & q.mask:
            for u in kinks_at(part):
                if u.mask & q.mask and -u not in found:
                    found[u] = None
    return list(found)
