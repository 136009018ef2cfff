"""Expressions compiled to Python source with their shared parts computed once, for floats and NumPy arrays alike.

The source is made of our own slot names and the repr of floats alone: no name and no text of a file gets into it. Parts
that depend on the time alone are a function of their own, so that an iteration at fixed instants computes them once.
What bends or jumps with the motion is smooth while its switches σ stay as they are:

    sign u = σ      |u| = σ u      min(a, b) = (a + b − σ (a − b))/2      max(a, b) = (a + b + σ (a − b))/2
    step u = (1 + σ)/2             ramp u = (1 + σ) u/2
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.discontinuous_functions import PULSES
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    import numpy as np

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
    {node: value} of what is known already. changed: what each constant is written as instead, None: itself."""

    def __init__(self, slots: "Mapping[Node, str]", floats: Mapping[str, float], switches: "dict[Node, str] | None",
                 constants: "Mapping[Node, float] | Sequence[Any]" = (),
                 changed: Callable[[float], float] | None = None):
        self.slots, self.floats, self.switches, self.changed = dict(slots), floats, switches, changed
        self.lines, self.constants, self.called = [], dict(constants), {}

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
        return self.slots[node] if node.mask else number(self._written(self.constants[node]))

    def _written(self, value):
        """A constant as it is written."""
        if self.changed is None:
            return value
        return self.changed(value if isinstance(value, float) else Floats.number(value))

    def _symbol(self, node):
        raise KeyError(node.name)

    def _sum(self, node):
        total = node.coefficient + sum(c * self.constants[part] for part, c in node.args if not part.mask)
        terms = [_signed(self._written(c), self.slots[part]) for part, c in node.args if part.mask]
        terms.sort(key=lambda term: term[0] == "-")
        if total:
            terms.append(_signed(self._written(total)))
        while len(terms) > LONGEST:
            slot = f"y{len(self.lines)}"
            self.lines.append(f"{slot}=" + "".join(terms[:LONGEST]).removeprefix("+"))
            terms = ["+" + slot, *terms[LONGEST:]]
        return "".join(terms).removeprefix("+")

    def _product(self, node):
        factor, above, below = Floats.number(node.coefficient), [], []
        for base, e in node.args:
            if not base.mask:
                factor *= Floats.power(self.constants[base], e)
            else:
                bent = self.switches is not None and _never_negative(base)
                (above if e > 0 else below).extend(_powers(self.slots[base], abs(e), bent))
        factor = self._written(factor)
        if len(above) + len(below) > LONGEST:
            above += [f"(1.0/{slot})" for slot in below]
            return "*".join([number(factor), *(f"({'*'.join(above[i:i + LONGEST])})"
                                               for i in range(0, len(above), LONGEST))])
        text = _signed(factor, "*".join(above)).removeprefix("+")
        return text + (f"/({'*'.join(below)})" if len(below) > 1 else f"/{below[0]}" if below else "")

    def _call(self, node):
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

    def _bent(self, node, args):
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

    def _switch(self, argument):
        """The slot of sign(argument), its value where that is one at all times; of −u it is that of u, negative."""
        sign = argument.table.call("sign", argument)
        if sign.op == "number":
            return number(sign.coefficient)
        if sign.op == "call":
            return self.switches.setdefault(sign.args[0], f"g{len(self.switches)}")
        return "(-" + self._switch(-argument) + ")"


def number(value: Any) -> str:
    """A rational or float as source: the repr of a float."""
    if not isinstance(value, float):
        value = Floats.number(value)
    return f"({value!r})" if value < 0 else repr(value) if value - value == 0 else "nan"


def _signed(c, factors=""):
    """+c·factors as source, with its sign."""
    c = Floats.number(c) if not isinstance(c, float) else c
    if abs(c) == 1 and factors:
        return ("-" if c < 0 else "+") + factors
    if c != c or c in (float("inf"), float("-inf")):
        return "+nan"
    return f"{'-' if c < 0 else '+'}{abs(c)!r}" + (f"*{factors}" if factors else "")


def rooted(nodes: "Sequence[Node]") -> bool:
    """Is a root of |u|, or of what is u on one side alone, in them? It has no series at u = 0."""
    return any(_never_negative(base) and e.denominator != 1 for node in reachable(nodes) if node.op == "product"
               for base, e in node.args)


