"""Where the motion starts that periodic forcing repeats: (1 − e^{BT}) c = what one period from rest brings.

What returns after a period whatever it is, a rest where nothing holds, or a free vibration at a harmonic n that no load
drives, is left open by that. It is taken such that it has no part in that harmonic, (1/T) ∫ c e^{−st} dt, s = 2πin/T;
of a rest that is the mean. Where the mean of the loads drives off what nothing holds, the motion under this mean, which
grows with the time, stands beside what the rest of them repeats.
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
from vibcli.analyses.transient.exponential_differences import differences
from vibcli.analyses.transient.following import UNFORCED, driven, moves_freely
from vibcli.analyses.transient.modal_block import ModalBlock, paths
from vibcli.analyses.transient.steady_errors import of_powers
from vibcli.analyses.transient.steady_state import RESONANT, harmonic_forces, lost_forces, resonance

if TYPE_CHECKING:
    from vibcli.analyses.transient.linear_response import LinearMotion, SteadyMotion


def drive_off(motion: "LinearMotion", forcing: Forcing) -> tuple[list[tuple[np.ndarray, np.ndarray]], list[np.ndarray]]:
    """([(Qₖ, Fₖ)] of Σ Qₖ tᵏ under the mean of the forces, [how far this may be off]); [] where it drives nothing
    off."""
    if moves_freely(motion.blocks):
        powers = driven(motion, harmonic_forces(forcing, 0)[1][None])
        if len(powers) > 1:
            return powers, [lost_forces(forcing, 0)]
    return [], []


def repeating(motion: "LinearMotion", forcing: Forcing,
              powers: list[tuple[np.ndarray, np.ndarray]]) -> tuple[np.ndarray, np.ndarray]:
    """(q, q̇) just before t = 0, beside the powers under the mean of the forces."""
    once, period = _once(forcing, powers), forcing.period
    rest = motion.like(once, *np.zeros((2, len(motion.M)))).pieces(math.inf)
    sizes = rest if not powers else motion.like(_once(forcing, []), *np.zeros((2, len(motion.M)))).pieces(math.inf)
    found = []
    for block, states, whole in zip(motion.blocks, rest.states, sizes.states, strict=True):
        c = _returning(block.B, period) @ states[-1]
        left = np.abs(growth(block.B, period) @ c + states[-1]).max()
        if left > UNFORCED * max(np.abs(states).max(), np.abs(whole).max()):
            raise resonance(block.nodes[0])
        found.append(c)
    if any(_free(block.B, period) for block in motion.blocks):
        summed = _summed(motion, once, _state(motion, found)).pieces(math.inf).states
        for c, block, ends in zip(found, motion.blocks, summed, strict=True):
            for s, part in zip(_free(block.B, period), ends[-1][:-len(c)].reshape(-1, len(c)) / period, strict=True):
                c -= _own(block.B, s, part, period)
    return _state(motion, found)


def errors_of(motion: "LinearMotion", steady: "SteadyMotion") -> tuple[np.ndarray, np.ndarray]:
    """(δq, δq̇) of the same: what a period adds, over 1 − e^{BT}, and what the mean of the rest is off by."""
    errors = _summed(motion, _once(steady.forcing, steady.powers), steady.repeated).pieces(math.inf).errors
    q, v = np.zeros((2, len(motion.M)))
    for row, error in zip((q, v), of_powers(motion, steady.powers, steady.lost), strict=False):
        row += error
    for block, at in zip(motion.blocks, errors.system.places, strict=True):
        p, ends = len(block.B), errors.starts[at, -1]
        c = np.abs(_returning(block.B, steady.period)) @ ends[-p:] + ends[:-p].reshape(-1, p).sum(0) / steady.period
        q += np.abs(block.X) @ c
        v += np.abs(block.X @ block.B) @ c
    return q, v


def _once(forcing: Forcing, powers: list[tuple[np.ndarray, np.ndarray]]) -> Forcing:
    """One period of it, less its mean where that drives what nothing holds, and nothing behind."""
    less = tuple(Wave(channel, complex(-F), 0, 0j) for _, row in powers[:1] for channel, F in enumerate(row) if F)
    pieces = [piece._replace(waves=piece.waves + less) for piece in forcing.pieces]
    return Forcing(forcing.channels, [*pieces, Segment(forcing.period)])


def _state(motion: "LinearMotion", found: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    q, v = np.zeros((2, len(motion.M)))
    for block, c in zip(motion.blocks, found, strict=True):
        q += np.real(block.X @ c)
        v += np.real(block.X @ (block.B @ c))
    return q, v


def _returning(B: np.ndarray, period: float) -> np.ndarray:
    """(1 − e^{BT})⁺, 0 for what returns whatever it is."""
    kept, size, term = -growth(B, period), np.eye(len(B)), np.eye(len(B))
    for power in range(1, len(B)):
        term = term @ np.abs(np.triu(B, 1)) * (period / power)
        size = size + term
    kept[np.abs(kept) <= RESONANT * size] = 0.0
    return np.linalg.pinv(kept, rcond=RESONANT)


def _free(B: np.ndarray, period: float) -> list[complex]:
    """The s of the harmonics at which the block vibrates freely, 0 where it rests anywhere."""
    return [complex(0, math.tau * n / period) for n in sorted({
        round(node.imag * period / math.tau) for node in B.diagonal() if _meets(node, period)})]


def _meets(node: complex, period: float) -> bool:
    """Is e^{λT} = 1?"""
    found: bool = abs(node * differences((complex(node), 0j), np.array([period]))[0]) <= RESONANT
    return found


def _own(B: np.ndarray, s: complex, part: np.ndarray, period: float) -> np.ndarray:
    """The free vibration e^{st} that has the same share as c in the coordinates which move freely so."""
    found = np.zeros(len(B), complex)
    for i in reversed(range(len(B))):
        if _meets(B[i, i] - s, period):
            found[i] = part[i]
        else:
            found[i] = B[i, i + 1:] @ found[i + 1:] / (s - B[i, i])
    return found


def _summed(motion: "LinearMotion", forcing: Forcing, start: tuple[np.ndarray, np.ndarray]) -> "LinearMotion":
    """The motion from a start, its blocks headed by ∫ c e^{s(t − τ)} dτ for each s at which they vibrate freely."""
    period = forcing.segments(math.inf)[-1].start
    return motion.like(forcing, *start, [_headed(block, _free(block.B, period)) for block in motion.blocks])


def _headed(block: ModalBlock, rates: Sequence[complex]) -> ModalBlock:
    p, more = len(block.B), len(block.B) * len(rates)
    B = np.zeros((more + p, more + p), complex)
    B[more:, more:] = block.B
    for k, s in enumerate(rates):
        at = slice(k * p, (k + 1) * p)
        B[at, at], B[at, more:] = s * np.eye(p), np.eye(p)
    above = np.zeros((more, block.X.shape[0]))
    P, R, W = (np.concatenate([above, rows]) for rows in (block.P, block.R, block.W))
    return ModalBlock(np.concatenate([above.T, block.X], axis=1), B, P, R, W, block.half,
                      None if more else block.accuracy)


def growth(B: np.ndarray, t: float) -> np.ndarray:
    """e^{Bt} − 1, its diagonal without loss."""
    out = np.zeros(B.shape, complex)
    for i, j, product, nodes in paths(B):
        if len(nodes) > 1:
            out[i, j] += product * differences(nodes, np.array([t]))[0]
        else:
            out[i, i] = nodes[0] * differences((nodes[0], 0j), np.array([t]))[0]
    return out
