"""Functions of outputs of linear motions, as what searches look at: values, slopes and curvatures with bounds of them.

On a stretch of half width h about its middle m, a sum of exponentials lies within |y(m)| + |y'(m)| h + B h²/2, B the
bound of its second derivative; what is composed of such sums follows by interval arithmetic with rates (jets.py).
"""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.transient.forcing_arrays import Timeline, bare_timeline
from vibcli.analyses.transient.isolating_intervals import EPSILON, Cells, fastest, instants
from vibcli.analyses.transient.jets import Jet, Jets
from vibcli.analyses.transient.output_ranges import OutputRanges
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.interval_arithmetic import Interval, Intervals, exact

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.symbolic.node import Node

LOST = 1e-290       # what underflows in products counts as 0
FINEST = 1e6        # first stretches within the time that is looked at, where no speed is known
WORTH = 8           # exponentials whose values take as long as one bound


class Leaf:
    """An output of a linear motion."""

    def __init__(self, pieces: Any, output: "LinearOutput") -> None:
        self.pieces, self.output, self.recorded = pieces, output, pieces.recorded
        self.starts = pieces.timeline.starts
        self.y, self.slope, self.curvature = (pieces.terms(output, order) for order in range(3))
        self.nodes = [nodes for terms in (self.y, self.slope, self.curvature) for nodes in terms.nodes()]

    def at(self, segment: np.ndarray, tau: np.ndarray) -> np.ndarray:
        return cast("np.ndarray", self.y.at(segment, tau))

    def size(self, segment: np.ndarray, early: np.ndarray, late: np.ndarray) -> Jet:
        """The value as any number up to its bound."""
        bound = self.y.bound(segment, early, late)
        return Jet(Interval(-bound, bound))

    def jet(self, segment: np.ndarray, early: np.ndarray, late: np.ndarray) -> Jet:
        half, middle = 0.5 * (late - early), 0.5 * (early + late)
        at, on = {}, {}
        y, slope, curvature = ((terms.at(segment, middle, at), terms.bound(segment, early, late, on))
                               for terms in (self.y, self.slope, self.curvature))
        bends = curvature[1]
        return Jet(_within(*y, np.abs(slope[0]) * half + bends * half**2 / 2), _within(*slope, bends * half),
                   _within(*curvature, np.inf))


def _within(value: np.ndarray, bound: np.ndarray, reach: float | np.ndarray) -> Interval:
    """What lies within a reach of its value in the middle, and within its bounds."""
    bound = bound * (1 + 4 * EPSILON)
    reach = reach + 16 * EPSILON * bound
    return Interval(np.maximum(value - reach, -bound), np.minimum(value + reach, bound))


class SegmentsOfLeaves(NamedTuple):
    """The segments of a Composition: in which segment of each leaf they lie, and how much later they start there."""

    timeline: Timeline
    segments: Mapping[str, np.ndarray]
    later: Mapping[str, np.ndarray]

    @classmethod
    def of(cls, leaves: Mapping[str, Leaf]) -> "SegmentsOfLeaves":
        """Of all that leaves have."""
        starts = np.unique(np.concatenate([np.zeros(1), *(leaf.starts for leaf in leaves.values())]))
        segments = {name: np.searchsorted(leaf.starts, starts, "right") - 1 for name, leaf in leaves.items()}
        later = {name: starts - leaf.starts[segments[name]] for name, leaf in leaves.items()}
        return cls(bare_timeline(starts), segments, later)

    def among(self, segments: np.ndarray, leaves: Mapping[str, Leaf]) -> "tuple[dict[str, Leaf], SegmentsOfLeaves]":
        """({name: leaf of what is needed there}, the SegmentsOfLeaves) of some segments."""
        found, own = dict(leaves), {name: places[segments] for name, places in self.segments.items()}
        for name, leaf in leaves.items():
            if leaf.recorded:
                needed, own[name] = np.unique(own[name], return_inverse=True)
                found[name] = Leaf(leaf.pieces.among(needed), leaf.output)
        later = {name: times[segments] for name, times in self.later.items()}
        return found, SegmentsOfLeaves(self.timeline.among(segments), own, later)


