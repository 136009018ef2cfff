"""Between which values an output of a linear motion stays on each of many segments, from the states at their starts.

On a segment of the length h it strays from a straight line by no more than B h²/8, B a bound of its second derivative.
Of a state ċ = B c + W f that is row · c̈ with

    c̈(τ) = e^{Bτ} c̈(0) + ∫ e^{B(τ − s)} W f̈(s) ds,      c̈(0) = B (B c + W f(0)) + W ḟ(0)

where what stands still under a force has cancelled, and f̈ = 0 under straight lines.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.transient.exponential_differences import bounds
from vibcli.analyses.transient.markov_parameters import direct, markov
from vibcli.analyses.transient.modal_block import paths
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.forcing_arrays import Timeline
    from vibcli.analyses.transient.pieces import Pieces
    from vibcli.analyses.transient.recorded_pieces import RecordedPieces

EPSILON = 2.0**-52
ROUNDINGS = 32      # of the terms of a value, in units of EPSILON
PART = 4096         # segments that are looked at together, so that they stay near the processor


class OutputRanges(NamedTuple):
    """Of each segment the values at its start and before its end, and what it stays between; of the last, which does
    not end, all numbers."""

    starts: np.ndarray
    ends: np.ndarray
    low: np.ndarray
    high: np.ndarray


class Share(NamedTuple):
    """What adds to an output: its values at the starts of segments and before the ends of all but the last, the most of
    its second derivative on these, and of the terms of its values."""

    starts: np.ndarray
    ends: np.ndarray
    bend: np.ndarray
    size: float


def ranges_of(pieces: "RecordedPieces", output: "LinearOutput") -> OutputRanges:
    """The OutputRanges of an output."""
    count = len(pieces.timeline.starts)
    starts, ends, low, high = (np.full(count, x) for x in (0.0, np.nan, -np.inf, np.inf))
    H, rows = markov(pieces.motion, 2), [block.rows(output, 0) for block in pieces.motion.blocks]
    for start in range(0, max(1, count - 1), PART):
        part = slice(start, min(start + PART, count - 1))
        near = pieces.among(slice(start, part.stop + 1))
        with np.errstate(over="ignore", invalid="ignore"):
            shares = [*_of_blocks(near, rows), *_direct(near, output, H)]
            constant = output.constant if near.motion.constants else 0.0
            starts[start:part.stop + 1] = sum((one.starts for one in shares), constant)
            ends[part] = sum((one.ends for one in shares), constant)
            room = sum(one.bend for one in shares) * near.timeline.lengths[:-1]**2 / 8
            room += ROUNDINGS * EPSILON * (sum(one.size for one in shares) + abs(constant))
        room[~np.isfinite(room)] = np.inf
        low[part] = np.minimum(starts[part], ends[part]) - room
        high[part] = np.maximum(starts[part], ends[part]) + room
    return OutputRanges(starts, ends, low, high)


def _of_blocks(near: "Pieces", rows: list[np.ndarray]) -> Iterator[Share]:
    """What the blocks add: those of one eigenvalue together."""
    single = []
    for block, row, c in zip(near.motion.blocks, rows, near.states, strict=True):
        if len(row) == 1:
            single.append((block.B[0, 0], block.W[0], row[0], c[:, 0]))
        else:
            moved = _bent(near.timeline, (block.B @ block.B @ c[:-1].T, block.B @ block.W), block.W)
            lengths = near.timeline.lengths[:-1]
            bend = sum(abs(row[i] * product) * bounds(nodes, 0.0 * lengths, lengths) * moved[j]
                       for i, j, product, nodes in paths(block.B))
            yield _share(near.timeline, row, block.W, c.T, bend)
    if single:
        nodes, W, row, c = map(np.array, zip(*single, strict=True))
        growth = np.maximum(nodes.real, 0.0)
        moved = _bent(near.timeline, ((nodes**2)[:, None] * c[:, :-1], nodes[:, None] * W), W)
        if growth.any():
            moved *= np.exp(np.multiply.outer(growth, near.timeline.lengths[:-1]))
        yield _share(near.timeline, row, W, c, np.abs(row) @ moved)


def _share(timeline: "Timeline", row: np.ndarray, W: np.ndarray, c: np.ndarray, bend: np.ndarray) -> Share:
    values = (row @ c).real
    ends, blows = values[1:], timeline.impulses[1:, :W.shape[1]]
    if blows.any():
        ends = ends - blows @ (row @ W).real
    return Share(values, ends, bend, float(np.abs(row) @ np.abs(c).max(axis=1)))


def _bent(timeline: "Timeline", own: tuple[np.ndarray, np.ndarray], W: np.ndarray) -> np.ndarray:
    """|c̈(0)| and what f̈ adds to it on each segment but the last, (p, segments); own: (B² c, B W)."""
    moved, BW = own
    real, imaginary = moved.real, moved.imag
    for order, A in enumerate((BW, W)):
        for waves in timeline.waves:
            factor = waves.derivative(order).get(0, 0.0)
            if factor:
                rows, weights = np.real(factor * waves.coefficients[:-1]).T, A @ waves.shares[:, :A.shape[1]].T
                real += weights.real @ rows
                imaginary += weights.imag @ rows
    found, lengths = np.abs(moved), timeline.lengths[:-1]
    for waves in timeline.waves:
        if waves.exponent:
            grown = sum(abs(factor) * lengths**power for power, factor in waves.derivative(2).items())
            found += lengths * grown * np.exp(max(waves.exponent.real, 0.0) * lengths) * waves.size(W)[:, :-1]
    result: np.ndarray = found
    return result


def _direct(near: "Pieces", output: "LinearOutput", H: list[np.ndarray]) -> Iterator[Share]:
    """What forces bring at once."""
    motion, timeline = near.motion, near.timeline
    if not (output.a or output.channels or motion.system is not None):
        return
    lengths = timeline.lengths[:-1]
    for i, row in direct(output, 0, H, motion.forcing.channels).items():
        for waves in timeline.waves:
            given, s = waves.onto(row), waves.exponent
            starts = sum(np.real(factor * given) * (not power) for power, factor in waves.derivative(i).items())
            ends = sum(np.real(factor * given[:-1] * np.exp(s * lengths)) * lengths**power
                       for power, factor in waves.derivative(i).items())
            bend = sum(abs(factor) * np.abs(given[:-1]) * lengths**power * np.exp(max(s.real, 0.0) * lengths)
                       for power, factor in waves.derivative(i + 2).items())
            size = np.abs(given).max() * sum(abs(factor) * max(1.0, lengths.max(initial=0.0))**power
                                             for power, factor in waves.derivative(i).items())
            yield Share(starts + 0.0 * given.real, ends + 0.0 * lengths, bend + 0.0 * lengths, float(size))
