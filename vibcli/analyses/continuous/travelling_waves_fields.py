"""What runs along a member at the start: the fields u(x) and u̇(x) as two waves, f(t − x/c) and g(t + x/c).

    f(−x/c) = u/2 − w/(2c)        g(x/c) = u/2 + w/(2c)        w = ∫ u̇ dx from the left end
"""

from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.travelling_waves_curves import SAME, Loads, PiecewiseSeries, series_of
from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
from vibcli.numerics.chebyshev import AT_POINTS, ONCE, POINTS, TO_SERIES, WIDTH

if TYPE_CHECKING:
    from vibcli.base.work import Task

RESOLVED = 4e-15    # of the largest value: what the last coefficients of a series may be
FINEST = 1e-9       # of a member: the shortest stretch
ODD = (-1.0) ** np.arange(WIDTH)


def straight(left: float, right: float, length: float) -> Forcing:
    """The field of a member at rest, straight between its ends."""
    return Forcing(2, [Segment(0.0, (Wave(0, left, 0, 0j), Wave(0, (right - left) / length, 1, 0j)))])


def starting_waves(field: Forcing, length: float, delay: Fraction,
                   task: "Task") -> tuple[PiecewiseSeries, PiecewiseSeries, list[tuple[float, float]]]:
    """(what leaves the left end, what leaves the right end, both from −delay to 0; [(x, leap of u)] of the places where
    the fields have a corner). field: u and u̇ of x on two channels."""
    speed = length / float(delay)
    loads = Loads(2, [piece for piece in field.pieces if piece.start < length * (1 - SAME)])
    corners = [float(x) for x in loads.starts[1:]]
    parts, leaps, total = [], [], 0.0
    for number, (a, b) in enumerate(zip([0.0, *corners], [*corners, length], strict=True)):
        if number:
            u = [loads.at(k, Fraction(a), np.zeros(1))[0, 0] for k in (number - 1, number)]
            leaps.append((a, 0.0 if abs(u[1] - u[0]) <= SAME * max(map(abs, u)) else u[1] - u[0]))
        for start, end in _resolved(loads, number, a, b, length, task):
            series, total = _pair(loads, number, start, end, speed, total)
            parts.append((start, end, series))
    left, right = PiecewiseSeries(), PiecewiseSeries()
    whole = Fraction(length)
    for start, end, (f, _) in reversed(parts):
        left.append(-delay * end / whole, delay * (end - start) / whole, f)
    for start, end, (_, g) in parts:
        right.append(delay * (start - whole) / whole, delay * (end - start) / whole, g)
    return left, right, leaps


def _resolved(loads: Loads, number: int, a: float, b: float, length: float,
              task: "Task") -> list[tuple[Fraction, Fraction]]:
    """The stretches of [a, b], ascending and exact, on which series tell the fields."""
    found, left = [], [(Fraction(a), Fraction(b))]
    while left:
        start, end = left.pop()
        task.step()
        x = float(end - start) / 2 * (1 + POINTS)
        slope = loads.at(number, start, x, 1)[0], loads.at(number, start, x)[1]
        if end - start <= FINEST * length or all(is_resolved(values @ TO_SERIES) for values in slope):
            found.append((start, end))
        else:
            left += [((start + end) / 2, end), (start, (start + end) / 2)]
    return found


def is_resolved(series: np.ndarray, scale: float = 0.0) -> bool:
    """Are the last coefficients of a series but rounding?"""
    size = np.abs(series)
    return bool(size[-3:].max() <= RESOLVED * max(scale, size.max()))


def _pair(loads: Loads, number: int, start: Fraction, end: Fraction, speed: float,
          total: float) -> tuple[tuple[np.ndarray, np.ndarray], float]:
    """((series of f, series of g) of one stretch, each over its own time; ∫ u̇ up to its end)."""
    half = float(end - start) / 2
    x = half * (1 + POINTS)
    (u, v), (du, dv), (ddu, _) = (loads.at(number, start, x, order) for order in range(3))
    w = half * v @ ONCE
    w[0] += total
    last = float(w.sum())
    w = w @ AT_POINTS[:len(w)]
    f = [u / 2 - w / (2 * speed), (v - speed * du) / 2, speed / 2 * (speed * ddu - dv)]
    g = [u / 2 + w / (2 * speed), (v + speed * du) / 2, speed / 2 * (speed * ddu + dv)]
    return (series_of(np.array(f)) * ODD, series_of(np.array(g))), last

