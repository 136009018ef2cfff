"""A linear motion under long records: the states at all samples by arrays, sums of exponentials where one looks."""

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.transient.exponential_sum import ExponentialSum
from vibcli.analyses.transient.forcing_arrays import timeline_of_records
from vibcli.analyses.transient.output_ranges import OutputRanges, ranges_of
from vibcli.analyses.transient.pieces import Pieces, require_held
from vibcli.analyses.transient.recorded_states import recorded_states
from vibcli.analyses.transient.straight_sum import StraightSum, is_straight

if TYPE_CHECKING:
    from collections.abc import Callable

    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.linear_response import LinearMotion
    from vibcli.analyses.transient.motion_errors import MotionErrors

PART = 20_000           # segments that are looked at together


class RecordedPieces(Pieces):
    """Pieces of so many segments that what drives the blocks, and sums, are found of some of them at a time."""

    recorded = True
    known: "tuple[LinearOutput, OutputRanges] | None" = None

    def among(self, segments: np.ndarray | slice) -> Pieces:
        """The Pieces of some segments, ascending, which are numbered anew."""
        return SomePieces(self.motion, self.timeline.among(segments), [c[segments] for c in self.states], self.until)

    @cached_property
    def errors(self) -> "MotionErrors":
        from vibcli.analyses.transient.recorded_errors import RecordedErrors

        return RecordedErrors(self)

    def terms(self, output: "LinearOutput", order: int) -> "RecordedSum":
        return RecordedSum(self, output, order)

    def on(self, output: "LinearOutput", segment: int, split: bool = True) -> list[tuple[tuple[complex, ...], complex]]:
        return self.among(np.array([segment % len(self.timeline.starts)])).on(output, 0, split)

    def ranges(self, output: "LinearOutput") -> OutputRanges:
        """Between which values the output stays on each segment."""
        if self.known is None or self.known[0] != output:
            self.known = output, ranges_of(self, output)
        return self.known[1]


class SomePieces(Pieces):
    """Some segments of RecordedPieces."""

    def terms(self, output: "LinearOutput", order: int) -> Any:
        return StraightSum(self, output, order) if is_straight(self) else ExponentialSum(self, output, order)


class RecordedSum:
    """The order-th derivative of an output of RecordedPieces, as an ExponentialSum of some of their segments at a
    time."""

    def __init__(self, pieces: RecordedPieces, output: "LinearOutput", order: int) -> None:
        self.pieces, self.output, self.order = pieces, output, order

    def nodes(self) -> list[tuple[complex, ...]]:
        found: list[tuple[complex, ...]] = self.pieces.among(slice(1)).terms(self.output, self.order).nodes()
        return found

    def at(self, segment: np.ndarray, tau: np.ndarray) -> np.ndarray:
        return self._of(segment, lambda terms, which, here: terms.at(which, tau[here]))

    def bound(self, segment: np.ndarray, early: np.ndarray, late: np.ndarray) -> np.ndarray:
        return self._of(segment, lambda terms, which, here: terms.bound(which, early[here], late[here]))

    def _of(self, segment: np.ndarray, function: "Callable[[Any, np.ndarray, Any], np.ndarray]") -> np.ndarray:
        segments, which = np.unique(segment, return_inverse=True)
        found = np.empty(len(segment))
        for start in range(0, len(segments), PART):
            some = segments[start:start + PART]
            here = slice(None) if len(some) == len(segments) else (which >= start) & (which < start + PART)
            found[here] = function(self.pieces.among(some).terms(self.output, self.order), which[here] - start, here)
        return found


def recorded(motion: "LinearMotion") -> RecordedPieces:
    """The RecordedPieces of a motion under a RecordedForcing."""
    forcing: Any = motion.forcing
    timeline = timeline_of_records(forcing)
    require_held(motion, timeline)
    return RecordedPieces(motion, timeline, recorded_states(motion, timeline), np.inf)
