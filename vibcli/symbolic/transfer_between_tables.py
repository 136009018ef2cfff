"""Expressions of one table written again in another."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.expression_graph import evaluable

if TYPE_CHECKING:
    from vibcli.symbolic.defined_functions import DefinedFunction
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node


class _Nodes:
    """The nodes of a table as an arithmetic of `evaluate`."""

    def __init__(self, table: "Table") -> None:
        self.table, self.number, self.pi, self.power = table, table.number, table.pi, table.power
        self.functions, self.defined = self, table.defined

    def record(self, name: Any, samples: Sequence[dict[str, float]]) -> "Callable[..., Node]":
        self.table.records[name] = samples
        return lambda u, order: self.table.call(name, u, *([self.number(order)] if order else []))

    def called(self, function: "DefinedFunction") -> "Callable[..., Node]":
        self.table.functions[function.name] = function
        return lambda *args: self.table.call(function.name, *args)

    def __getitem__(self, name: str) -> "Callable[..., Node]":
        return self.table.power if name == "power" else lambda *args: self.table.call(name, *args)


class _PlainNodes(_Nodes):
    """The same, with what symbols stand for written out."""

    def __init__(self, table: "Table") -> None:
        super().__init__(table)
        del self.defined


def written_in(table: "Table", nodes: "Sequence[Node]", values: "Mapping[str, Node]") -> "list[Node]":
    """The nodes as those of `table`, {name of a symbol: node there} being what its symbols become."""
    return evaluate(nodes, _PlainNodes(table), values)


def copied(nodes: "Sequence[Node]", table: "Table") -> "list[Node]":
    """The nodes as those of `table`, symbols by their names."""
    symbols = {node.name: table.variable(node.name) if node.mask
               else table.parameter(node.name, node in node.table.positive)
               for node in evaluable(nodes) if node.op == "symbol"}
    return evaluate(nodes, _Nodes(table), symbols)
