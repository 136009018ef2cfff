"""Laws that are one power: F = c |x|ⁿ sign x."""

from fractions import Fraction
from typing import TYPE_CHECKING

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
