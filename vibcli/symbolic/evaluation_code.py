"""`evaluate` as a function that is compiled: the same operations in the same order, so the same numbers.

In floats it calls the functions of `math` themselves; where one raises, all is evaluated with NaN in its place.
The source is made of slots and the repr of floats alone; functions, numbers and names of symbols are handed to it.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.floats import ELEMENTARY, UNDEFINED, Floats
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.defined_functions import DefinedFunction
    from vibcli.symbolic.node import Node

AT_ONCE = 200           # terms of a sum or factors of a product in one line


def in_floats(nodes: "Sequence[Node]", order: "Sequence[Node]") -> Callable[..., list[float]]:
    """({symbol name: float}, arithmetic) ↦ the values of `nodes`, as `evaluate(nodes, Floats, values)` gives them;
    `order`: all parts of them, each after its own."""
    guarded = cache(lambda: in_any_arithmetic(nodes, order))
    source = FloatSource(undefined=UNDEFINED, guarded=lambda values: guarded()(values, Floats))
    return source.function(nodes, order, "v,_")


def in_any_arithmetic(nodes: "Sequence[Node]", order: "Sequence[Node]") -> Callable[..., list[Any]]:
    """({symbol name: number}, arithmetic) ↦ the values of `nodes`, as `evaluate` gives them in that arithmetic."""
    return _SourceInAny().function(nodes, order, "v,a")


class FloatSource:
    """Lines that compute in floats; `slots`: {node: slot} of what is known; `given`: what they call by name."""

    opening, closing = " try:\n", " except undefined:\n  return guarded(v)\n"

    def __init__(self, slots: "Mapping[Node, str] | Sequence[Any]" = (), **given: Any) -> None:
        self.slots, self.lines = dict(slots), []
        self.space: dict[str, Any] = {"nan": float("nan"), "inf": float("inf"), "power": Floats.power,
                                      "sqrt": math.sqrt, **given}

    def function(self, nodes: "Sequence[Node]", order: "Sequence[Node]", head: str) -> Callable[..., Any]:
        for node in order:
            self.add(node)
        return self.compiled(head, f"[{','.join(self.slots[node] for node in nodes)}]")

    def compiled(self, head: str, result: str) -> Callable[..., Any]:
        """The function of what is written."""
        body = "".join(f"  {line}\n" for line in self.lines)
        code = compile(f"def f({head}):\n{self.opening}{body}  return {result}\n{self.closing}", "<values>", "exec")
        exec(code, self.space)      # slots and floats only
        found: Callable[..., Any] = self.space["f"]
        return found

    def add(self, node: "Node") -> None:
        """Write what computes a node, those below it being written."""
        self.slots[node] = slot = f"x{len(self.slots)}"
        definition = node.table.definitions.get(node) if node.op == "symbol" else None
        text = self._defined(node, definition) if definition is not None else getattr(self, "_" + node.op)(node)
        self.lines.append(f"{slot}={text}")

    def _given(self, kind: str, value: object) -> str:
        """The name under which something is handed to the source."""
        name = f"{kind}{len(self.space)}"
        self.space[name] = value
        return name

    def _constant(self, value: "Fraction | int") -> str:
        return f"({Floats.number(value)!r})"

    def _defined(self, node: "Node", definition: "Node") -> str:
        return self.slots[definition]

    def _number(self, node: "Node") -> str:
        return self._constant(node.coefficient)

    def _pi(self, node: "Node") -> str:
        return repr(Floats.pi)

    def _symbol(self, node: "Node") -> str:
        return f"v[{self._given('n', node.name)}]"

    def _sum(self, node: "Node") -> str:
        terms = [self.slots[part] if c == 1 else f"{self._constant(c)}*{self.slots[part]}" for part, c in node.args]
        if node.coefficient:
            terms.insert(1, self._constant(node.coefficient))
        return self._joined(terms, "+")

    def _product(self, node: "Node") -> str:
        factors = [] if node.coefficient == 1 else [self._constant(node.coefficient)]
        for base, exponent in node.args:
            slot = self.slots[base]
            factors.append(slot if exponent == 1 else self._power(slot, exponent))
        return self._joined(factors, "*")

    def _power(self, slot: str, exponent: "Fraction | int") -> str:
        if exponent.denominator == 1:
            return f"{slot}**{int(exponent)}"
        return f"sqrt({slot})" if exponent == HALF else f"power({slot},{self._given('e', exponent)})"

    def _joined(self, parts: list[str], sign: str) -> str:
        """All of them, from left to right, long ones in lines of their own."""
        while len(parts) > AT_ONCE:
            slot = f"y{len(self.lines)}"
            self.lines.append(f"{slot}={sign.join(parts[:AT_ONCE])}")
            parts = [slot, *parts[AT_ONCE:]]
        return sign.join(parts)

    def _call(self, node: "Node") -> str:
        table, args = node.table, [self.slots[arg] for arg in node.args]
        if node.name in table.records:
            order = node.args[1].coefficient if len(node.args) > 1 else 0
            return self._record(node.name, self._of(table.records, node.name), args[0], self._given("o", order))
        if node.name in table.functions:
            return f"{self._called(self._of(table.functions, node.name))}({','.join(args)})"
        return f"{self._function(node.name)}({','.join(args)})"

    def _of(self, known: "dict[str, DefinedFunction]", name: str) -> str:
        return f"{self._given('t', known)}[{self._given('n', name)}]"

    def _record(self, name: str, samples: str, at: str, order: str) -> str:
        return f"{samples}.at({at},{order})"

    def _called(self, function: str) -> str:
        return f"{function}.at"

    def _function(self, name: str) -> str:
        return self._given("f", getattr(math, name) if name in ELEMENTARY else Floats.functions[name])


class _SourceInAny(FloatSource):
    """Lines that compute in the arithmetic `a`."""

    opening = "  number=a.number;power=a.power;functions=a.functions;defined=getattr(a,'defined',None)\n"
    closing = ""

    def _constant(self, value: "Fraction | int") -> str:
        return f"number({self._given('c', value)})"

    def _defined(self, node: "Node", definition: "Node") -> str:
        slot = self.slots[definition]
        return f"{slot} if defined is None else defined({self._given('n', node.name)},{slot})"

    def _pi(self, node: "Node") -> str:
        return "a.pi"

    def _power(self, slot: str, exponent: "Fraction | int") -> str:
        return f"power({slot},{self._given('e', exponent)})"

    def _record(self, name: str, samples: str, at: str, order: str) -> str:
        return f"a.record({self._given('n', name)},{samples})({at},{order})"

    def _called(self, function: str) -> str:
        return f"a.called({function})"

    def _function(self, name: str) -> str:
        return f"functions[{self._given('n', name)}]"
