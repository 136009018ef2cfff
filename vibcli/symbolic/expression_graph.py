"""The walk over the shared parts of expressions."""

from collections.abc import Mapping, Sequence
from operator import attrgetter
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.defined_functions import DefinedFunction
    from vibcli.symbolic.node import Node

_index = attrgetter("index")


def evaluable(nodes: Any) -> "list[Node]":
    """All that is reachable, what symbols stand for included."""
    seen, pending = set(), list(nodes)
    while pending:
        node = pending.pop()
        if node not in seen:
            seen.add(node)
            pending += node.parts
            if node.op == "symbol" and node in node.table.definitions:
                pending.append(node.table.definitions[node])
    return sorted(seen, key=_index)


def reachable(nodes: Any, known: "Mapping[Node, str] | Sequence[Any]" = ()) -> "list[Node]":
    """All nodes below `nodes`, themselves included, in an order of evaluation; without what only `known` ones need."""
    seen, pending = set(), list(nodes)
    while pending:
        node = pending.pop()
        if node not in seen:
            seen.add(node)
            if node not in known:
                pending += node.parts
    return sorted(seen, key=_index)


def dependent(nodes: Any, variables: Any) -> "list[Node]":
    """Those of the same that depend on variables of a set."""
    seen, pending = set(), list(nodes)
    while pending:
        node = pending.pop()
        if node.mask & variables and node not in seen:
            seen.add(node)
            pending += node.parts
    return sorted(seen, key=_index)


def called_functions(nodes: "Sequence[Node]") -> "list[DefinedFunction]":
    """The functions that elements define and expressions call: they have no form in the language of scenes."""
    return [part.table.functions[part.name] for part in reachable(nodes)
            if part.op == "call" and part.name in part.table.functions]


def fingerprint(nodes: "Sequence[Node]") -> tuple[tuple[Any, ...], ...]:
    """What tells expressions of different tables apart: equal of those that were built alike, in the same order."""
    order: dict[Node, Fraction | int] = {node: number for number, node in enumerate(evaluable(nodes))}

    def told(arg: "Node | tuple[Node, Fraction | int]") -> "tuple[Fraction | int, Fraction | int | None]":
        part, factor = arg if isinstance(arg, tuple) else (arg, None)
        return order.get(part, part.coefficient), factor

    return (*((node.op, node.name, node.coefficient, node.mask, node in node.table.positive, *map(told, node.args))
              for node in order), tuple(order[node] for node in nodes))
