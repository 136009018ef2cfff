"""Where an output is largest, and where it is zero: nothing is missed between the points looked at.

Between two points a distance h apart a function strays from the straight line by no more than B h²/8, B a bound of its
second derivative there, which sums of exponentials give. Stretches that can hold nothing are left out, the others
divided.
"""

import numpy as np

from vibcli.analyses.response.cells import EPSILON, Cells, root, stretches
from vibcli.errors import PhysicsError

PARTS, LEVELS = 4, 60
MOST = 1_500_000
FINE = 1e-6


def extreme(pieces, output, start, end, sense):
    """(t, value) of the largest or smallest value of the output, also where it jumps or has a kink."""
    sign = -1.0 if sense == "min" else 1.0
    timeline = pieces.timeline
    y, slope, curvature = (pieces.terms(output, order) for order in range(3))
    whole, cells = stretches(timeline, start, end), _first(timeline, y, start, end)
    best, scale = (-np.inf, 0.0), 0.0
    for _ in range(LEVELS):
        ends = [sign * y.at(cells.segment, tau) for tau in (cells.early, cells.late)]
        for found, tau in zip(ends, (cells.early, cells.late), strict=True):
            top = np.argmax(found)
            best = max(best, (found[top], timeline.starts[cells.segment[top]] + tau[top]), key=lambda pair: pair[0])
            scale = max(scale, np.abs(found).max())
        room = curvature.bound(cells.segment, cells.early, cells.late) * cells.width**2 / 8
        most = np.minimum(np.maximum(*ends) + room, y.bound(cells.segment, cells.early, cells.late))
        held = most >= best[0] - 4 * EPSILON * scale
        cells, room = cells.where(held), room[held]
        if not (room > FINE * scale).any():
            break
        cells = _divided(cells)
    rises, falls = (sign * slope.at(cells.segment, tau) for tau in (cells.early, cells.late))
    peaks = cells.where((rises >= 0) & (falls <= 0))
    segment = np.concatenate([whole.segment, whole.segment, peaks.segment])
    tau = np.concatenate([whole.early, whole.late, root(slope, curvature, peaks)])
    values, times = sign * y.at(segment, tau), timeline.starts[segment] + tau
    near = values >= max(best[0], values.max()) - 4 * EPSILON * scale
    value, time = (values[near][np.argmin(times[near])], times[near].min()) if near.any() else best
    return float(time), float(sign * value)


def _first(timeline, y, start, end):
    """Cells that grow with time, the first a part of the fastest wave's period."""
    fastest = max((abs(node) for nodes in y.nodes() for node in nodes), default=0.0)
    cells = stretches(timeline, start, end)
    return cells.doubling(1 / fastest) if fastest else cells


def _divided(cells):
    if len(cells) * PARTS > MOST:
        raise PhysicsError("the interval holds too many vibrations to search them all",
                           hint="ask for a shorter interval")
    return cells.divided(PARTS)


def zeros(pieces, output, start, end):
    """All times where the output passes or touches zero, ascending; where it rests at zero, none."""
    timeline = pieces.timeline
    y, slope, curvature = (pieces.terms(output, order) for order in range(3))
    cells = _first(timeline, y, start, end)
    cells = cells.where(y.bound(cells.segment, cells.early, cells.late) > 0)
    found, closest = _jumps(timeline, y, cells), []
    for _ in range(LEVELS):
        left, right = (y.at(cells.segment, tau) for tau in (cells.early, cells.late))
        rounding = 4 * EPSILON * y.bound(cells.segment, cells.early, cells.late)
        bend = curvature.bound(cells.segment, cells.early, cells.late) * cells.width**2
        rise = cells.width * np.maximum(*(np.abs(slope.at(cells.segment, tau)) for tau in (cells.early, cells.late)))
        steep = (rise > bend) & (rise > 4 * rounding)
        through = (left * right < 0) | (left == 0) | (right == 0)
        single = cells.where(steep & through)
        found.append(timeline.starts[single.segment] + root(y, slope, single))
        unsure = ~steep & (through | (np.minimum(np.abs(left), np.abs(right)) <= bend / 8 + rounding))
        resolved = bend / 8 <= rounding
        closest.append(cells.where(unsure & resolved))
        cells = cells.where(unsure & ~resolved)
        if not len(cells):
            break
        cells = _divided(cells)
    closest = Cells.together([*closest, cells])
    if len(closest):
        found.append(_touching(timeline, y, slope, curvature, closest))
    times = _distinct(np.concatenate(found), 4 * EPSILON * max(abs(start), abs(end)))
    until = _at_start(timeline, y, slope, start)
    return times if until is None else np.append(start, times[times > until])


def _jumps(timeline, y, cells):
    """Times where one segment leaves the output on one side of zero and the next finds it on the other."""
    follow = np.flatnonzero(cells.segment[1:] == cells.segment[:-1] + 1)
    before = y.at(cells.segment[follow], cells.late[follow])
    after = y.at(cells.segment[follow + 1], cells.early[follow + 1])
    return [timeline.starts[cells.segment[follow + 1][before * after < 0]]]


def _at_start(timeline, y, slope, start):
    """Until when the output is but rounding away from a zero at the start; None where it does not start from zero."""
    segment, tau = timeline.place(np.array([start]))
    rounding = 4 * EPSILON * y.bound(segment, tau, tau)[0]
    value, rate = abs(y.at(segment, tau)[0]), abs(slope.at(segment, tau)[0])
    return start + 2 * rounding / rate if rounding and rate and value <= rounding else None


def _touching(timeline, y, slope, curvature, cells):
    """Times where the output turns but rounding away from zero, one in each run of undecided cells."""
    order = np.lexsort((cells.early, cells.segment))
    cells = cells.where(order)
    first = np.append(True, (np.diff(cells.segment) > 0) | (cells.early[1:] > cells.late[:-1]))
    runs = Cells(cells.segment[first], cells.early[first], cells.late[np.append(first[1:], True)])
    tau = root(slope, curvature, runs)
    rounding = 16 * EPSILON * y.bound(runs.segment, runs.early, runs.late)
    return (timeline.starts[runs.segment] + tau)[np.abs(y.at(runs.segment, tau)) <= rounding]


def _distinct(times, apart):
    """Times in ascending order, those nearer than `apart` but once."""
    times = np.sort(times)
    return times[np.append(True, np.diff(times) > apart)] if len(times) else times
