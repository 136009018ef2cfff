"""Roots in a product: √(2·X)/2 is √(X/2), √X/L is √(X/L²) where X is a quotient, √3/√X has two roots; and the
brackets under them."""

from collections.abc import Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import TYPE_CHECKING, Any

from vibcli.notation.numbers import LARGEST
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import is_measure, rooted_square
from vibcli.symbolic.rationals import HALF, ONE, square_part

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

    Powers = Sequence[tuple[Node, Fraction | int]]


def split(value: Fraction | int, factors: "Sequence[tuple[Node, Any]]") -> tuple[Any, ...]:
    """(value, above, below, under the root above, under it below) of value·Π base^e: lists of (node, exponent > 0)."""
    above, below, root_above, root_below, inside, powers = [], [], [], [], ONE, []
    for base, exponent in (rooted_square(*pair) for pair in factors):
        if base.name == "abs" and exponent.denominator > 1 and abs(exponent) != HALF:
            (above if exponent > 0 else below).append((base, abs(exponent)))
            continue
        if exponent.denominator == 4:
            (root_above if exponent > 0 else root_below).append((base, 2 * abs(exponent)))
            continue
        if exponent.denominator > 2:
            powers.append((base, exponent))
            continue
        if exponent.denominator == 2:
            whole = exponent - HALF if exponent > 0 else exponent + HALF
            if base.op == "number":
                inside *= Fraction(base.coefficient) if exponent > 0 else 1 / Fraction(base.coefficient)
            else:
                (root_above if exponent > 0 else root_below).append((base, ONE))
            exponent = whole
        if exponent > 0:
            above.append((base, exponent))
        elif exponent < 0:
            below.append((base, -exponent))
    if powers:
        d = lcm(*(e.denominator for _, e in powers))
        power = powers[0][0].table.product(*((base, e * d) for base, e in powers)), Fraction(1, d)
        above.insert(place(above, [power]), power)
    outside, inside = square_part(inside)
    value = value * outside
    if root_above or root_below:
        value, inside = _shared(value, inside)
        if value.numerator == 1 and root_above and root_below and not above and _joins(value, below):
            inside = Fraction(inside) / value.denominator**2
            value, root_below, below = ONE, _squares(below, root_below), []
    return value, *_with_number(inside, factors, above, below, root_above, root_below)


def place(above: Any, root_above: "Sequence[tuple[Node, Fraction | int]]") -> int:
    """The place of a root among the factors above the line: numbers first, then letters, and variables after it."""
    if above and all(is_constant(base) for base, _ in root_above):
        return sum(is_constant(base) for base, _ in above)
    return sum(not base.mask for base, _ in above)


def _shared(value: int | Fraction, inside: int | Fraction) -> tuple[int | Fraction, int | Fraction]:
    """The rational outside and that under the root, in which no factor stands below the one and above the other."""
    if inside != 1 and value.denominator <= LARGEST and gcd(inside.numerator, value.denominator) > 1:
        return value.numerator, Fraction(inside) / value.denominator**2
    return value, inside


def _joins(value: int | Fraction, below: "Sequence[tuple[Node, Fraction]]") -> bool:
    """May what stands below the line go under the root? π stays outside, and what may be negative."""
    if not below and value.denominator == 1:
        return False
    return value.denominator <= LARGEST and all(_is_positive(base) for base, _ in below)


def _is_positive(base: "Node") -> bool:
    if base.op == "sum" and not base.mask and base.table.sample is not None:
        try:
            return evaluate([base], Floats, base.table.sample)[0] > 0
        except KeyError:
            return False
    return base.op == "symbol" and base.table.is_positive(base)


def _squares(below: "Sequence[tuple[Node, Fraction]]",
             root_below: "Sequence[tuple[Node, Fraction]]") -> "list[tuple[Node, Fraction]]":
    found = {base: 2 * e for base, e in below}
    for base, e in root_below:
        found[base] = found.get(base, Fraction(0)) + e
    return list(found.items())


def _with_number(inside: int | Fraction, factors: "Sequence[tuple[Node, Any]]",
                 above: "Powers", below: "Powers", root_above: "Powers", root_below: "Powers") -> "tuple[Powers, ...]":
    """The rational under the root put back: numbers alone above a root of letters stand beside it."""
    table, letters_below = factors[0][0].table, bool(root_below)
    if inside.denominator > 1:
        root_below = [(table.number(inside.denominator), ONE), *root_below]
    if inside.numerator > 1:
        root_above = [(table.number(inside.numerator), ONE), *root_above]
    if root_above and letters_below and all(is_constant(base) for base, _ in root_above):
        above = [(table.product(*((base, e * HALF) for base, e in root_above)), ONE), *above]
        root_above = []
    return above, below, root_above, root_below


def is_constant(node: "Node") -> bool:
    """Does a node hold no letter?"""
    return not any(part.op == "symbol" and not is_measure(part) for part in reachable([node]))


def enclosed(text: str) -> bool:
    """Is the text one pair of brackets around everything?"""
    return closing(text, 0) == len(text) - 1


def closing(text: str, at: int) -> int | None:
    """The place of the bracket that closes the one at a place; None where there is none."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == "(") - (text[i] == ")")
        if depth == 0:
            return i if text[at] == "(" else None
    return None
