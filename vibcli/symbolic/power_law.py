"""Laws that are powers, F = c |x|ⁿ sign x, and sums of such."""

from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.symbolic.normal_form import TooLong, expanded, reduced

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def power_of(force: "Node", x: "Node") -> "tuple[Node, Fraction] | None":
    """(c, n) of c |x|ⁿ sign x, n > 0; None of another function."""
    table = force.table
    factors = force.args if force.op == "product" else ((force, 1),)
    degree, odd, fixed = Fraction(0), Fraction(0), []
    for base, e in factors:
        if not base.mask & x.mask:
            fixed.append((base, e))
        elif base is x:
            degree, odd = degree + e, odd + e
        elif base.op == "call" and base.args[0] is x and base.name in ("abs", "sign"):
            degree, odd = (degree + e, odd) if base.name == "abs" else (degree, odd + e)
        else:
            return None
    if degree <= 0 or odd.denominator != 1 or odd % 2 == 0:
        return None
    coefficient = force.coefficient if force.op == "product" else 1
    return table.product((table.number(coefficient), 1), *fixed), degree


def odd_powers(law: "Node", d: "Node") -> "dict[Fraction | int, Node] | None":
    """{n: c} of a sum of c |d|ⁿ sign d; None of another law."""
    try:
        terms = reduced(expanded(law))
    except (TooLong, ZeroDivisionError):
        return None
    table, found = law.table, {}
    for monomial, value in terms.items():
        degree, odd, fixed = 0, 0, []
        for base, e in monomial:
            if base is d or (base.name in ("abs", "sign") and base.args[0] is d):
                degree += 0 if base.name == "sign" else e
                odd += 0 if base.name == "abs" else e
            elif base.mask & d.mask:
                return None
            else:
                fixed.append((base, e))
        if not (odd % 2 == 1 and degree > 0):
            return None
        found.setdefault(degree, []).append(table.product((table.number(value), 1), *fixed))
    return {degree: table.total(parts) for degree, parts in found.items()}


def cubic_root(n: "Node", b: "Node") -> "Node":
    """The real d with d + b d³ = n, b > 0, by Cardano's formula in the form that loses no digits:

        d = 3 n/(w² + 1 + 1/w²),    w³ = u + √(1 + u²),    u = ½ √(27 b) |n|"""
    table = n.table
    u = table.sqrt(27 * b) * table.call("abs", n) / 2
    w = (u + table.sqrt(1 + u * u)) ** Fraction(1, 3)
    return 3 * n / (w**2 + 1 + w**-2)