def _never_negative(base):
    """Is it |u|, or the part of u on one side? Smooth beyond its zero, where a step ends before the zero is found, it
    is negative; its roots go on there as those of its size."""
    return base.op == "call" and (base.name in ("abs", "ramp") or (
        base.name == "max" and any(arg.is_zero for arg in base.args)))


def _powers(slot, exponent, bent=False):
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


def function(head: str, lines: Sequence[str], result: str, called: Iterable[Any] = ()) -> Callable:
    """The function of a text made of slots; NumPy's functions act on floats and arrays. `called`: (slot, function)."""
    import numpy as np

    from vibcli.symbolic.discontinuous_functions import on_arrays

    space = {NUMPY.get(name, name): getattr(np, NUMPY.get(name, name)) for name in (*PLAIN, "sqrt", "nan")}
    space.update(on_arrays(), **dict(called))
    body = "".join(f"    {line}\n" for line in lines)
    exec(compile(f"def f({head}):\n{body}    return {result}\n", "<motion>", "exec"), space)  # slots and floats only
    return space["f"]


class Compiled:
    """Expressions of (t, q, v) as functions of arrays over instants: q and v are of shape (coordinates, instants).
    `switches`: {argument: slot}, shared by what is to be smooth; None where |u|, sign u, min and max may bend.
    `prepared(t)`: the parts that depend on the time alone, at the instants t; changed: as that of a Source."""

    def __init__(self, scene: Any, floats: Mapping[str, float], switches: "dict[Node, str] | None", nodes: Any,
                 changed: Callable[[float], float] | None = None):
        time = scene.time
        below = reachable(nodes)
        _require_known(below, time)
        outer = _outermost([part for part in below if part.mask == time.mask and part is not time], below, nodes)
        early = Source({time: "t"}, floats, None, changed=changed)
        prepared = _tuple(early.add(outer))
        self.prepared = function("t", early.lines, prepared, early.called.values()) if outer else _nothing
        slots = {time: "t", **{node: f"c{i}" for i, node in enumerate(outer)}}
        slots |= {node: f"{kind}{i}" for kind, symbols in (("q", scene.q), ("v", scene.v))
                  for i, node in enumerate(symbols)}
        late = Source(slots, floats, switches, early.constants, changed)
        result = late.add(nodes)
        head = [f"{_tuple(f'{kind}{i}' for i in range(len(scene.q)))}={kind}" for kind in "qv"]
        if outer:
            head.append(f"{_tuple(f'c{i}' for i in range(len(outer)))}=c")
        if switches:
            head.append(f"{_tuple(switches.values())}=g[:{len(switches)}]")
        self.count, self.work = len(nodes), len(late.lines)
        self._evaluate = function("t,q,v,g,c", head + late.lines, _tuple(result), late.called.values())

    def __call__(self, t: "np.ndarray", q: Any, v: "np.ndarray", g: "Sequence[float | np.ndarray] | np.ndarray" = (),
                 c: Any = None) -> "tuple[float | np.ndarray, ...]":
        """The values as a tuple of arrays; those of constants are floats. g: the senses of the switches."""
        return self._evaluate(t, q, v, g, self.prepared(t) if c is None else c)

    def rows(self, t: "np.ndarray", q: "np.ndarray", v: "np.ndarray",
             g: "Sequence[float | np.ndarray] | np.ndarray" = (), c: Any = None) -> "np.ndarray":
        """The same of shape (nodes, instants)."""
        import numpy as np

        found = np.empty((self.count, q.shape[1]))
        for i, value in enumerate(self(t, q, v, g, c)):
            found[i] = value
        return found


def _nothing(t):
    """What depends on the time alone where nothing does."""
    return ()


def _tuple(texts):
    return "(" + "".join(text + "," for text in texts) + ")"


def _require_known(below, time):
    """Pulses that repeat, impulses and records are functions of the time."""
    for part in below:
        if part.mask & ~time.mask and (part.name in part.table.records or
                                       (part.name in PULSES and part.name not in SWITCHED)):
            raise PhysicsError(f"{part.name} of what moves is not defined: it is a function of the time",
                               "write it of t, as in square(Omega*t)")


def _outermost(driven, below, nodes):
    """Those of `driven` which something that is not driven is made of, or which are wanted themselves."""
    kept, inner = set(driven), set()
    for part in below:
        if part not in kept and part.mask:
            args = (arg for arg, _ in part.args) if part.op in ("sum", "product") else part.args
            inner.update(arg for arg in args if arg in kept)
    inner.update(node for node in nodes if node in kept)
    return sorted(inner, key=lambda node: node.index)
