"""Roots of quadratics in letters, and determinants."""

from collections.abc import Sequence
from math import gcd
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.normal_form import expanded, textbook
from vibcli.symbolic.radicals import root
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def quadratic_roots(coefficients: "Sequence[Node]", sample: Any) -> "list[Node]":
    """The roots of a λ² + b λ + c or a λ + b, over one denominator, the common rational factor cancelled."""
    if len(coefficients) == 2:
        a, b = coefficients
        return [single(-b / a)]
    a, b, c = coefficients
    table = a.table
    spread = root(b * b - 4 * a * c, [sample])
    whole = spread.coefficient.numerator if spread.op == "product" else 1
    common = gcd(*(_divisor(node) for node in (b, 2 * a)), whole)
    below = textbook(2 * a / common)
    return [table.product((textbook(-b / common) + sign * spread / common, ONE), (below, -ONE)) for sign in (-1, 1)]


def _divisor(node: "Node") -> int:
    """The integer that divides all coefficients of a polynomial; 1 where there are fractions."""
    values = expanded(node).values()
    return gcd(*(v.numerator for v in values)) if all(v.denominator == 1 for v in values) else 1


def determinant(rows: "Sequence[list[Node]]") -> "Node":
    """By expansion along the first row."""
    if len(rows) == 1:
        return rows[0][0]
    total = rows[0][0].table.zero
    for j, entry in enumerate(rows[0]):
        if not entry.is_zero:
            minor = determinant([line[:j] + line[j + 1:] for line in rows[1:]])
            total = total + entry * minor * (-1) ** j
    return total
