"""T = 2 ∫ √(m/(2(E − V))) dq between two turning points, in floats, with a bound of its error.

The way is cut where V bends or is stationary. On each piece from a to b the double exponential rule (Takahasi & Mori
1974) stands roots at the ends and broken powers at kinks:

    q = b − (b − a)/(1 + e^{π sinh u})          dq/du = (b − a) (π/4) cosh u / cosh²(½π sinh u)

E − V is added up from the nearer turning point, where a difference would lose its digits. The step is halved until
nothing changes.
"""

import math
from functools import cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from vibcli.analyses.nonlinear.well import EPS, Well

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.nonlinear.turning_points import TurningPoint

FARTHEST, STEP, FINEST = 3.9, 0.5, 1 / 64
ENOUGH = 4 * EPS
SHIFT = 1e-7                # of the reach: by so much the ends are moved to see what that does to the period


class PiecesOfWell(NamedTuple):
    """Ends `a`, `b` of the pieces, E − V there with bounds of their errors, and the rounding of V and V′."""

    a: np.ndarray
    b: np.ndarray
    drop: tuple[np.ndarray, np.ndarray]
    error: tuple[np.ndarray, np.ndarray]
    rounding: tuple[float, float]


def period_between(well: Well, left: "TurningPoint", right: "TurningPoint") -> tuple[float, float]:
    """(period [s], bound of its error) of the motion between its turning points."""
    breaks = well.breaks(left.q, right.q)
    pieces = _pieces(well, [left.q, *breaks, right.q])
    time, error = _time(well, pieces, FINEST)
    shift = SHIFT * (right.q - left.q)
    for ends, end in (((left.q - shift, right.q), left), ((left.q, right.q + shift), right)):
        if end.error:
            moved, _ = _time(well, _pieces(well, [ends[0], *breaks, ends[1]]), STEP / 4)
            error += abs(moved - time) / shift * end.error
    return 2 * time, 2 * error


def _pieces(well, stops: "Sequence[float]"):
    places = np.array(stops)
    known = [well.rounding(q) for q in stops]
    rounding = max(v for v, _ in known), max(f for _, f in known)
    gain = well.gain(places[:-1], np.diff(places), rounding)
    from_left = _added_up(-gain.value, gain.error)
    from_right = [row[::-1] for row in _added_up(gain.value[::-1], gain.error[::-1])]
    left_is_nearer = from_left[1] <= from_right[1]
    drop, error = (np.where(left_is_nearer, x, y) for x, y in zip(from_left, from_right, strict=True))
    return PiecesOfWell(places[:-1], places[1:], (drop[:-1], drop[1:]), (error[:-1], error[1:]), rounding)


def _added_up(steps, errors):
    """(sums from 0, bounds)."""
    sums = np.concatenate(([0.0], np.cumsum(steps)))
    return sums, np.concatenate(([0.0], np.cumsum(errors + EPS * np.abs(sums[1:]))))


def _time(well, pieces, finest):
    """(∫ √(m/(2(E − V))) dq, bound)."""
    step, first, apart, total, error, found = STEP, 0.0, STEP, 0.0, 0.0, math.inf
    while True:
        value, lost = _sums(well, pieces, first, apart)
        total, error, before = total + value, error + lost, found
        found = total * step
        change = abs(found - before)
        if change <= ENOUGH * found or step <= finest or not math.isfinite(found):
            return found, change + error * step + 8 * EPS * found
        first, apart, step = step / 2, step, step / 2


def _sums(well, pieces, first, apart):
    """Sums of the integrand at u = ±first, ±(first + apart) …, and of its error, over all pieces."""
    share, weight, from_left = _nodes(first, apart)
    way = pieces.b - pieces.a
    gap = np.outer(share, way)
    start = np.where(from_left[:, None], pieces.a, pieces.b)
    inward = np.where(from_left[:, None], gap, -gap)
    gain = well.gain(start, inward, pieces.rounding)
    drop = np.where(from_left[:, None], *pieces.drop) - gain.value
    lost = np.where(from_left[:, None], *pieces.error) + gain.error
    m = well.inertia(start + inward)
    with np.errstate(all="ignore"):
        values = np.where(drop > 0, weight[:, None] * way * np.sqrt(m / (2 * drop)), 0.0)
        errors = np.where(drop > lost, values * lost / (2 * drop), np.inf)
    return float(values.sum()), float(errors.sum())


@cache
def _nodes(first, apart):
    """(share of the way between the place and the nearer end, dq/du over the way, is the left end the nearer?)"""
    count = int((FARTHEST - first) / apart + 1e-9) + 1
    u = first + apart * np.arange(count)
    u = np.concatenate((-u[::-1], u[1:] if not first else u))
    far = np.exp(-math.pi * np.sinh(np.abs(u)))
    return far / (1 + far), math.pi * np.cosh(u) * far / (1 + far) ** 2, u < 0
