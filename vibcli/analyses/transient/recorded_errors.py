"""Bounds of the errors of a linear motion under long records: as those of others, carried from row to row of segments.

In a row each segment counts as the one that holds the most, and nothing that it adds fades before the end of the row.
The recurrence of the states rounds in a row what that holds, up to twice the largest of it, beside each state itself.
Loads are straight between samples, whose instants may be half a rounding off: that moves what they change by in a
segment, and what they jump by at its start, by as much.
"""

import math
from collections.abc import ValuesView
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.transient.motion_errors import EPSILON, ROUNDINGS, MotionErrors, buckets_of
from vibcli.numerics.recurrences import ROW, recurrence, recurrence_of_matrices, row_maxima

if TYPE_CHECKING:
    from vibcli.analyses.transient.forcing_arrays import Timeline
    from vibcli.analyses.transient.motion_errors import Drawn
    from vibcli.analyses.transient.recorded_pieces import RecordedPieces


class RecordedErrors(MotionErrors):
    """Of the motion that RecordedPieces hold. starts: bounds of ε in each row of segments, and at the last start."""

    pieces: "RecordedPieces"

    def _near(self, segment: np.ndarray) -> "tuple[tuple[Timeline, list[Drawn]], np.ndarray]":
        segments, local = np.unique(segment, return_inverse=True)
        near = self.pieces.among(segments)
        return (near.timeline, self._parts(near.timeline, near.states)), local

    def _started(self, segment: np.ndarray) -> np.ndarray:
        last = len(self.timeline.starts) - 1
        return self.starts[:, np.where(segment == last, -1, segment // ROW)]

    def _carried(self) -> np.ndarray:
        lengths = self.timeline.lengths[:-1]
        if not len(lengths):
            return self._first()[:, None]
        firsts = np.arange(0, len(lengths), ROW)
        spans = np.add.reduceat(lengths, firsts)
        added = self._added(lengths, firsts) + self._struck_in(firsts)
        ends, which = buckets_of(spans)
        kept = self._summed(self.plain, (), *ends)
        within = self._summed(self.plain, (), 0 * ends[0], ends[1])
        added = np.einsum("rij,jr->ir", within[which], added)
        found = np.empty((self.count, len(firsts) + 1))
        found[:, 0] = self._first()
        for at in self.system.places:
            one = at.stop - at.start == 1
            found[at, 1:] = recurrence(kept[which, at, at].reshape(1, -1), added[at], found[at, 0]) if one else (
                recurrence_of_matrices(kept[which, at, at], added[at].T, found[at, 0]).T)
        found[:, :-1] = np.einsum("rij,jr->ir", within[which], found[:, :-1]) + added
        return found

    def _added(self, lengths: np.ndarray, firsts: np.ndarray) -> np.ndarray:
        """What the segments of each row add."""
        ends, which = buckets_of(lengths)
        counts = np.stack([np.add.reduceat(which == k, firsts, dtype=float) for k in range(len(ends[0]))])
        free = np.concatenate([row_maxima(np.abs(c.T)) for c in self.pieces.states])
        perturbed, plain, _ = self._gains((), *ends)
        found: np.ndarray = np.einsum("kij,kr,jr->ir", perturbed + 2 * ROUNDINGS * EPSILON * plain, counts, free)
        W = self.system.W
        for waves in self.timeline.waves:
            perturbed, plain, _ = self._gains((waves.exponent,) * (waves.power + 1), *ends)
            gains = math.factorial(waves.power) * (perturbed + ROUNDINGS * EPSILON * plain)
            pushed = np.abs(W) @ np.abs(waves.shares[:, :W.shape[1]]).T
            most = row_maxima(np.abs(waves.coefficients.T))
            found += np.einsum("kij,kr,jr->ir", gains, counts, pushed @ most)
        return found

    def _struck_in(self, firsts: np.ndarray) -> np.ndarray:
        """What blows and rounded instants add in each row."""
        timeline, n = self.timeline, len(self.motion.M)
        lengths, late = timeline.lengths[:-1], 2 * EPSILON * timeline.starts[1:]
        pushed = np.add.reduceat(4 * EPSILON * np.abs(timeline.impulses[1:, :n]), firsts).T
        for shares, series in _by_shares(timeline):
            start, end = np.zeros(len(lengths) + 1), np.zeros(len(lengths))
            for waves, column in series:
                start += np.real(column) if not waves.power else 0.0
                end += np.real(column[:-1] * waves.grown(lengths))
            changed = np.abs(np.diff(start)) + 2 * np.abs(start[1:] - end)
            pushed += np.multiply.outer(np.abs(shares[:n]), np.add.reduceat(late * changed, firsts))
        found: np.ndarray = np.abs(self.system.W) @ pushed
        return found


def _by_shares(timeline: "Timeline") -> ValuesView[Any]:
    """[(shares, [(Waves, column)])] of all that channels have the same shares in."""
    found: dict[bytes, tuple[np.ndarray, list[tuple[Any, np.ndarray]]]] = {}
    for waves in timeline.waves:
        for column, shares in zip(waves.coefficients.T, waves.shares, strict=True):
            found.setdefault(shares.tobytes(), (shares, []))[1].append((waves, column))
    return found.values()

