"""Where functions of one variable are power series: intervals cut at corners and jumps, halved until few Legendre
polynomials say them.

A function is said on a panel where the second half of its n Legendre coefficients is rounding: they fall like ρ^−k, and
Gauss's rule of n points is then right to ρ^−2n, the fourth power of that. At ends of intervals powers of the distance
may be broken: with r^m for r they are whole.
"""

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache
from itertools import pairwise
from math import ceil, floor, isfinite, pi
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.gauss_points import Points, ends_apart, gauss_points

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.symbolic.node import Node

POINTS = 32                     # of a panel
NONE, NEARLY = 1e-12, 1e-14     # of the size on a panel, of that on all: what is rounding
FINEST = Fraction(1, 2**10)     # of an interval: the shortest panel
LEAST = Fraction(1, 2**60)      # the same next to an end
NOTHING = 2.0**-56              # of ∫ |f| dx: what is left there
ROOTS = (2, 3, 4, 6)            # m of broken powers that are looked for
GRID = 512                      # places between which an argument changes its sign
CORNERS = ("abs", "ramp", "min", "max")
JUMPS = ("sign", "step")
REPEATED = {"square": 1, "sawtooth": 2}     # jumps at whole multiples of so many π


class NotSmooth(Exception):
    """A function that is not said by panels: what it is, and what helps."""

    def __init__(self, message: str, hint: str) -> None:
        super().__init__(message)
        self.message, self.hint = message, hint


class SmoothPanel(NamedTuple):
    """From low + a (high − low) to b; points: ((share of the interval, weight), …) with the sum b − a."""

    a: Fraction
    b: Fraction
    points: Points
    plain: bool         # of Gauss's points of x itself


def intervals(parts: "Sequence[Node]", x: "Node", ends: "tuple[Node, Node]",
              values: "Mapping[str, float]") -> "list[tuple[Node, Node]]":
    """(low, high) between the corners and jumps of functions of x, in letters where they can be said; values: {name:
    number} of all symbols but x. NotSmooth where one jumps at places that cannot."""
    low, high = evaluate(list(ends), Floats, values)
    found = {low: ends[0], high: ends[1]}
    slack = 1e-12 * (high - low)
    for node in reachable(parts):
        if node.op == "call" and node.mask & x.mask:
            for place in _corners(node, x, (low, high), values):
                value, = evaluate([place], Floats, values)
                if low < value < high and all(abs(value - other) > slack for other in found):
                    found[value] = place
    places = [found[value] for value in sorted(found)]
    return list(pairwise(places))


def _corners(node: "Node", x: "Node", ends: tuple[float, float], values: "Mapping[str, float]") -> "list[Node]":
    if node.name not in (*CORNERS, *JUMPS, *REPEATED):
        return []
    u = node.args[0] - node.args[1] if node.name in ("min", "max") else node.args[0]
    slope = gradient(u).get(x)
    if slope is None:
        return []
    if not slope.mask & x.mask:
        start, = substitute([u], {x: node.table.zero})
        return [(node.table.pi * n - start) / slope for n in _turns(node, u, x, ends, values)]
    changes = list(_changes(u, x, ends, values))
    if changes and node.name not in CORNERS:
        raise NotSmooth(f"jumps at {changes[0]:.6g} m, where what it is made of is not linear in x",
                        "write what jumps by step() of x less a place")
    return [node.table.number(Fraction(place)) for place in changes]


def _turns(node: "Node", u: "Node", x: "Node", ends: tuple[float, float], values: "Mapping[str, float]") -> list[int]:
    """The multiples of π at which it jumps or has a corner."""
    if node.name not in REPEATED:
        return [0]
    every = REPEATED[node.name]
    first, last = sorted(evaluate([u], Floats, {**values, x.name: end})[0] / (pi * every) for end in ends)
    return [n * every for n in range(floor(first), ceil(last) + 1)]


def _changes(u: "Node", x: "Node", ends: tuple[float, float], values: "Mapping[str, float]") -> Iterator[float]:
    """Where u changes its sign."""
    def value(place: float) -> float:
        found: float = evaluate([u], Floats, {**values, x.name: place})[0]
        return found

    step = (ends[1] - ends[0]) / GRID
    before = value(ends[0])
    for k in range(GRID):
        left, right = ends[0] + step * k, ends[0] + step * (k + 1)
        after = value(right)
        if before * after < 0:
            while left < (middle := (left + right) / 2) < right:
                left, right = (middle, right) if value(middle) * before > 0 else (left, middle)
            yield left
        before = after


