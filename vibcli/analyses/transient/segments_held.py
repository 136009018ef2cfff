"""Which of many segments may hold what is searched: all others are passed over by arrays."""

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.transient.isolating_intervals import EPSILON, BoundedOutput

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.recorded_pieces import RecordedPieces

PART = 10_000       # segments that are searched together
ROUNDINGS = 64      # of the largest value, in units of EPSILON, that are not told apart


def highest(pieces: Any, output: "LinearOutput | None", ends: tuple[float, float], sign: float,
            margin: float) -> list[tuple[float, Callable[[], BoundedOutput]]]:
    """[(what none of its values exceeds, gives a BoundedOutput)] of the segments between two instants that may hold the
    largest value times a sign, or one less by a margin: those that hold the highest first."""
    if not pieces.recorded:
        return [(np.inf, partial(BoundedOutput, pieces, output, *ends))]
    found, segments = pieces.ranges(output), _between(pieces, ends)
    tops = (found.high if sign > 0 else -found.low)[segments]
    tops[[0, -1]] = np.inf
    known = sign * np.concatenate([found.starts[segments[1:]], found.ends[segments[1:-1]]])
    known = known[np.isfinite(known)]
    least = known.max(initial=-np.inf) - margin - ROUNDINGS * EPSILON * np.abs(known).max(initial=0.0)
    segments, tops = segments[tops >= least], tops[tops >= least]
    order = np.argsort(-tops, kind="stable")
    return [(tops[order[i]], _some(pieces, output, ends, np.sort(segments[order[i:i + PART]])))
            for i in range(0, len(order), PART)]


def passing(pieces: Any, output: "LinearOutput | None",
            ends: tuple[float, float]) -> tuple[list[Callable[[], BoundedOutput]], np.ndarray]:
    """([gives a BoundedOutput] of the segments between two instants that may hold a zero, ascending; the instants at
    which one starts on the other side of zero)."""
    if not pieces.recorded:
        return [partial(BoundedOutput, pieces, output, *ends)], np.zeros(0)
    found, segments = pieces.ranges(output), _between(pieces, ends)
    crossed = segments[1:][found.ends[segments[:-1]] * found.starts[segments[1:]] < 0]
    size = np.abs(found.starts[segments]).max(initial=0.0)
    apart = np.maximum(found.low, -found.high)[segments]
    apart[[0, -1]] = -np.inf
    segments = segments[apart <= ROUNDINGS * EPSILON * size]
    return [_some(pieces, output, ends, segments[i:i + PART])
            for i in range(0, len(segments), PART)], pieces.timeline.starts[crossed]


def _some(pieces: "RecordedPieces", output: "LinearOutput", ends: tuple[float, float],
          segments: np.ndarray) -> Callable[..., BoundedOutput]:
    return lambda: BoundedOutput(pieces.among(segments), output, *ends)


def _between(pieces: "RecordedPieces", ends: tuple[float, float]) -> np.ndarray:
    first, last = pieces.timeline.place(np.array(ends))[0]
    return np.arange(first, last + 1)
