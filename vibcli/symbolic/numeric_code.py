"""Expressions compiled to Python source with their shared parts computed once, for floats and NumPy arrays alike.

The source is made of our own slot names and the repr of floats alone: no name and no text of a file gets into it.
What bends or jumps with the motion is smooth while its switches σ stay as they are:

    sign u = σ      |u| = σ u      min(a, b) = (a + b − σ (a − b))/2      max(a, b) = (a + b + σ (a − b))/2
    step u = (1 + σ)/2             ramp u = (1 + σ) u/2
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.node import Node

NUMPY = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2", "min": "minimum", "max": "maximum"}
PLAIN = ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "log", "power", "abs",
         "sign", "min", "max")
SWITCHED = ("abs", "sign", "min", "max", "step", "ramp")
LONGEST = 40            # terms on one line


class Source:
    """Lines of assignments to slots that compute expressions, given {symbol: slot} and the values of parameters.
    switches: {argument: slot} of the sign of each argument, to which unknown ones are added; None: |u|, sign u, min,
    max and pulses are what they are. called: {name: (slot, function)} of the records and defined functions. constants:
    {node: value} of what is known already. named: constants are written as slots, which have other values with other
    data."""

    def __init__(self, slots: "Mapping[Node, str]", floats: Mapping[str, float], switches: "dict[Node, str] | None",
                 constants: "Mapping[Node, float] | Sequence[Any]" = (), named: bool = False) -> None:
        self.slots, self.floats, self.switches, self.named = dict(slots), floats, switches, named
        self.lines, self.constants, self.called, self._data = [], dict(constants), {}, {}

    def add(self, nodes: Any) -> list[str]:
        """Write what computes the nodes; their slots or constants are returned as texts."""
        parts = reachable(nodes, self.slots)
        known = [part for part in parts if not part.mask and part not in self.constants]
        self.constants.update(zip(known, evaluate(known, Floats, self.floats), strict=True))
        for part in parts:
            if part.mask and part not in self.slots:
                text = getattr(self, "_" + part.op)(part)
                self.slots[part] = slot = f"x{len(self.slots)}"
                self.lines.append(f"{slot}={text}")
        return [self.text(node) for node in nodes]

    def text(self, node: Any) -> str:
        return self.slots[node] if node.mask else self._constant(lambda constants: constants[node])

    def values(self, floats: Mapping[str, float], changed: Callable[[float], float]) -> dict[str, float]:
        """{slot: value} of the constants that have one, for these values of parameters, each changed."""
        constants = dict(zip(self.constants, evaluate(list(self.constants), Floats, floats), strict=True))
        return {slot: changed(_float(of(constants))) for slot, of in self._data.items()}

    def _constant(self, of: Callable[..., Any]) -> str:
        """A constant, as it follows from others, as source."""
        if not self.named:
            return number(of(self.constants))
        slot = f"k{len(self._data)}"
        self._data[slot] = of
        return slot

    def _term(self, of: Callable[..., Any], factors: str = "") -> str:
        """The same times factors, with its sign."""
        if not self.named:
            return _signed(of(self.constants), factors)
        return f"+{self._constant(of)}" + (f"*{factors}" if factors else "")

    def _symbol(self, node: "Node") -> None:
        raise KeyError(node.name)

    def _sum(self, node: "Node") -> str:
        def total(constants: "Mapping[Node, float]") -> "float | Fraction":
            kept: float | Fraction = sum(c * constants[part] for part, c in node.args if not part.mask)
            return node.coefficient + kept

        terms = [self._term(lambda _, c=c: c, self.slots[part]) for part, c in node.args if part.mask]
        terms.sort(key=lambda term: term[0] == "-")
        if self.named or total(self.constants):
            terms.append(self._term(total))
        while len(terms) > LONGEST:
            slot = f"y{len(self.lines)}"
            self.lines.append(f"{slot}=" + "".join(terms[:LONGEST]).removeprefix("+"))
            terms = ["+" + slot, *terms[LONGEST:]]
        return "".join(terms).removeprefix("+")

    def _product(self, node: "Node") -> str:
        def factor(constants: "Mapping[Node, float]") -> float:
            value = Floats.number(node.coefficient)
            for base, e in node.args:
                if not base.mask:
                    value *= Floats.power(constants[base], e)
            return value

        above, below = [], []
        for base, e in node.args:
            if base.mask:
                bent = self.switches is not None and _never_negative(base)
                (above if e > 0 else below).extend(_powers(self.slots[base], abs(e), bent))
        if len(above) + len(below) > LONGEST:
            above += [f"(1.0/{slot})" for slot in below]
            return "*".join([self._constant(factor), *(f"({'*'.join(above[i:i + LONGEST])})"
                                                       for i in range(0, len(above), LONGEST))])
        text = self._term(factor, "*".join(above)).removeprefix("+")
        return text + (f"/({'*'.join(below)})" if len(below) > 1 else f"/{below[0]}" if below else "")

    def _call(self, node: "Node") -> str:
        args = [self.text(arg) for arg in node.args]
        if self.switches is not None and node.name in SWITCHED:
            return self._bent(node, args)
        table = node.table
        called = table.records.get(node.name) or table.functions.get(node.name)
        kinks = table.functions[node.name].kinks(node) if self.switches is not None and (
            node.name in table.functions) else ()
        if kinks:
            slot, _ = self.called.setdefault(node.name, (f"r{len(self.called)}", called.on_senses))
            return f"{slot}(({','.join(args)},),({','.join(map(self._switch, kinks))},))"
        if called is not None:
            slot, _ = self.called.setdefault(node.name, (f"r{len(self.called)}", called.on_arrays))
            return f"{slot}({','.join(args)})"
        return f"{NUMPY.get(node.name, node.name)}({','.join(args)})"

    def _bent(self, node: "Node", args: Sequence[str]) -> str:
        """A function that bends or jumps, by its switch."""
        if node.name in ("min", "max"):
            a, b = node.args
            if not (a - b).mask:
                larger = evaluate([a - b], Floats, self.floats)[0] > 0
                return args[0] if larger == (node.name == "max") else args[1]
            sense, sign = self._switch(a - b), "+" if node.name == "max" else "-"
            return f"0.5*({args[0]}+{args[1]}{sign}{sense}*({args[0]}-{args[1]}))"
        sense = self._switch(node.args[0])
        return {"sign": sense, "abs": f"{sense}*{args[0]}", "step": f"0.5*(1.0+{sense})",
                "ramp": f"0.5*(1.0+{sense})*{args[0]}"}[node.name]

    def _switch(self, argument: "Node") -> str:
        """The slot of sign(argument), its value where that is one at all times; of −u it is that of u, negative."""
        sign = argument.table.call("sign", argument)
        if sign.op == "number":
            return number(sign.coefficient)
        if sign.op == "call":
            return self.switches.setdefault(sign.args[0], f"g{len(self.switches)}")
        return "(-" + self._switch(-argument) + ")"


def number(value: Any) -> str:
    """A rational or float as source: the repr of a float."""
    value = _float(value)
    return f"({value!r})" if value < 0 else repr(value) if value - value == 0 else "nan"


def _float(value: "float | Fraction") -> float:
    return value if isinstance(value, float) else Floats.number(value)


def _signed(c: "float | Fraction", factors: str = "") -> str:
    """+c·factors as source, with its sign."""
    c = _float(c)
    if abs(c) == 1 and factors:
        return ("-" if c < 0 else "+") + factors
    if c != c or c in (float("inf"), float("-inf")):
        return "+nan"
    return f"{'-' if c < 0 else '+'}{abs(c)!r}" + (f"*{factors}" if factors else "")


def rooted(nodes: "Sequence[Node]") -> bool:
    """Is a root of |u|, or of what is u on one side alone, in them? It has no series at u = 0."""
    return any(_never_negative(base) and e.denominator != 1 for node in reachable(nodes) if node.op == "product"
               for base, e in node.args)


def _never_negative(base: "Node") -> bool:
    """Is it |u|, or the part of u on one side? Smooth beyond its zero, where a step ends before the zero is found, it
    is negative; its roots go on there as those of its size."""
    return base.op == "call" and (base.name in ("abs", "ramp") or (
        base.name == "max" and any(arg.is_zero for arg in base.args)))


def _powers(slot: str, exponent: "Fraction | int", bent: bool = False) -> list[str]:
    """Factors of slot^exponent, exponent > 0."""
    if exponent.denominator == 1 and exponent <= 4:
        return [slot] * int(exponent)
    if exponent.denominator == 1:
        return [f"{slot}**{int(exponent)}"]
    size = f"abs({slot})" if bent else slot
    if exponent == HALF:
        return [f"sqrt({size})"]
    if exponent.denominator == 2 and exponent <= 4:
        return [slot] * int(exponent - HALF) + [f"sqrt({size})"]
    return [f"{size}**{float(exponent)!r}"]


def function(head: str, lines: Sequence[str], result: str, called: Iterable[Any] = ()) -> Callable[..., Any]:
    """The function of a text made of slots; NumPy's functions act on floats and arrays. `called`: (slot, function)."""
    return made(code(head, lines, result), called)


def code(head: str, lines: Sequence[str], result: str) -> Any:
    """The code of this function, to be made with constants or functions of others."""
    body = "".join(f"    {line}\n" for line in lines)
    return compile(f"def f({head}):\n{body}    return {result}\n", "<motion>", "exec")


def made(of: Any, called: Iterable[Any]) -> Callable[..., Any]:
    """The function of a code, given the (slot, value) of what it calls or holds."""
    space = {**_functions(), **dict(called)}
    exec(of, space)       # slots and floats only
    found: Callable[..., Any] = space["f"]
    return found


@cache
def _functions() -> dict[str, Callable[..., Any]]:
    import numpy as np

    from vibcli.symbolic.discontinuous_functions import on_arrays

    return {NUMPY.get(name, name): getattr(np, NUMPY.get(name, name)) for name in (*PLAIN, "sqrt", "nan")} | on_arrays()
