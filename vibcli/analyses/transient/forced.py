"""One block driven by the waves of a timeline: what its c(τ) is made of on each segment."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.transient.exponential_differences import differences
from vibcli.analyses.transient.modal_block import ModalBlock, paths
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.transient.forcing_arrays import Timeline

APART, SPLIT = 0.1, 2.0


class Drive(NamedTuple):
    """The part k! input · E[…, s…s](τ) of c on the segments `at`; inputs: one row a segment."""

    power: int
    exponent: complex
    at: np.ndarray
    inputs: np.ndarray
    after: float

    @property
    def nodes(self) -> tuple[complex, ...]:
        return (self.exponent,) * (self.power + 1)


def drives(blocks: Sequence[ModalBlock], timeline: "Timeline", strict: bool = False) -> list[list[Drive]]:
    """The drives of each block. Of a half block both e^{sτ} and its conjugate; of others the real part is taken later.

    after: from which τ on the response splits into e^{λτ} and waves without loss, the exponent lying apart from the one
    eigenvalue; infinite where it does not, or where `strict`.
    """
    if not blocks:
        return []
    W = np.concatenate([block.W for block in blocks])
    stops = np.cumsum([0] + [len(block.B) for block in blocks]).tolist()
    found = [[] for _ in blocks]
    for waves in timeline.waves:
        if not waves.pushes(W.shape[1]):
            continue
        s, inputs = waves.exponent, waves.through(W)
        turned = waves.through(W, True) if s.imag and any(block.half for block in blocks) else None
        for block, mine, *ends in zip(blocks, found, stops, stops[1:], strict=False):
            at, node = slice(*ends), block.nodes[0]
            both = block.half and s.imag
            pairs = ((s, inputs / 2), (s.conjugate(), turned / 2)) if both else ((s, inputs),)
            for exponent, given in pairs:
                gap = abs(exponent - node)
                apart = not strict and len(block.B) == 1 and gap > APART * max(abs(exponent), abs(node))
                after = SPLIT * (waves.power + 1) / gap if apart else math.inf
                mine.append(Drive(waves.power, exponent, waves.at, given[:, at], after))
    return found


def fractions(drive: Drive, node: complex) -> list[tuple[int, np.ndarray]]:
    """c of a drive that splits, Σ gᵢ τⁱ e^{sτ} − g₀ e^{λτ}, as [(i, inputs · gᵢ)]."""
    gap, found, factor = drive.exponent - node, [], 1.0 + 0j
    for power in reversed(range(drive.power + 1)):
        factor = factor / gap if power == drive.power else -factor * (power + 1) / gap
        found.append((power, drive.inputs * factor))
    return found


def ends(block: ModalBlock, found: Sequence[Drive], timeline: "Timeline") -> tuple[np.ndarray, np.ndarray]:
    """c at the start of every segment, given its drives; the first row is left to be added to."""
    count, p = len(timeline.starts), len(block.B)
    if count == 1:
        return np.zeros((0, p, p), complex), np.zeros((1, p), complex)
    lengths, (unique, which) = timeline.lengths[:-1], timeline.steps
    step, added = np.zeros((count - 1, p, p), complex), np.zeros((count, p), complex)
    for i, j, product, nodes in paths(block.B):
        step[:, i, j] += product * differences(nodes, unique)[which]
        for drive in found:
            at: Any         # a slice or indices
            after: Any
            inside = slice(count - 1) if len(drive.at) == count else drive.at < count - 1
            at, after = (inside, slice(1, None)) if len(drive.at) == count else (drive.at[inside], drive.at[inside] + 1)
            few = len(lengths[at]) < len(unique)
            response = differences(nodes + drive.nodes, lengths[at] if few else unique)
            factor = math.factorial(drive.power) * product * drive.inputs[inside, j]
            added[after, i] += factor * (response if few else response[which[at]])
    return step, added


def marched(step: np.ndarray, added: np.ndarray, initial: np.ndarray) -> np.ndarray:
    """c at the start of every segment, c ← step c + added."""
    out = added.copy()
    out[0] += initial
    if step.shape[1] == 1:
        c, single = out[0, 0], step[:, 0, 0].tolist()
        column = out[:, 0].tolist()
        for at, factor in enumerate(single, 1):
            c = column[at] = factor * c + column[at]
        out[:, 0] = column
        return out
    for at in range(1, len(out)):
        out[at] += step[at - 1] @ out[at - 1]
    return out
