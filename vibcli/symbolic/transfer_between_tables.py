"""Expressions of one table written again in another."""

from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.expression_graph import reachable


class _Nodes:
    """The nodes of a table as an arithmetic of `evaluate`."""

    def __init__(self, table):
        self.table, self.number, self.pi, self.power = table, table.number, table.pi, table.power
        self.functions = self

    def record(self, name, samples):
        self.table.records[name] = samples
        return lambda u, order: self.table.call(name, u, *([self.number(order)] if order else []))

    def __getitem__(self, name):
        return self.table.power if name == "power" else lambda *args: self.table.call(name, *args)


def copied(nodes, table):
    """The nodes as those of `table`, symbols by their names."""
    symbols = {node.name: table.variable(node.name) if node.mask
               else table.parameter(node.name, node in node.table.positive)
               for node in reachable(nodes) if node.op == "symbol"}
    return evaluate(nodes, _Nodes(table), symbols)
