"""∫ f(x) dx of sums of what laws of springs and dampers are made of, by rules; None where no rule fits.

    xⁿ, max(u, 0), min(u, 0) and their products, u = a x + b:  u f/((n + 1) a), n being the degree of f in u
    what begins at u = 0, max(u, 0)ⁿ, ramp(u)ⁿ, step(u) |u|ⁿ:  max(u, 0)ⁿ⁺¹/((n + 1) a), whose slopes are defined at 0
    |u|ⁿ sign u:  |u|ⁿ⁺¹/((n + 1) a)     |u|ⁿ:  u |u|ⁿ/((n + 1) a)
    sin u, cos u, tan u, exp u, sinh u, cosh u, tanh u:  F(u)/a            1/u:  log|u|/a
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.hinges import unnested
from vibcli.symbolic.normal_form import TooLong, collected, expanded, is_zero, reduced
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.node import Node

_DEGREES = {"abs": 1, "sign": 0, "ramp": 1, "step": 0, "min": 1, "max": 1}
_PRIMITIVES = {
    "sin": lambda call, u: -call("cos", u),
    "cos": lambda call, u: call("sin", u),
    "tan": lambda call, u: -call("log", call("cos", u)),
    "exp": lambda call, u: call("exp", u),
    "sinh": lambda call, u: call("cosh", u),
    "cosh": lambda call, u: call("sinh", u),
    "tanh": lambda call, u: call("log", call("cosh", u)),
}


def antiderivative(node: "Node", x: "Node") -> "Node":
    """F(x) with dF/dx = node; None where no rule gives it."""
    node = unnested(node, x)
    found = _of_sum(node, x)
    if found is not None:
        return found
    try:
        return _of_sum(collected(node.table, reduced(expanded(node))), x)
    except (TooLong, ZeroDivisionError):
        return None


def from_zero(node: "Node", x: "Node") -> "Node":
    """∫₀ˣ node dx; None where no rule gives it or it is not defined at 0."""
    found = antiderivative(node, x)
    try:
        start = found and substitute([found], {x: node.table.zero})[0]
    except ZeroDivisionError:
        return None
    if found is None or any(part.name == "log" and part.args[0].is_zero for part in reachable([start])):
        return None
    return found - start


def _of_sum(node: "Node", x: "Node") -> "Node | None":
    table = node.table
    if node.op != "sum":
        return _of_term(node, x)
    parts = [(_of_term(part, x), c) for part, c in node.args]
    if any(part is None for part, _ in parts):
        return None
    return table.sum((x, node.coefficient), *parts)


def _of_term(node: "Node", x: "Node") -> "Node | None":
    """Of a product of factors, those without x taken out."""
    table = node.table
    if not node.mask & x.mask:
        return node * x
    factors = node.args if node.op == "product" else ((node, ONE),)
    fixed = [(base, e) for base, e in factors if not base.mask & x.mask]
    moving = [(base, e) for base, e in factors if base.mask & x.mask]
    constant = table.product((table.number(node.coefficient if node.op == "product" else ONE), ONE), *fixed)
    found = _of_call(moving, x) or _homogeneous(moving, x)
    return None if found is None else constant * found


def _of_call(factors: "list[tuple[Node, Fraction | int]]", x: "Node") -> "Node | None":
    (base, e), *rest = factors
    if rest or e != 1 or base.op != "call" or base.name not in _PRIMITIVES:
        return None
    slope = _slope(base.args[0], x)
    found: Node | None = None if slope is None else _PRIMITIVES[base.name](base.table.call, base.args[0]) / slope
    return found


def _homogeneous(factors: "list[tuple[Node, Fraction | int]]", x: "Node") -> "Node | None":
    """Of a function of the degree n in one u = a x + b."""
    table, u, degree, total = x.table, None, x.table.zero, x.table.one
    for base, e in factors:
        part, n = _degree(base, x)
        slope = None if part is None else _slope(part, x)
        if slope is None or (u is not None and not is_zero(u * slope - part * _slope(u, x))):
            return None
        u, degree = u or part, degree + n * e
        total = total * table.power(base, e)
    odd = _is_odd(factors, u)
    if odd is not None:
        power = table.power(table.call("abs", u), degree + 1) / ((degree + 1) * _slope(u, x)) if not is_zero(
            degree + 1) else None
        if odd or power is None:
            return power
        if degree.op == "number" and degree.coefficient >= 1:
            return u * table.power(table.call("abs", u), degree) / ((degree + 1) * _slope(u, x))
        return table.call("sign", u) * power
    if is_zero(degree + 1):
        return table.call("log", table.call("abs", u)) / _slope(u, x) if len(factors) == 1 else None
    if _begins(factors, u):
        return table.power(table.call("max", u, table.zero), degree + 1) / ((degree + 1) * _slope(u, x))
    return u * total / ((degree + 1) * _slope(u, x))


def _is_odd(factors: "Sequence[tuple[Node, Fraction | int]]", u: "Node") -> bool | None:
    """Of powers of |u|, u and sign u: are they |u|ⁿ sign u, and not |u|ⁿ? None of others, and of powers of u alone."""
    odd, bent = False, False
    for base, e in factors:
        if base.op == "call" and base.name == "power" and base.args[0].op == "call":
            base, e = base.args[0], None
        if base.op == "call" and base.name == "abs" and base.args[0] is u:
            bent = True
        elif e is not None and e.denominator == 1 and (base is u or (
                base.op == "call" and base.name == "sign" and base.args[0] is u)):
            odd, bent = odd != bool(e % 2), bent or base is not u
        else:
            return None
    return odd if bent else None


def _begins(factors: "Sequence[tuple[Node, Fraction | int]]", u: "Node") -> bool:
    """Is it nothing where u < 0, and the positive powers of u where u > 0?"""
    begun = False
    for base, e in factors:
        if base.op == "call" and base.name == "power":
            base, e = base.args[0], None
        args = [arg for arg in base.args if not arg.is_zero] if base.op == "call" else []
        if args == [u] and base.name in ("max", "ramp", "step"):
            begun = True
        elif base is not u and (args != [u] or base.name != "abs"):
            return False
        if e is not None and e < 0:
            return False
    return begun


def _degree(base: "Node", x: "Node") -> "tuple[Node, Node]":
    """(u, degree in it) of a factor; (None, None) where it is no power of a linear u."""
    if base.op != "call":
        return base, base.table.one
    args = [arg for arg in base.args if not arg.is_zero]
    if base.name == "power" and not base.args[1].mask:
        part, n = _degree(base.args[0], x)
        return (None, None) if part is None else (part, n * base.args[1])
    if base.name in _DEGREES and len(args) == 1:
        part, n = _degree(args[0], x)
        return (None, None) if part is None else (part, n * _DEGREES[base.name])
    return None, None


def _slope(u: "Node", x: "Node") -> "Node | None":
    """a of u = a x + b; None where u is not linear in x."""
    slope = gradient(u).get(x)
    return None if slope is None or slope.mask & x.mask else slope
