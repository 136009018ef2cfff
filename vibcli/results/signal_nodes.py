"""Signals as nodes: names that are read off a motion may prove to be one and the same."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import ExpressionError

if TYPE_CHECKING:
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node


def node_of_signal(tree: Any, table: "Table", symbol: "Callable[..., Node]") -> "Node":
    """The node of a signal; PhysicsError where a difference of what is one is divided by or has its logarithm taken."""
    try:
        node = lower(tree, table, symbol)
    except ExpressionError as error:
        raise _refused("divides by", error.hint) from None
    if any(part.name == "log" and part.args[0].is_zero for part in reachable([node])):
        raise _refused("takes the logarithm of")
    return node


def _refused(verb: str, hint: str = "look for a difference that vanishes") -> PhysicsError:
    return PhysicsError(f"this signal {verb} what is zero, or lost in rounding, all along", hint)
