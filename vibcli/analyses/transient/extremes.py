"""Where an output is zero: nothing is missed between the points looked at.

Stretches that can hold no zero by the bounds of the output and its derivatives are left out, those that hold a single
one are narrowed down, the others divided.
"""

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.work import Spent
from vibcli.numerics.bracketed_newton import (
    EPSILON,
    LEVELS,
    MOST,
    Cells,
    batches,
    first_cells,
    instants,
    root,
    steps,
    stretches,
)

CLEAR, SOONER = 64, 2.0 ** np.arange(-60, 1)

def zeros(pieces, output, start, end, work):
    """All times where the output passes or touches zero, ascending; where it rests at zero, none."""
    search = PassageSearch(pieces, output, start, end)
    with work.task(f"the search for passages until t = {end:.6g} s", MOST) as task:
        try:
            return search.run(task)
        except Spent as spent:
            if spent.task is not task:
                raise
            raise search.refusal(task) from None


class PassageSearch:
    """found: arrays of times; closest: Cells in which the output turns at zero but for rounding; left: [(how often they
    were divided, Cells)], those of the earliest times last."""

    def __init__(self, pieces, output, start, end):
        self.timeline, self.start, self.end = pieces.timeline, start, end
        self.y, self.slope, self.curvature = (pieces.terms(output, order) for order in range(3))
        cells = first_cells(self.timeline, self.y, start, end)
        self.found, self.closest = _jumps(self.timeline, self.y, cells), []
        self.left = [(0, cells)]

    def run(self, task):
        while self.left:
            level, cells = self.left[-1]
            task.step((self.reached - self.start) / (self.end - self.start or 1.0), steps(cells, self.y))
            self.left.pop()
            self._look(level, cells)
        closest = Cells.together(self.closest)
        if len(closest):
            self.found.append(_touching(self.timeline, self.y, self.slope, self.curvature, closest))
        times = _distinct(np.concatenate(self.found), 4 * EPSILON * max(abs(self.start), abs(self.end)))
        return _left_once(self.timeline, self.y, stretches(self.timeline, self.start, self.end), times)

    @property
    def reached(self):
        """Before which all is known."""
        cells = self.left[-1][1]
        return self.timeline.starts[cells.segment[0]] + cells.early[0] if len(cells) else self.start

    def _look(self, level, cells):
        y, slope, curvature = self.y, self.slope, self.curvature
        cells = cells.where(y.bound(cells.segment, cells.early, cells.late) > 0)
        left, right = (y.at(cells.segment, tau) for tau in (cells.early, cells.late))
        rounding = 4 * EPSILON * y.bound(cells.segment, cells.early, cells.late)
        bend = curvature.bound(cells.segment, cells.early, cells.late) * cells.width**2
        rise = cells.width * np.maximum(*(np.abs(slope.at(cells.segment, tau)) for tau in (cells.early, cells.late)))
        jump = (left * right < 0) & instants(self.timeline, cells, y)
        steep = (rise > bend) & (rise > 4 * rounding) | jump
        through = (left * right < 0) | (left == 0) | (right == 0)
        single = cells.where(steep & through)
        self.found.append(self.timeline.starts[single.segment] + root(y, slope, single))
        unsure = ~steep & (through | (np.minimum(np.abs(left), np.abs(right)) <= bend / 8 + rounding))
        resolved = bend / 8 <= rounding
        self.closest.append(cells.where(unsure & resolved))
        cells = cells.where(unsure & ~resolved)
        if level + 1 == LEVELS:
            self.closest.append(cells)
        else:
            self.left += [(level + 1, some) for _, some in reversed(batches(cells, self.y))]

    def refusal(self, task):
        """What is said of a search that was given up, and what is known by then."""
        refused = task.refusal()
        times = _distinct(np.concatenate(self.found), 4 * EPSILON * max(abs(self.start), abs(self.end)))
        known = f"before t = {self.reached:.6g} s it passes {(times < self.reached).sum()} times"
        return PhysicsError(f"{refused.message}: {known}", f"ask for a shorter interval; {refused.hint}")


def _jumps(timeline, y, cells):
    """Times where one segment leaves the output on one side of zero and the next finds it on the other."""
    follow = np.flatnonzero(cells.segment[1:] == cells.segment[:-1] + 1)
    before = y.at(cells.segment[follow], cells.late[follow])
    after = y.at(cells.segment[follow + 1], cells.early[follow + 1])
    return [timeline.starts[cells.segment[follow + 1][before * after < 0]]]


def _left_once(timeline, y, whole, times):
    """The times with one at most from each start of a segment on at which the output leaves zero, of whatever order,
    until it is more than rounding; the first start always counts."""
    zero = np.abs(y.at(whole.segment, whole.early)) <= 4 * EPSILON * y.bound(whole.segment, whole.early, whole.early)
    whole, first = whole.where(zero), bool(len(zero)) and bool(zero[0])
    away = _away(y, whole)
    for k in np.flatnonzero(away):
        left = timeline.starts[whole.segment[k]] + whole.early[k]
        near = (times >= left) & (times <= left + away[k])
        if near.any() or (first and k == 0):
            times = np.append(times[~near], left)
    return np.sort(times)


def _away(y, whole):
    """How long after the start of each stretch, at zero, the output is but rounding away from there; 0 where it
    rests."""
    fastest = max((abs(node) for nodes in y.nodes() for node in nodes), default=0.0)
    length = np.minimum(whole.width, 1 / fastest) if fastest else whole.width
    segment, early = np.repeat(whole.segment, len(SOONER)), np.repeat(whole.early, len(SOONER))
    tau = early + np.outer(length, SOONER).ravel()
    rounding = 4 * EPSILON * y.bound(segment, early, tau)
    clear = (np.abs(y.at(segment, tau)) > CLEAR * rounding).reshape(len(whole), len(SOONER))
    return np.where(clear.any(axis=1), length * SOONER[clear.argmax(axis=1)], 0.0)


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
