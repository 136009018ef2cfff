"""The coordinates of a scene: symbols, rates, values as drawn; what depends on others, is driven or released."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node


class SceneCoordinates(NamedTuple):
    """`names`, and the symbols q, v, a of the coordinates, their velocities and accelerations; `speeds`: {x: dx/dt};
    `symbols`: {(name, number of primes): node} of what a name stands for; `drawn`: {symbol: node as drawn}, and
    `at_rest` the same of rates, the time and what is driven, too.

    While a scene is built they become more.
    """

    table: "Table"
    time: "Node"
    names: list[str]
    q: "list[Node]"
    v: "list[Node]"
    a: "list[Node]"
    speeds: "dict[Node, Node]"
    symbols: "dict[tuple[str, int], Node]"
    drawn: "dict[Node, Node]"
    at_rest: "dict[Node, Node]"

    @classmethod
    def named(cls, names: "Mapping[str, Record]", time: "Node") -> "SceneCoordinates":
        """Coordinates of these names, none of them drawn yet."""
        table, names = time.table, list(names)
        q, v, a = ([table.variable(name + primes) for name in names] for primes in ("", "'", "''"))
        symbols = {(name, primes): node for primes, nodes in enumerate((q, v, a))
                   for name, node in zip(names, nodes, strict=True)}
        return cls(table, time, names, q, v, a, _speeds(q, v, a, time), symbols | {(time.name, 0): time}, {}, {})

    def draw(self, values: "Sequence[Node]") -> None:
        """Let their values as drawn be those of the list `values`."""
        self.drawn.update(zip(self.q, values, strict=True))
        self.at_rest.update({**self.drawn, **dict.fromkeys(self.v, self.table.zero), self.time: self.table.zero})

    def further(self, name: str) -> "Node":
        """One more coordinate, zero as drawn; its symbol."""
        q, v, a = (self.table.variable(name + primes) for primes in ("", "'", "''"))
        self.names.append(name)
        for listed, new in ((self.q, q), (self.v, v), (self.a, a)):
            listed.append(new)
        self.symbols.update({(name, 0): q, (name, 1): v, (name, 2): a})
        self.speeds.update({q: v, v: a})
        self.drawn[q] = self.at_rest[q] = self.at_rest[v] = self.table.zero
        return q

    def keeping(self, independent: "Sequence[Node]") -> "SceneCoordinates":
        """These alone, in this order, as the independent ones."""
        kept = [self.q.index(q) for q in independent]
        names, (q, v, a) = [self.names[i] for i in kept], (
            [listed[i] for i in kept] for listed in (self.q, self.v, self.a))
        return self._replace(names=names, q=q, v=v, a=a, speeds=_speeds(q, v, a, self.time))

    def defining(self, dependent: "Mapping[Node, Node]") -> "SceneCoordinates":
        """Itself where dependent coordinates {symbol: node} are those nodes wherever their names stand."""
        symbols, drawn, at_rest = dict(self.symbols), dict(self.drawn), dict(self.at_rest)
        drawn |= {node: self.drawn[z] for z, node in dependent.items() if node.name == z.name}
        for z, node in dependent.items():
            symbols[z.name, 0] = node
            for primes in (1, 2):
                del symbols[z.name, primes]
            for raw in (z, self.symbols[z.name, 1]):
                del at_rest[raw]
                drawn.pop(raw, None)
            if node.op == "symbol" and node in drawn:
                at_rest[node] = drawn[node]
        return self._replace(symbols=symbols, drawn=drawn, at_rest=at_rest)

    def apart(self) -> "SceneCoordinates":
        """A copy that does not change with this one."""
        return self._replace(symbols=dict(self.symbols), drawn=dict(self.drawn), at_rest=dict(self.at_rest))

    def symbol(self, name: str, primes: int = 0) -> "Node":
        """The node of a coordinate, its velocity or acceleration; of a dependent one, what it equals."""
        if primes and (name, primes) not in self.symbols:
            self.symbols[name, primes] = self.rate(self.symbol(name, primes - 1))
        return self.symbols[name, primes]

    def rate(self, node: "Node") -> "Node":
        """dnode/dt = Σ (∂node/∂x) ẋ over coordinates, velocities and the time."""
        found = self.table.sum(*((slope * self.speeds[x], ONE) for x, slope in gradient(node).items()
                                 if x in self.speeds))
        if "impulse" in self.table.called and found.mask & self.time.mask:
            from vibcli.symbolic.delta_functions import at_impulses

            return at_impulses(found, self.time)
        return found

    def copied(self) -> "SceneCoordinates":
        """A copy that may become more without this one."""
        q, v, a = (listed.copy() for listed in (self.q, self.v, self.a))
        return self.apart()._replace(names=self.names.copy(), q=q, v=v, a=a, speeds=dict(self.speeds))

    def at_drawn(self, *nodes: "Node") -> "list[Node]":
        """The nodes in the drawn position, at rest."""
        return substitute(nodes, self.at_rest) if any(node.mask for node in nodes) else list(nodes)


def _speeds(q: "list[Node]", v: "list[Node]", a: "list[Node]", time: "Node") -> "dict[Node, Node]":
    """{x: dx/dt} of coordinates, velocities and the time."""
    return dict(zip((*q, *v, time), (*v, *a, time.table.one), strict=True))
