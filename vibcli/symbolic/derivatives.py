"""Derivatives and substitution, each memoised: a shared part is treated once."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from operator import attrgetter, is_, itemgetter
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.expression_graph import dependent, reachable
from vibcli.symbolic.node import Node, union
from vibcli.symbolic.rationals import HALF, ONE

if TYPE_CHECKING:
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.variable_sets import VariableSet

_CONSTANT: dict[Node, Node] = {}        # the gradient of what depends on no variable
FEW = 64        # symbols whose variables are looked for: of many that takes longer than to walk over all


def gradient(node: Node) -> dict[Node, Node]:
    """{variable: ∂node/∂variable} for every variable that the node depends on. Memoised on the node."""
    if node.gradient is None:
        for part in _unfinished(node):
            part.keep_gradient(_RULES[part.op](part))
    return node.gradient


def _unfinished(node: Node) -> list[Node]:
    seen, pending = set(), [node]
    while pending:
        part = pending.pop()
        if part in seen or part.gradient is not None:
            continue
        if not part.mask:
            part.keep_gradient(_CONSTANT)
            continue
        seen.add(part)
        pending += part.parts
    return sorted(seen, key=attrgetter("index"))


def _collect(table: "Table", pairs: Sequence[tuple[Node, Fraction | int | Node]]) -> dict[Node, Node]:
    """Σ weight·(∂part/∂v) by variable, of (part, weight node or rational) pairs."""
    terms = {}
    for part, weight in pairs:
        for variable, slope in part.gradient.items():
            term = (slope * weight, ONE) if weight.__class__ is Node else (slope, weight)
            terms.setdefault(variable, []).append(term)
    found = {variable: table.sum(*parts) for variable, parts in terms.items()}
    return {variable: slope for variable, slope in found.items() if not slope.is_zero}


def _symbol(node: Node) -> dict[Node, Node]:
    return {node: node.table.one} if node.mask else {}


def _sum(node: Node) -> dict[Node, Node]:
    return _collect(node.table, node.args)


def _product(node: Node) -> dict[Node, Node]:
    table = node.table
    return _collect(table, [(_inside(base, power), table.scaled(table.product((node, ONE), (base, -ONE)), power))
                            for base, power in node.args if base.mask])


def _inside(base: Node, power: Fraction | int) -> Node:
    """What is differentiated of a factor: of max(u, 0)ⁿ, min(u, 0)ⁿ, ramp(u)ⁿ with n > 1, which are smooth and whose
    slopes n max(u, 0)ⁿ⁻¹ u′ … vanish where they do, it is u."""
    if power > 1 and base.op == "call" and base.name in ("max", "min", "ramp"):
        args: list[Node] = [arg for arg in base.args if not arg.is_zero]
        if len(args) == 1:
            return args[0]
    return base


def _call(node: Node) -> dict[Node, Node]:
    if not node.mask:
        return {}
    if node.name in node.table.functions:
        function = node.table.functions[node.name]
        return _collect(node.table, [(arg, function.slope(node, i)) for i, arg in enumerate(node.args) if arg.mask])
    if node.name == "log" and node.args[0].name == "cosh":      # which floats lose in sinh u/cosh u of a large u
        u, = node.args[0].args
        return _collect(node.table, [(u, node.table.call("tanh", u))])
    outer = _OUTER.get(node.name, _higher)(node, *node.args)
    return _collect(node.table, [(arg, slope) for arg, slope in zip(node.args, outer, strict=True) if arg.mask])


_RULES: dict[str, Callable[[Node], dict[Node, Node]]] = {
    "number": lambda node: {}, "pi": lambda node: {}, "symbol": _symbol, "sum": _sum, "product": _product,
    "call": _call}


def _extreme(sign: int) -> Callable[[Node, Node, Node], tuple[Node, Node]]:
    def slopes(node: Node, a: Node, b: Node) -> "tuple[Node, Node]":
        step = node.table.call("sign", a - b) * Fraction(sign, 2)
        return (step + HALF, HALF - step)
    return slopes


def _sign_slope(node: Node, u: Node) -> tuple[Node]:
    """The jump of sign u, by 2 where a function u of the time alone vanishes; of other kinks see kinks.py."""
    time = node.table.time
    return (node.table.call("impulse", u) * 2 if time is not None and u.mask == time.mask else node.table.zero,)


def _higher(node: Node, u: Node, order: Node | None = None) -> tuple[Node, ...]:
    """The next rate of an impulse, or of a train of jumps: the same function with its order as second argument."""
    following = node.table.number(1) if order is None else order + 1
    slope = node.table.call(node.name, u, following)
    return (slope,) if order is None else (slope, node.table.zero)


_OUTER: dict[str, Callable[..., tuple[Node, ...]]] = {
    "sin": lambda node, u: (node.table.call("cos", u),),
    "cos": lambda node, u: (-node.table.call("sin", u),),
    "tan": lambda node, u: (node * node + 1,),
    "asin": lambda node, u: ((1 - u * u) ** -HALF,),
    "acos": lambda node, u: (-((1 - u * u) ** -HALF),),
    "atan": lambda node, u: (1 / (u * u + 1),),
    "atan2": lambda node, y, x: (x / (x * x + y * y), -(y / (x * x + y * y))),
    "sinh": lambda node, u: (node.table.call("cosh", u),),
    "cosh": lambda node, u: (node.table.call("sinh", u),),
    "tanh": lambda node, u: (1 - node * node,),
    "exp": lambda node, u: (node,),
    "log": lambda node, u: (1 / u,),
    "abs": lambda node, u: (node.table.call("sign", u),),
    "sign": _sign_slope,
    "step": lambda node, u: (node.table.call("impulse", u),),
    "ramp": lambda node, u: (node.table.call("step", u),),
    "impulse": _higher,
    "square": _higher,
    "sawtooth": _higher,
    "min": _extreme(-1),
    "max": _extreme(1),
    "power": lambda node, base, exponent: (exponent * node.table.power(base, exponent - 1),
                                           node * node.table.call("log", base)),
}


def substitute(nodes: Any, values: Mapping[Node, Node]) -> list[Node]:
    """The nodes with each symbol in `values` ({symbol: node}) replaced; parts without those symbols are kept."""
    changed = {}
    for node in _held(nodes, values):
        if node in values:
            changed[node] = values[node]
        elif node.parts:
            parts = [changed.get(part, part) for part in node.parts]
            if not all(map(is_, parts, node.parts)):
                changed[node] = _rebuilt(node, parts)
    return [changed.get(node, node) for node in nodes]


def _held(nodes: Sequence[Node], values: Mapping[Node, Node]) -> list[Node]:
    """The nodes below `nodes` in which one of a few symbols may be, in an order of evaluation."""
    masks: list[VariableSet | int] = [symbol.mask for symbol in values] if len(values) <= FEW else [0]
    return dependent(nodes, union(masks)) if all(masks) else reachable(nodes)


def _rebuilt(node: Node, parts: Sequence[Node]) -> Node:
    """The same of other parts."""
    table = node.table
    if node.op == "call":
        return table.power(*parts) if node.name == "power" else table.call(node.name, *parts)
    build, factors = table.sum if node.op == "sum" else table.product, map(itemgetter(1), node.args)
    if node.coefficient == (node.op == "product"):      # what adds nothing, or multiplies by one
        return build(*zip(parts, factors, strict=True))
    return build((table.number(node.coefficient), ONE), *zip(parts, factors, strict=True))
