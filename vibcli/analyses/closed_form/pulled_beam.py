"""A uniform beam under a constant axial force N, pulled or pressed, in letters:

    EI X⁗ − N X″ = (μω² − k) X       α² − β² = N/EI       α²·β² = (μω² − k)/EI       (Rao 2007, section 11.9)

so that cosh αx, sinh αx, cos βx, sin βx are its solutions. It carries (X, X′, M, Q), M = EI X″, Q = EI X‴ − N X′ the
force across the line as drawn, from its left end to its right one; times α² + β² no entry of that has a denominator but
α or β.
"""

from collections.abc import Iterator
from itertools import combinations, product
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.symbolic.node import Node

    Indices = tuple[int, ...]
    Factor = Fraction | int | Node

FUNCTIONS = ("cosh", "cos"), ("sinh", "sin")       # those that stand together


def carried_minors(alpha: "Node", beta: "Node",
                   bending: "Node") -> "Iterator[tuple[Indices, Indices, dict[tuple[str, ...], Factor]]]":
    """(row, column, {names of functions: factor}) of the minors of what the beam carries, times (α² + β²)²; the
    arguments of sinh and cosh are αl, those of sin and cos are βl."""
    T, scale = _transfer(alpha, beta), [alpha.table.one, alpha.table.one, bending, bending]
    for (i, j), (k, m) in product(combinations(range(4), 2), repeat=2):
        minor: dict[tuple[str, ...], Node] = {}
        for one, two, sign in ((T[i][k], T[j][m], 1), (T[i][m], T[j][k], -1)):
            for (name, x), (other, y) in product(one.items(), two.items()):
                for names, factor in reduced_product(*sorted((name, other))):
                    minor[names] = minor.get(names, 0) + sign * factor * x * y
        size = scale[i] * scale[j] / (scale[k] * scale[m])
        yield (i, j), (k, m), {names: size * node for names, node in minor.items()}


def _transfer(a: "Node", b: "Node") -> "list[list[dict[str, Node]]]":
    """The rows of X, X′, M/EI, Q/EI at the right end by the same at the left one, times α² + β²."""
    even, odd = FUNCTIONS

    def entry(names: "tuple[str, str]", *sizes: "Node") -> "dict[str, Node]":
        return dict(zip(names, sizes, strict=True))

    one = a.table.one
    mean, swapped = entry(even, b ** 2, a ** 2), entry(even, a ** 2, b ** 2)
    turn, bent, kept = entry(odd, a, b), entry(even, one, -one), entry(even, a ** 2 * b ** 2, -(a ** 2 * b ** 2))
    back = entry(odd, a * b ** 2, -(a ** 2 * b))
    return [[mean, turn, bent, entry(odd, 1 / a, -1 / b)],
            [back, swapped, turn, bent],
            [kept, entry(odd, a ** 3, -(b ** 3)), swapped, turn],
            [entry(odd, a * b ** 4, a ** 4 * b), kept, back, mean]]


def reduced_product(one: str, two: str) -> list[tuple[tuple[str, ...], int]]:
    """A product of two functions as [(names, factor)], by cos² = 1 − sin² and cosh² = 1 + sinh²."""
    if one == two == "cos":
        return [((), 1), (("sin", "sin"), -1)]
    if one == two == "cosh":
        return [((), 1), (("sinh", "sinh"), 1)]
    return [((one, two), 1)]