class Composition:
    """node of the leaves {name: leaf}, of the time and of numbers {name: value}, up to an end; check(values, times)
    gives the values where all are finite."""

    def __init__(self, node: "Node", leaves: Mapping[str, Leaf], floats: Mapping[str, float], time: str,
                 check: Callable[[np.ndarray, np.ndarray], np.ndarray], end: float,
                 places: SegmentsOfLeaves | None = None) -> None:
        self.node, self.leaves, self.floats, self.time, self.check = node, leaves, floats, time, check
        self.timeline, self.segments, self.later = self.places = places or SegmentsOfLeaves.of(leaves)
        self.starts, self.end = self.timeline.starts, end
        self.recorded = any(leaf.recorded for leaf in leaves.values())
        self.nodes = [nodes for leaf in leaves.values() for nodes in leaf.nodes] or [(complex(FINEST / end),)]
        self.constants = {name: Jet(exact(value)) for name, value in floats.items() if isinstance(value, float)}
        self._last: dict[str, tuple[Any, ...]] = {}

    def among(self, segments: np.ndarray) -> "Composition":
        """The same on some segments."""
        leaves, places = self.places.among(segments, self.leaves)
        return Composition(self.node, leaves, self.floats, self.time, self.check, self.end, places)

    def ranges(self, output: Any) -> OutputRanges:
        """Between which values it stays on each segment; KeyError where it holds what has no known bounds."""
        known = {name: self._ranges(name) for name in self.leaves}
        starts, lengths = self.starts, self.timeline.lengths
        given = {self.time: Interval(starts, starts + lengths), **{
            name: Interval(found.low, found.high) for name, found in known.items()}}
        constants = {name: jet.value for name, jet in self.constants.items()}
        with np.errstate(all="ignore"):
            whole = evaluate([self.node], Intervals, {**constants, **given})[0]
            ends = [evaluate([self.node], Arrays, {**self.floats, self.time: time, **{
                name: getattr(found, end) for name, found in known.items()}})[0]
                for end, time in (("starts", starts), ("ends", starts + lengths))]
        return OutputRanges(*(np.broadcast_to(row, starts.shape) for row in (*ends, whole.low, whole.high)))

    def _ranges(self, name: str) -> OutputRanges:
        """The OutputRanges of a leaf on the segments."""
        leaf, segment, later = self.leaves[name], self.segments[name], self.later[name]
        if leaf.recorded and not later.any():
            return OutputRanges(*(row[segment] for row in leaf.pieces.ranges(leaf.output)))
        last = np.append(self.timeline.lengths[:-1], 0.0)
        whole = leaf.jet(segment, later, later + last).value
        starts, ends = (leaf.at(segment, later + by) for by in (0.0, last))
        return OutputRanges(starts, ends, *(np.append(np.asarray(row)[:-1], end)
                                            for row, end in ((whole.low, -np.inf), (whole.high, np.inf))))

    def terms(self, output: Any, order: int) -> "Derivative":
        """What Pieces.terms gives of one output."""
        return Derivative(self, order)

    def at(self, segment: np.ndarray, tau: np.ndarray) -> np.ndarray:
        values = {name: leaf.at(self.segments[name][segment], tau + self.later[name][segment])
                  for name, leaf in self.leaves.items()}
        times = self.starts[segment] + tau
        with np.errstate(all="ignore"):
            found = evaluate([self.node], Arrays, {**self.floats, **values, self.time: times})[0]
        return self.check(np.broadcast_to(found, times.shape), times)

    def jet(self, segment: np.ndarray, early: np.ndarray, late: np.ndarray) -> Jet:
        return self._composed("jet", segment, early, late)

    def size(self, segment: np.ndarray, early: np.ndarray, late: np.ndarray) -> Jet:
        return self._composed("size", segment, early, late)

    def _composed(self, which: str, *where: np.ndarray) -> Jet:
        """That of the last call where it is asked for again, as its slope and curvature are."""
        last = self._last.get(which)
        if last is None or not all(map(np.array_equal, last[0], where)):
            last = self._last[which] = tuple(part.copy() for part in where), self._found(which, *where)
        return cast("Jet", last[1])

    def _found(self, which: str, segment: np.ndarray, early: np.ndarray, late: np.ndarray) -> Jet:
        values = {name: getattr(leaf, which)(self.segments[name][segment], *(
            tau + self.later[name][segment] for tau in (early, late))) for name, leaf in self.leaves.items()}
        values[self.time] = Jet(Interval(self.starts[segment] + early, self.starts[segment] + late), exact(1.0))
        with np.errstate(all="ignore"):
            found = evaluate([self.node], Jets, {**self.constants, **values})[0]
        return Jet(*(Interval(*(np.broadcast_to(end, early.shape) for end in (part.low, part.high)))
                     for part in (found.value, found.slope, found.curvature)))


class Derivative:
    """The order-th derivative of a Composition, 0, 1 or 2."""

    def __init__(self, whole: Composition, order: int) -> None:
        self.whole, self.order = whole, order

    def nodes(self) -> list[tuple[complex, ...]]:
        return self.whole.nodes * WORTH

    def at(self, segment: np.ndarray, tau: np.ndarray) -> np.ndarray:
        if not self.order:
            return self.whole.at(segment, tau)
        found = self.whole.jet(segment, tau, tau)
        part = found.slope if self.order == 1 else found.curvature
        with np.errstate(invalid="ignore"):
            middle = 0.5 * (part.low + part.high)
        return np.where(np.isfinite(middle), middle, 0.0)

    def bound(self, segment: np.ndarray, early: np.ndarray, late: np.ndarray) -> float | np.ndarray:
        """Of the value as if nothing cancelled, where that is bounded: roundings are in proportion to it. Of the
        curvature what the slope can change by, at most."""
        found = self.whole.jet(segment, early, late)
        if self.order == 0:
            alone = self.whole.size(segment, early, late).value.size
            size = np.where(np.isfinite(alone), alone, found.value.size)
            return np.where(size < LOST, 0.0, size)
        if self.order == 1:
            return found.slope.size
        width = late - early
        with np.errstate(all="ignore"):
            change = 2 * (found.slope.high - found.slope.low) / width
        size = np.fmin(found.curvature.size, change)
        short = instants(self.whole.timeline, Cells(segment, early, late), fastest(self.whole.nodes))
        return np.where(short, 0.0, size)
