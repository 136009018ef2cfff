"""`evaluate` in floats as a function that is compiled: the same operations in the same order, so the same numbers.

The source is made of slots and the repr of floats alone; functions, exponents and names of symbols are handed to it.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.evaluation import Floats
from vibcli.symbolic.expression_graph import evaluable

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

AT_ONCE = 200           # terms of a sum or factors of a product in one line


def compiled(nodes: "Sequence[Node]") -> Callable[[Mapping[str, float]], tuple[float, ...]]:
    """{symbol name: float} ↦ the values of `nodes`, as `evaluate(nodes, Floats, values)` gives them."""
    source = _FloatSource()
    for node in evaluable(nodes):
        source.add(node)
    result = "".join(f"{source.slots[node]}," for node in nodes)
    body = "".join(f"    {line}\n" for line in source.lines)
    code = compile(f"def f(v):\n{body}    return ({result})\n", "<floats>", "exec")      # slots and floats only
    exec(code, source.space)
    return source.space["f"]


class _FloatSource:
    def __init__(self):
        self.slots, self.lines = {}, []
        self.space: dict[str, Any] = {"nan": float("nan"), "inf": float("inf"), "power": Floats.power}

    def add(self, node: "Node") -> None:
        """Write what computes a node, those below it being written."""
        self.slots[node] = slot = f"x{len(self.slots)}"
        definition = node.table.definitions.get(node) if node.op == "symbol" else None
        text = self.slots[definition] if definition is not None else getattr(self, "_" + node.op)(node)
        self.lines.append(f"{slot}={text}")

    def _given(self, kind, value):
        """The name under which something is handed to the source."""
        name = f"{kind}{len(self.space)}"
        self.space[name] = value
        return name

    def _number(self, node):
        return f"({Floats.number(node.coefficient)!r})"

    def _pi(self, node):
        return repr(Floats.pi)

    def _symbol(self, node):
        return f"v[{self._given('n', node.name)}]"

    def _sum(self, node):
        terms = [self.slots[part] if c == 1 else f"({Floats.number(c)!r})*{self.slots[part]}" for part, c in node.args]
        if node.coefficient:
            terms.insert(1, f"({Floats.number(node.coefficient)!r})")
        return self._joined(terms, "+")

    def _product(self, node):
        factors = [] if node.coefficient == 1 else [f"({Floats.number(node.coefficient)!r})"]
        for base, exponent in node.args:
            slot = self.slots[base]
            factors.append(slot if exponent == 1 else f"power({slot},{self._given('e', exponent)})")
        return self._joined(factors, "*")

    def _joined(self, parts, sign):
        """All of them, from left to right, long ones in lines of their own."""
        while len(parts) > AT_ONCE:
            slot = f"y{len(self.lines)}"
            self.lines.append(f"{slot}={sign.join(parts[:AT_ONCE])}")
            parts = [slot, *parts[AT_ONCE:]]
        return sign.join(parts)

    def _call(self, node):
        table, args = node.table, [self.slots[arg] for arg in node.args]
        if node.name in table.records:
            order = node.args[1].coefficient if len(node.args) > 1 else 0
            return f"{self._given('r', table.records[node.name].at)}({args[0]},{self._given('o', order)})"
        function = (Floats.called(table.functions[node.name]) if node.name in table.functions
                    else Floats.functions[node.name])
        return f"{self._given('f', function)}({','.join(args)})"
