"""Where an output is zero: nothing is missed between the points looked at.

Stretches that can hold no zero by the bounds of the output and its derivatives are left out, those that hold a single
one are narrowed down, the others divided.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.transient.isolating_intervals import (
    EPSILON,
    LEVELS,
    MOST,
    BoundedOutput,
    Cells,
    opposite,
    refused,
    root,
)
from vibcli.analyses.transient.segments_held import passing

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.composition import Composition
    from vibcli.analyses.transient.pieces import Pieces
    from vibcli.base.errors import PhysicsError
    from vibcli.base.work import Task, Work

FADED = 1e-292     # below which values lose digits to the least floats: what has died out so far has no zeros
CLEAR, SOONER = 64, 2.0 ** np.arange(-60, 1)


def zeros(pieces: "Composition | Pieces", output: "LinearOutput | None", start: float, end: float,
          work: "Work") -> np.ndarray:
    """All times where the output passes or touches zero, ascending; where it rests at zero, none."""
    curves, leaps = passing(pieces, output, (start, end))
    found = [leaps]
    for curve in curves:
        search = PassageSearch(curve())
        with work.task(f"the search for passages until t = {end:.6g} s", MOST, search.refusal) as task:
            found.append(search.run(task))
    return found[1] if len(found) == 2 and not len(leaps) else _told_apart(np.concatenate(found), start, end)


class PassageSearch:
    """found: arrays of times; closest: Cells in which the output turns at zero but for rounding; left: [(how often they
    were divided, Cells)], those of the earliest times last."""

    def __init__(self, curve: BoundedOutput) -> None:
        self.curve = curve
        cells = curve.first_cells()
        self.found, self.closest = [_jumps(curve, cells)], []
        self.left = [(0, cells)]

    def run(self, task: "Task") -> np.ndarray:
        curve = self.curve
        while self.left:
            level, cells = self.left[-1]
            task.step((self.reached - curve.start) / (curve.end - curve.start or 1.0), curve.steps(cells))
            self.left.pop()
            self._look(level, cells)
        closest = Cells.together(self.closest)
        if len(closest):
            self.found.append(_touching(curve, closest))
        return _left_once(curve, self._times())

    def _times(self) -> np.ndarray:
        """Those found, ascending, of those that but rounding tells apart the first."""
        return _told_apart(np.concatenate(self.found), self.curve.start, self.curve.end)

    @property
    def reached(self) -> float:
        """Before which all is known."""
        cells = self.left[-1][1]
        return float(self.curve.times(cells.segment[0], cells.early[0])) if len(cells) else self.curve.start

    def _look(self, level: int, cells: Cells) -> None:
        curve = self.curve
        cells = cells.where(curve.bound(cells) > FADED)
        left, right = curve.ends(cells)
        rounding, bend = 4 * EPSILON * curve.bound(cells), curve.bend(cells)
        rise = cells.width * np.maximum(*map(np.abs, curve.ends(cells, slope=True)))
        jump = opposite(left, right) & curve.instants(cells)
        steep = (rise > bend) & (rise > 4 * rounding) | jump
        through = opposite(left, right) | (left == 0) | (right == 0)
        single = cells.where(steep & through)
        starts = curve.timeline.starts[single.segment]
        self.found.append(curve.times(single.segment, root(curve.y, curve.slope, single, starts)))
        unsure = ~steep & (through | (np.minimum(np.abs(left), np.abs(right)) <= bend / 8 + rounding))
        resolved = bend / 8 <= rounding
        self.closest.append(cells.where(unsure & resolved))
        cells = cells.where(unsure & ~resolved)
        if level + 1 == LEVELS:
            self.closest.append(cells)
        else:
            self.left += [(level + 1, some) for _, some in reversed(curve.batches(cells))]

    def refusal(self, task: "Task") -> "PhysicsError":
        """What is said of a search that was given up, and what is known by then."""
        passed = (self._times() < self.reached).sum()
        return refused(task, f": before t = {self.reached:.6g} s it passes {passed} times")


def _told_apart(times: np.ndarray, start: float, end: float) -> np.ndarray:
    """The times, ascending, of those that but rounding tells apart the first."""
    times = np.sort(times)
    return times[np.append(True, np.diff(times) > 4 * EPSILON * max(abs(start), abs(end)))] if len(times) else times


def _jumps(curve: BoundedOutput, cells: Cells) -> np.ndarray:
    """Times where one segment leaves the output on one side of zero and the next finds it on the other."""
    early, late = curve.times(cells.segment[1:], cells.early[1:]), curve.times(cells.segment[:-1], cells.late[:-1])
    follow = np.flatnonzero((cells.segment[1:] == cells.segment[:-1] + 1) & (early - late <= 4 * EPSILON * early))
    before = curve.y.at(cells.segment[follow], cells.late[follow])
    after = curve.y.at(cells.segment[follow + 1], cells.early[follow + 1])
    found: np.ndarray = curve.timeline.starts[cells.segment[follow + 1][before * after < 0]]
    return found


def _left_once(curve: BoundedOutput, times: np.ndarray) -> np.ndarray:
    """The times with one at most from each start of a segment on at which the output leaves zero, of whatever order,
    until it is more than rounding; the first start always counts."""
    whole, y = curve.whole, curve.y
    zero = np.abs(y.at(whole.segment, whole.early)) <= 4 * EPSILON * y.bound(whole.segment, whole.early, whole.early)
    first = bool(len(zero)) and bool(zero[0]) and curve.times(whole.segment[0], whole.early[0]) <= curve.start
    whole = whole.where(zero)
    away = _away(curve, whole)
    for k in np.flatnonzero(away):
        left = curve.times(whole.segment[k], whole.early[k])
        near = (times >= left) & (times <= left + away[k])
        if near.any() or (first and k == 0):
            times = np.append(times[~near], left)
    return np.sort(times)


def _away(curve: BoundedOutput, whole: Cells) -> np.ndarray:
    """How long after the start of each stretch, at zero, the output is but rounding away from there; 0 where it
    rests."""
    length = np.minimum(whole.width, 1 / curve.fastest) if curve.fastest else whole.width
    segment, early = np.repeat(whole.segment, len(SOONER)), np.repeat(whole.early, len(SOONER))
    tau = early + np.outer(length, SOONER).ravel()
    rounding = 4 * EPSILON * curve.y.bound(segment, early, tau)
    clear = (np.abs(curve.y.at(segment, tau)) > CLEAR * rounding).reshape(len(whole), len(SOONER))
    return np.where(clear.any(axis=1), length * SOONER[clear.argmax(axis=1)], 0.0)


def _touching(curve: BoundedOutput, cells: Cells) -> np.ndarray:
    """Times where the output turns but rounding away from zero, one in each run of undecided cells."""
    order = np.lexsort((cells.early, cells.segment))
    cells = cells.where(order)
    first = np.append(True, (np.diff(cells.segment) > 0) | (cells.early[1:] > cells.late[:-1]))
    runs = Cells(cells.segment[first], cells.early[first], cells.late[np.append(first[1:], True)])
    tau = curve.turns(runs)
    near: np.ndarray = np.abs(curve.y.at(runs.segment, tau)) <= 16 * EPSILON * curve.bound(runs)
    found: np.ndarray = curve.times(runs.segment, tau)[near]
    return found
