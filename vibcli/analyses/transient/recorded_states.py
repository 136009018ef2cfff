"""The states of a linear motion at the starts of very many segments.

Of a block of one eigenvalue, under forces Σ aⱼ τᵏ e^{sτ} in which channels share,

    cₙ₊₁ = e^{λh} cₙ + Σ k! E[λ, s…s](h) W aⱼ

whose coefficients are found once for all segments of one length; those of all such blocks are marched together, in
parts that stay near the processor. Blocks of several eigenvalues go by themselves.
"""

import math
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.transient.exponential_differences import differences
from vibcli.analyses.transient.forced import drives, ends
from vibcli.analyses.transient.straight_sum import shapes
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.recurrences import ROW, recurrence, recurrence_of_matrices

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.transient.forcing_arrays import Timeline
    from vibcli.analyses.transient.linear_response import LinearMotion
    from vibcli.analyses.transient.modal_block import ModalBlock
    from vibcli.base.work import Task

PART = 64 * ROW            # segments that are marched together
MOST, STRETCHES = 20_000, 4000      # steps, each so many stretches of time of one exponential


class SharedDrive(NamedTuple):
    """k! E[λ, s…s] W a: series: a of each segment; weights: W a / a of each block."""

    power: int
    exponent: complex
    series: np.ndarray
    weights: np.ndarray

    def responses(self, nodes: "Sequence[complex]", lengths: np.ndarray) -> np.ndarray:
        """What one of the series adds within a segment of each length: (blocks, lengths)."""
        tail, factor = (self.exponent,) * (self.power + 1), math.factorial(self.power)
        return np.array([differences((node, *tail), lengths) * (factor * weight) if weight else 0 * lengths
                         for node, weight in zip(nodes, self.weights.tolist(), strict=True)], complex)


def recorded_states(motion: "LinearMotion", timeline: "Timeline") -> list[np.ndarray]:
    """c of each block at the starts of the segments: (segments, p)."""
    found = dict.fromkeys(range(len(motion.blocks)))
    single = [number for number, block in enumerate(motion.blocks) if len(block.B) == 1]
    with np.errstate(over="ignore", invalid="ignore"), motion.work.task(
            "the motion from one sample of its loads to the next", MOST) as task:
        if single:
            rows = _marched(motion, [motion.blocks[number] for number in single], timeline, task)
            found |= {number: row[:, None] for number, row in zip(single, rows, strict=True)}
        for number in found.keys() - set(single):
            task.step(steps=len(timeline.starts) * len(motion.blocks[number].B)**2 / STRETCHES)
            found[number] = _apart(motion, motion.blocks[number], timeline)
    return list(found.values())


def _apart(motion: "LinearMotion", block: "ModalBlock", timeline: "Timeline") -> np.ndarray:
    """c of one block of several eigenvalues."""
    step, added = ends(block, drives([block], timeline)[0], timeline)
    added += timeline.impulses[:, :len(motion.M)] @ block.W.T
    first = added[0] + block.P @ motion.q0 + block.R @ motion.v0
    return np.concatenate([first[None], recurrence_of_matrices(step, added[1:], first)])


def _marched(motion: "LinearMotion", blocks: "Sequence[ModalBlock]", timeline: "Timeline", task: "Task") -> np.ndarray:
    """c of blocks of one eigenvalue: (blocks, segments)."""
    count, (unlike, which) = len(timeline.starts), timeline.steps
    nodes, driven = [block.nodes[0] for block in blocks], _driven(blocks, timeline)
    W, P, R = (np.concatenate([getattr(block, kind) for block in blocks]) for kind in "WPR")
    blows, found = timeline.impulses[:, :len(motion.M)], np.empty((len(blocks), count), complex)
    struck = blows.any()
    found[:, 0] = P @ motion.q0 + R @ motion.v0 + W @ blows[0]
    known = _responses(nodes, driven, unlike) if len(unlike) <= PART else None
    for start in range(0, count - 1, PART):
        task.step(start / count, len(blocks) * PART / STRETCHES)
        part = slice(start, min(start + PART, count - 1))
        after = slice(start + 1, part.stop + 1)
        if known is None:
            kept, *responses = _responses(nodes, driven, timeline.lengths[part])
        else:
            kept, *responses = known if len(unlike) == 1 else (table[:, which[part]] for table in known)
        added = np.zeros((len(blocks), part.stop - start), complex)
        for response, one in zip(responses, driven, strict=True):
            added += response * one.series[part]
        if struck:
            added += W @ blows[after].T
        found[:, after] = recurrence(kept, added, found[:, start])
    return found


def _responses(nodes: list[complex], driven: "Sequence[SharedDrive]", lengths: np.ndarray) -> list[np.ndarray]:
    """[e^{λh}, and what each SharedDrive adds] for lengths h; under straight lines all blocks at once."""
    if not any(one.exponent or one.power > 1 for one in driven):
        kept, *lines = shapes(np.array(nodes), lengths)
        return [kept, *(lines[one.power] * one.weights[:, None] for one in driven)]
    return [np.array([differences((node,), lengths) for node in nodes], complex),
            *(one.responses(nodes, lengths) for one in driven)]


def _driven(blocks: "Sequence[ModalBlock]", timeline: "Timeline") -> list[SharedDrive]:
    """What drives blocks of one eigenvalue: of those that stand for two both e^{sτ} and its conjugate."""
    W, half = np.concatenate([block.W for block in blocks]), np.array([block.half for block in blocks])
    found = []
    for waves in timeline.waves:
        s = waves.exponent
        for column, shares in zip(waves.coefficients.T, waves.shares, strict=True):
            weights, series = W @ shares[:W.shape[1]], np.ascontiguousarray(column)
            if weights.any() and s.imag:
                found.append(SharedDrive(waves.power, s, series, weights * np.where(half, 0.5, 1.0)))
                found.append(SharedDrive(waves.power, s.conjugate(), series.conj(), weights * np.where(half, 0.5, 0.0)))
            elif weights.any():
                found.append(SharedDrive(waves.power, s, series, weights))
    return found

