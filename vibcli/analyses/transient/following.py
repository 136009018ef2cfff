"""What follows loads Σ Fₖ tᵏ: q = Σ Qₖ tᵏ with K Qₖ + (k+1) C Qₖ₊₁ + (k+2)(k+1) M Qₖ₊₂ = Fₖ.

Where nothing holds some of what moves (an eigenvalue 0) the loads drive it off, by higher powers of the time than their
own: of the states ċ = B c + W F those with Bᵢᵢ = 0 are integrals. Where these begin is left open: where Q₀ is least.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.transient.data_errors import DATA
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.transient.linear_response import LinearMotion
    from vibcli.analyses.transient.modal_block import ModalBlock

UNFORCED, FINE = 1e-13, float(np.finfo(np.longdouble).eps)


def moves_freely(blocks: "Sequence[ModalBlock]") -> bool:
    """Is there an eigenvalue 0?"""
    return any(not node for block in blocks for node in block.nodes)


def not_held() -> PhysicsError:
    """The refusal of what has no steady state since loads drive it off."""
    return PhysicsError("there is no steady state: a constant force drives a motion that nothing holds, and this "
                        "signal sees it", "ask for what does not see it, as differences do, tie it with a spring, or "
                        "ask at a time")


def sees_what_moves_freely(blocks: "Sequence[ModalBlock]", output: "LinearOutput") -> bool:
    """Is a coordinate of an eigenvalue 0 in an output?"""
    return any(row for block in blocks for row, node in zip(block.rows(output, 0), block.nodes, strict=True)
               if not node)


def driven(motion: "LinearMotion", forces: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
    """[(Qₖ, Fₖ)] under forces Fₖ, a row each."""
    if not len(forces):
        return []
    loads = np.pad(forces, ((0, 2), (0, 0)))
    F = loads[:, :len(motion.M)]
    Q = _followed(motion, F, UNFORCED)
    Q -= _followed(motion, _residual(motion, Q, F), 1.0)
    count = max(len(forces), 1 + max(np.flatnonzero(Q.any(axis=1)), default=0))
    if count > len(forces):     # the last is a motion that nothing holds
        Q[0] -= Q[count - 1] * (Q[count - 1] @ Q[0]) / (Q[count - 1] @ Q[count - 1])
    return list(zip(Q[:count], loads, strict=False))


def _residual(motion: "LinearMotion", Q: np.ndarray, F: np.ndarray) -> np.ndarray:
    """K Qₖ + (k+1) C Qₖ₊₁ + (k+2)(k+1) M Qₖ₊₂ − Fₖ, in extended precision."""
    return sum((taken @ matrix.T.astype(np.longdouble) for taken, matrix in zip(
        _with_rates(Q.astype(np.longdouble)), (motion.K, motion.C, motion.M), strict=True)), -F).astype(float)


def _with_rates(Q: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The coefficients of Σ Qₖ tᵏ and of its first two derivatives."""
    k = np.arange(1, len(Q) + 1)[:, None]
    above = np.pad(Q, ((0, 2), (0, 0)))
    return Q, k * above[1:-1], k * (k + 1) * above[2:]


def _followed(motion: "LinearMotion", F: np.ndarray, unforced: float) -> np.ndarray:
    """The Qₖ under Fₖ; what moves freely follows what is more than so much of its terms alone."""
    Q = np.zeros(F.shape) if motion.system is None else F @ motion.system.follow.T
    for block in motion.blocks:
        Q += np.real(_states(block.B, F @ block.W.T, np.abs(F) @ np.abs(block.W).T, unforced) @ block.X.T)
    return Q


def _states(B: np.ndarray, given: np.ndarray, sizes: np.ndarray, unforced: float) -> np.ndarray:
    """The cₖ of Σ cₖ tᵏ with ċ = B c + given."""
    count, above = len(given), np.triu(B, 1)
    c = np.zeros(given.shape, complex)
    for i in reversed(range(len(B))):
        rest = given[:, i] + c @ above[i]
        if not B[i, i]:
            rest[np.abs(rest) <= unforced * (sizes[:, i] + np.abs(c) @ np.abs(above[i]))] = 0.0
            c[1:, i] = rest[:-1] / np.arange(1, count)
            continue
        for k in reversed(range(count)):
            rest[k] -= (k + 1) * c[k + 1, i] if k + 1 < count else 0.0
            c[k, i] = -rest[k] / B[i, i]
    return c


def errors_of(motion: "LinearMotion", powers: "Sequence[tuple[np.ndarray, np.ndarray]]",
              lost: "Sequence[np.ndarray] | np.ndarray") -> np.ndarray:
    """|δQₖ| of powers [(Qₖ, Fₖ)], a row each; lost: how far the first Fₖ may be off beside a rounding."""
    n, data = len(motion.M), motion.data_errors
    Q, F = np.array([one for one, _ in powers]), np.array([one[:n] for _, one in powers])
    missed = 4 * DATA * np.abs(F) + np.abs(_residual(motion, Q, F))
    for row, off in zip(missed, lost, strict=False):
        row += off[:n]
    for taken, matrix, (weights, rows), entries in zip(
            _with_rates(Q), (motion.K, motion.C, motion.M), data.weights, data.entries, strict=True):
        missed += (weights * np.abs(taken @ rows.T)) @ np.abs(rows)
        missed += np.abs(taken) @ (entries + (n + 4) * FINE * np.abs(matrix)).T
    found = np.zeros(Q.shape) if motion.system is None else missed @ np.abs(motion.system.follow).T
    for block in motion.blocks:
        found += _grown(np.abs(block.B), missed @ np.abs(block.W).T) @ np.abs(block.X).T
    return found


def _grown(B: np.ndarray, given: np.ndarray) -> np.ndarray:
    """Bounds of the cₖ under bounds of what is given."""
    count, above = len(given), np.triu(B, 1)
    c = np.zeros(given.shape)
    for i in reversed(range(len(B))):
        rest = given[:, i] + c @ above[i].T
        if not B[i, i]:
            c[1:, i] = rest[:-1] / np.arange(1, count)
            continue
        for k in reversed(range(count)):
            c[k, i] = (rest[k] + ((k + 1) * c[k + 1, i] if k + 1 < count else 0.0)) / B[i, i]
    return c
