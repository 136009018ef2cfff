"""Where an output is largest or smallest: nothing is missed between the points looked at.

Between two points a distance h apart a function strays from the straight line by no more than B h²/8, B a bound of its
second derivative there, which sums of exponentials give. Stretches that cannot hold more than what was found are left
out, the others divided: all at once, and where they are very many those with the highest bounds first, as long as what
waits takes little memory: the shortest first beyond that.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.transient.isolating_intervals import EPSILON, LEVELS, MOST, PARTS, Cells, refused
from vibcli.analyses.transient.segments_held import highest

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.isolating_intervals import BoundedOutput
    from vibcli.base.errors import PhysicsError
    from vibcli.base.work import Task, Work

FINE = 1e-6
WAITING = 4_000_000     # stretches, 100 MB of them
MANY, MOST_PARTS = 250, 64      # stretches that take little longer than one: so many are made of few, so many of each


def extreme(pieces: Any, output: "LinearOutput", start: float, end: float, sense: str,
            work: "Work") -> tuple[float, float]:
    """(t, value) of the largest or smallest value of the output, also where it jumps or has a kink."""
    search = ExtremeSearch(pieces, output, (start, end), sense)
    with work.task(f"the search for the {search.which} value until t = {end:.6g} s", MOST, search.refusal) as task:
        return search.run(task)


def rivals(pieces: Any, output: "LinearOutput | None", start: float, end: float, sense: str, margin: float,
           work: "Work") -> list[float]:
    """The instants, one of each top, at which the output comes within a margin of its largest or smallest value."""
    search = ExtremeSearch(pieces, output, (start, end), sense, margin)
    with work.task(f"the search for the {search.which} value until t = {end:.6g} s", MOST, search.refusal) as task:
        return search.instants(task)


class ExtremeSearch:
    """margin: how much less than the largest is looked for too. value, time: the largest found, its value times `sign`,
    −1 for the smallest; curves: [(what none of them exceeds, gives a BoundedOutput)] of parts of the time; left: [(what
    none of them exceeds, how often they were divided, Cells)] of one; tops: [(values, times, whether these are peaks or
    ends of a segment)] of instants that may be those of the largest; bends: gives (the curvature, its timeline)."""

    def __init__(self, pieces: Any, output: "LinearOutput | None", ends: tuple[float, float], sense: str,
                 margin: float = 0.0) -> None:
        self.which, self.sign = ("smallest", -1.0) if sense == "min" else ("largest", 1.0)
        self.value, self.time, self.scale, self.margin = -np.inf, ends[0], 0.0, margin
        self.curves, self.left, self.tops = highest(pieces, output, ends, self.sign, margin), [], []
        self.bends: Any = (lambda: (pieces.terms(output, 2), pieces.timeline))

    def run(self, task: "Task") -> tuple[float, float]:
        """(t, value), the earliest of equals."""
        values, times, peaks = self._tops(task)
        if not len(times):
            return float(self.time), float(self.sign * self.value)
        first = np.argmin(times)
        if not peaks[first] and peaks.any():
            of_it = np.flatnonzero(peaks & (times <= times[first] + self._flat(times[[first]])))
            first = of_it[np.argmin(times[of_it])] if len(of_it) else first
        return float(times[first]), float(self.sign * values[first])

    def instants(self, task: "Task") -> list[float]:
        """One of each top within the margin, ascending."""
        found = np.empty((0, 2))
        _, times, peaks = self._tops(task)
        times = np.concatenate([np.sort(times[peaks]), np.sort(times[~peaks])])
        for t, width in zip(times, self._flat(times), strict=True):
            if not (np.abs(t - found[:, 0]) <= found[:, 1]).any():
                found = np.vstack([found, (t, width)])
        return np.sort(found[:, 0]).tolist() or [float(self.time)]

    def _tops(self, task: "Task") -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(values, times, whether these are peaks or ends of a segment) of what may be the largest."""
        alone = len(self.curves) == 1
        while self.curves:
            most, given = self.curves[0]
            if most >= self.value - self.rounding - self.margin:
                self._along(curve := given(), task)
                if alone:
                    self.bends = (lambda curve=curve: (curve.curvature, curve.timeline))
            self.curves = self.curves[1:]
        values, times, peaks = (np.concatenate(parts) for parts in zip(*self.tops, strict=True))
        near = values >= max(self.value, values.max(initial=-np.inf)) - self.rounding - self.margin
        return values[near], times[near], peaks[near]

    def _along(self, curve: "BoundedOutput", task: "Task") -> None:
        """The tops of one curve."""
        cells = curve.first_cells()
        self.left = [(np.inf, 0, cells.divided(_parts(cells, 1)))]
        while self.left:
            most, level, cells = self._next()
            task.step(steps=curve.steps(cells))
            self.left = [part for part in self.left if part[2] is not cells]
            if most >= self.value - self.rounding - self.margin:
                self._look(curve, level, cells)
        whole = curve.whole
        self._keep(curve, np.concatenate([whole.segment, whole.segment]), np.concatenate([whole.early, whole.late]),
                   True)

    def _next(self) -> tuple[float, int, Cells]:
        """What is looked at next of that which is left."""
        many = sum(len(cells) for *_, cells in self.left) > WAITING
        found: tuple[float, int, Cells] = max(self.left, key=lambda part: (part[1], part[0]) if many else part[0])
        return found

    def _flat(self, times: np.ndarray) -> np.ndarray:
        """How wide the top about each instant is within which values are one but for rounding."""
        curvature, timeline = self.bends()
        bend = np.abs(curvature.at(*timeline.place(times)))
        return 2 * np.sqrt(8 * self.rounding / np.where(bend, bend, np.inf))

    @property
    def rounding(self) -> float:
        return 4 * EPSILON * self.scale

    def _look(self, curve: "BoundedOutput", level: int, cells: Cells) -> None:
        ends = [self.sign * values for values in curve.ends(cells)]
        for found, tau in zip(ends, (cells.early, cells.late), strict=True):
            top = np.argmax(found)
            if found[top] > self.value:
                self.value, self.time = found[top], curve.times(cells.segment[top], tau[top])
            self.scale = max(self.scale, np.abs(found).max())
        bound = curve.bound(cells)
        room = np.minimum(curve.bend(cells) / 8, 2 * bound)
        most = np.minimum(np.maximum(*ends) + room, bound)
        held = most >= self.value - self.rounding - self.margin
        cells, room, most = cells.where(held), room[held], most[held]
        settled = curve.instants(cells) | (room <= self.rounding)
        if settled.any():
            for tau in (cells.early, cells.late):
                self._keep(curve, cells.segment[settled], tau[settled])
            self._narrow(curve, cells.where(settled))
        cells, room, most = cells.where(~settled), room[~settled], most[~settled]
        if level + 1 == LEVELS or not (room > FINE * self.scale).any():
            self._narrow(curve, cells)
        else:
            self.left += [(most[part].max(), level + 1, some) for part, some in curve.batches(
                cells, _parts(cells, PARTS))]

    def _narrow(self, curve: "BoundedOutput", cells: Cells) -> None:
        """The peaks within the cells."""
        rises, falls = (self.sign * slopes for slopes in curve.ends(cells, slope=True))
        peaks = cells.where((rises >= 0) & (falls <= 0))
        self._keep(curve, peaks.segment, curve.turns(peaks), True)

    def _keep(self, curve: "BoundedOutput", segment: np.ndarray, tau: np.ndarray, peak: bool = False) -> None:
        values = self.sign * curve.y.at(segment, tau)
        near = values >= max(self.value, values.max(initial=-np.inf)) - self.rounding - self.margin
        times = curve.times(segment[near], tau[near])
        self.tops.append((values[near], times, np.full(len(times), peak)))

    def refusal(self, task: "Task") -> "PhysicsError":
        """What is said of a search that was given up, and what is known by then."""
        more = max(0.0, *(most - self.value for most, *_ in (*self.left, *self.curves[1:])))
        known = f": so far {self.sign * self.value:.6g} at t = {self.time:.6g} s is the {self.which} (in SI units)"
        if np.isfinite(more):
            known += f", and none is {'above' if self.sign > 0 else 'below'} it by more than {1.05 * more:.2g}"
        return refused(task, known)


def _parts(cells: Cells, least: int) -> int:
    """In how many parts each of the cells is divided: the fewer they are, the more."""
    return min(max(least, MANY // max(1, len(cells))), MOST_PARTS)
