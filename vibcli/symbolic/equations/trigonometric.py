"""Angles in letters: A sin x + B cos x + C = 0, each from −π to 2π at least."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def angles(terms: Any, x: "Node", sample_zero: Callable[..., bool]) -> "list[Node] | None":
    """The x of Σ terms = 0, {monomial: coefficient}, linear in sin x and cos x up to a common factor of these; None of
    other equations. `sample_zero(node)`: does a coefficient vanish?"""
    table = x.table
    sine, cosine = table.call("sin", x), table.call("cos", x)
    parts = {}
    for monomial, value in terms.items():
        powers = dict(monomial)
        key = powers.pop(sine, 0), powers.pop(cosine, 0)
        if any(x in reachable([part]) for part in powers):
            return None
        parts.setdefault(key, []).append((table.product(*powers.items()), value))
    sums = {key: textbook(table.sum(*pieces)) for key, pieces in parts.items()}
    sums = {key: node for key, node in sums.items() if not sample_zero(node)}
    if not sums:
        return None
    sines, cosines = (min(key[i] for key in sums) for i in (0, 1))
    found = [table.zero, table.pi, -table.pi] if sines else []
    found += [table.pi / 2, -table.pi / 2, 3 * table.pi / 2] if cosines else []
    rest = {(i - sines, j - cosines): node for (i, j), node in sums.items()}
    if set(rest) == {(0, 0)}:
        return found
    if set(rest) - {(0, 0), (1, 0), (0, 1)}:
        return None
    zero = table.zero
    return found + _linear(rest.get((1, 0), zero), rest.get((0, 1), zero), rest.get((0, 0), zero))


def _linear(a: "Node", b: "Node", c: "Node") -> "list[Node]":
    """x of a sin x + b cos x + c = 0, each from −π to 2π and some beyond."""
    table, turn = a.table, 2 * a.table.pi
    if c.is_zero:
        if b.is_zero:
            return [table.zero, table.pi, -table.pi]
        if a.is_zero:
            return [table.pi / 2, -table.pi / 2, 3 * table.pi / 2]
        base = [table.call("atan", single(-b / a))]
        return [x + table.pi * i for x in base for i in (-1, 0, 1, 2)]
    if b.is_zero:
        first = table.call("asin", single(-c / a))
        base = [first, table.pi - first]
    elif a.is_zero:
        first = table.call("acos", single(-c / b))
        base = [first, -first]
    else:
        size = table.sqrt(textbook(a * a + b * b))
        middle, half = table.call("atan2", a, b), table.call("acos", table.product((-c, ONE), (size, -ONE)))
        base = [middle + half, middle - half]
    return [x + turn * i for x in base for i in (-1, 0, 1)]
