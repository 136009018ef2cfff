"""Where a motion in a well comes to rest: E − V(q) = 0 on each side of a place."""

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from vibcli.analyses.nonlinear.well import EPS, Well
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.root_finding import last_place

RESTS = ("the scene is at rest: its motion has no period", "give it an `initial` state that is none of equilibrium")
LEAVES = "this motion does not come back: it reaches a place where its forces are not defined"
AT_REST = 4 * EPS
FIRST, GROWTH, WIDEST = 0.05, 1.1, 5.0      # steps of what a linear spring would go, no longer than so many of these …
FARTHER = 0.05                              # … or of the way gone
CELLS, BLOCKS = 40, 12
BENT = 0.06                                 # of V′: by so much it may change in the first step
HALVINGS = 100


class TurningPoint(NamedTuple):
    """A turning point, and how well it is known."""

    q: float
    error: float


def require_motion(well: Well, q: float, speed: float) -> None:
    """PhysicsError at rest in an equilibrium, as well as floats know the place of it; `speed`: ½ m q̇²."""
    if not speed and abs(well.force_at(q)) <= AT_REST * abs(q) * stiffness(well, q):
        raise PhysicsError(*RESTS)


def stiffness(well: Well, q: float) -> float:
    """|V″|, by a difference."""
    step = 1e-6 * (abs(q) or 1.0)
    return abs(float(np.diff(well.force(np.array([q - step, q + step])))[0])) / (2 * step)


def turning_point(well: Well, q: float, speed: float, side: int) -> TurningPoint:
    """The turning point on one side of a place, where V(end) = V(q) + speed."""
    force = well.force_at(q)
    if not speed and side * force >= 0 and force:
        return TurningPoint(q, 0.0)
    rounding = well.rounding(q)
    gone, gained = q, 0.0
    for edges in _edges(q, side, _scale(well, q, speed, force)):
        found, gone, gained = _within(well, edges, gained, speed, side, rounding)
        if found is not None:
            return _refined(well, q, speed, side, found, rounding)
        if gone is None:
            raise PhysicsError(*_leaves(well))
    raise PhysicsError("this motion does not come back: nothing turns it round", "ask for its value at a time")


def _leaves(well: Well) -> tuple[str, str]:
    ending = well.ending
    return (f"{LEAVES}: {ending.what}", ending.hint) if ending else (LEAVES, "ask for its value at a time")


def _edges(q: float, side: int, scale: float) -> Iterator[np.ndarray]:
    """Ever more cells to look at, as arrays of their ends."""
    step, last = FIRST * scale, q
    for _ in range(BLOCKS):
        edges = [last]
        for _ in range(CELLS):
            last += side * step
            edges.append(last)
            step = min(GROWTH * step, max(WIDEST * FIRST * scale, FARTHER * abs(last - q)))
        yield np.array(edges)


def _within(well: Well, edges: np.ndarray, gained: float, speed: float, side: int,
            rounding: tuple[float, float]) -> tuple[tuple[float, float] | None, float, float]:
    """(the first cell after which the motion cannot go on, or None, the last place, what V gained up to it; None where
    V is not defined)."""
    climbs = well.gain(edges[:-1], np.diff(edges), rounding).value
    heights = gained + np.concatenate(([0.0], np.cumsum(climbs)))
    slopes = side * well.force(edges)
    for k, (a, b) in enumerate(pairwise(edges)):
        if not math.isfinite(heights[k + 1]):
            return None, None, None
        if heights[k + 1] >= speed and heights[k + 1] > min(heights[k], 0.0) and (speed or heights[k + 1] > 0):
            return (float(a), float(b)), b, heights[k + 1]
        if slopes[k] > 0 >= slopes[k + 1]:
            top = last_place(lambda x: side * well.force_at(x) > 0, a, b)[1]
            gain = well.gain(np.array([a]), np.array([top - a]), rounding)
            height = heights[k] + float(gain.value[0])
            error = float(gain.error[0]) + EPS * np.abs(heights[:k + 1]).sum()
            if height + error >= speed and (speed or height + error > 0):
                return (float(a), float(top)), b, height
    return None, edges[-1], float(heights[-1])


def _refined(well: Well, q: float, speed: float, side: int, cell: tuple[float, float],
             rounding: tuple[float, float]) -> TurningPoint:
    """The turning point in a cell, V being added up between the places where it bends."""
    low, high = cell
    places = well.breaks(*sorted((q, high)))[::side]
    stops = [q, *(place for place in places if place != q), high]
    height, error, swing = 0.0, 0.0, 0.0
    for a, b in pairwise(stops):
        gain = well.gain(np.array([a]), np.array([b - a]), rounding)
        reached = height + float(gain.value[0])
        if side * b > side * low and reached >= speed:
            found = _zero(well, a, b, height - speed, rounding)
            slope = abs(well.force_at(found)) or math.inf
            error += float(gain.error[0]) + EPS * swing
            return TurningPoint(found, EPS * abs(found) + error / slope)
        height, error, swing = reached, error + float(gain.error[0]), max(swing, abs(reached))
    return TurningPoint(high, abs(high - low))


def _zero(well: Well, a: float, b: float, missing: float, rounding: tuple[float, float]) -> float:
    """Where V has gained since a what was missing: by Newton's steps from b, halvings where they leave the bracket."""
    low, high, q = a, b, b
    for _ in range(HALVINGS):
        left = missing + float(well.gain(np.array([a]), np.array([q - a]), rounding).value[0])
        low, high = (q, high) if left < 0 else (low, q)
        slope = well.force_at(q)
        trial = q - left / slope if slope else math.nan
        if abs(trial - q) <= EPS * abs(q):
            return trial
        q = trial if min(low, high) < trial < max(low, high) else 0.5 * (low + high)
        if q in (low, high):
            break
    return q


def _scale(well: Well, q: float, speed: float, force: float) -> float:
    """How far a linear spring would let it go."""
    k = stiffness(well, q)
    found = math.sqrt(2 * speed / k) if speed and k else abs(force) / k if k and force else abs(q) or 1.0
    if not force or (speed and k):
        return found
    trials = found * 0.5 ** np.arange(HALVINGS)
    bent = np.abs(well.force(q - math.copysign(FIRST, force) * trials) - force) > BENT * abs(force)
    return float(trials[min(np.flatnonzero(bent)[-1:].sum() + bent.any(), HALVINGS - 1)])