def panels(value: "Callable[[float], Sequence[float]]", ends: tuple[float, float], longest: float = 1.0,
           broken: bool = True) -> Iterator[SmoothPanel]:
    """Panels of an interval without corners inside, none longer than this share of it; value(x): functions. Next to its
    ends rules for `broken` powers, or without these one so short that nothing is left there. NotSmooth where there are
    none."""
    low, high = ends

    def at(points: "Points") -> "list[tuple[float, ...]]":
        return list(zip(*(value(low + (high - low) * float(r)) for r, _ in points), strict=True))

    whole = at(gauss_points(POINTS))
    sizes = [max((abs(y) for y in row if isfinite(y)), default=0.0) for row in whole]
    left = [(Fraction(0), Fraction(1))]
    while left:
        a, b = left.pop()
        found = _panel(a, b, at, sizes, broken) if b - a <= longest else None
        if found is not None:
            yield found
        elif b - a > (LEAST if not broken and (a == 0) != (b == 1) else FINEST) or b - a > longest:
            left += [((a + b) / 2, b), (a, (a + b) / 2)]
        else:
            raise NotSmooth(f"is infinite, jumps or turns about too often near {low + (high - low) * float(a):.6g} m",
                            "let it be finite and piecewise smooth along the member")


def _panel(a: Fraction, b: Fraction, at: "Callable[[Points], list[tuple[float, ...]]]", sizes: "Sequence[float]",
           broken: bool) -> SmoothPanel | None:
    """A SmoothPanel; None where no rule says what is there."""
    for plain, points in _candidates(a, b, broken):
        rows, weights = at(points), [w for _, w in points]
        if all(isfinite(y) for row in rows for y in row) and all(
                _said(row, weights, b - a, size) for row, size in zip(rows, sizes, strict=True)):
            return SmoothPanel(a, b, points, plain)
    if not broken and (a == 0) != (b == 1):
        points = _moved(gauss_points(POINTS), a, b)
        left = [float(b - a) * max(map(abs, row)) for row in at(points)]
        if all(most <= NOTHING * size for most, size in zip(left, sizes, strict=True)):
            return SmoothPanel(a, b, points, False)
    return None


def _candidates(a: Fraction, b: Fraction, broken: bool) -> "Iterator[tuple[bool, Points]]":
    """(of x itself?, points) of rules that may say what is on a panel."""
    yield True, _moved(gauss_points(POINTS), a, b)
    if not broken or (a == 0) == (b == 1):
        return
    for m in ROOTS:
        yield False, _moved(_bent(m, a == 0), a, b)
    if b - a <= Fraction(1, 8):
        yield False, _moved(ends_apart(), a, b)


@cache
def _bent(m: int, at_left: bool) -> "Points":
    """Gauss's points of r^m, or of 1 − (1 − r)^m."""
    found = [(r**m, w * m * r ** (m - 1)) for r, w in gauss_points(POINTS)]
    return tuple(found) if at_left else tuple((1 - r, w) for r, w in reversed(found))


def _moved(points: "Points", a: Fraction, b: Fraction) -> "Points":
    return tuple((a + (b - a) * r, (b - a) * w) for r, w in points)


def _said(row: "Sequence[float]", weights: "Sequence[Fraction]", length: Fraction, size: float) -> bool:
    """Is what stands at the points of a rule said by it?"""
    if len(row) != POINTS:
        parts = [y * float(w / length) for y, w in zip(row, weights, strict=True)]
        small = max(NONE * max(map(abs, parts)), NEARLY * size)
        return max(abs(sum(parts[::2]) - sum(parts[1::2])), abs(parts[0]), abs(parts[-1])) <= small
    bent = [y * float(w / (length * v)) for y, w, (_, v) in zip(row, weights, gauss_points(POINTS), strict=True)]
    small = max(NONE * max(map(abs, bent)), NEARLY * size)
    return all(abs(sum(c * y for c, y in zip(column, bent, strict=True))) <= small for column in _upper())


@cache
def _upper() -> list[tuple[float, ...]]:
    """Rows that give the second half of the Legendre coefficients of what stands at Gauss's points."""
    found = []
    for r, w in gauss_points(POINTS):
        x, column = 2 * float(r) - 1, [1.0, 2 * float(r) - 1]
        for k in range(2, POINTS):
            column.append(((2 * k - 1) * x * column[-1] - (k - 1) * column[-2]) / k)
        found.append([(2 * k + 1) * float(w) * column[k] for k in range(POINTS // 2, POINTS)])
    return list(zip(*found, strict=True))
