"""Modes of K + sC + s²M with a positive definite M, by eigenvalues of matrices of a system of unit mass.

M = L Lᵀ, q = L⁻ᵀ y:   ÿ + C̃ ẏ + K̃ y = L⁻¹ b,   C̃ = L⁻¹ C L⁻ᵀ,  K̃ = L⁻¹ K L⁻ᵀ.

Of symmetric ones that commute modes are real (Caughey & O'Kelly 1965, J. Appl. Mech. 32, 583).
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.frequency_response.direct import probe
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.fixed_point import count_floats
from vibcli.numerics.state_space import first_order

if TYPE_CHECKING:
    pass

COUPLED = 1e-14         # coupling by damping, relative to the damping of two modes
DEPENDENT = 1e8         # condition of the modes from which on LU has too much left to do
TURNED = 1e-13          # of the largest entry, by which D and its transpose may differ and count as one


class UnitMass(NamedTuple):
    """K̃, C̃ and L⁻ᵀ."""

    K: np.ndarray
    C: np.ndarray
    back: np.ndarray


def reduced_to_unit_mass(system: Any) -> UnitMass | None:
    """The UnitMass of M, C and K; None where M is not positive definite."""
    M = system.M
    if not _symmetric(M):
        return None
    masses = np.diag(M)
    if (masses > 0).all() and np.count_nonzero(M) == len(M):
        scale = 1 / np.sqrt(masses)
        return UnitMass(system.K * np.outer(scale, scale), system.C * np.outer(scale, scale), np.diag(scale))
    scale = np.exp2(-np.round(np.log2(np.where(masses > 0, masses, 1.0)) / 2))
    try:
        L = np.linalg.cholesky(M * np.outer(scale, scale))
    except np.linalg.LinAlgError:
        return None
    back = np.linalg.inv(L).T * scale[:, None]
    return UnitMass(back.T @ system.K @ back, back.T @ system.C @ back, back)


def _symmetric(matrix: np.ndarray) -> bool:
    return bool((np.abs(matrix - matrix.T) <= 1e-15 * np.abs(matrix)).all())


def _same(matrix: np.ndarray, other: np.ndarray) -> bool:
    found: bool = np.abs(matrix - other).max() <= TURNED * np.abs(matrix).max()
    return found


def decoupled(system: Any, reduced: UnitMass | None) -> "tuple[np.ndarray, np.ndarray, np.ndarray] | None":
    """(ω², 2ζω, shapes) of modes that damping does not couple; None where it does, and of what is not reduced."""
    if reduced is None or not (_symmetric(system.K) and _symmetric(system.C)):
        return None
    K, C, back = reduced
    if not _commute(K, C):
        return None
    squares, turn = np.linalg.eigh((K + K.T) / 2)
    damping = turn.T @ C @ turn
    size = np.abs(turn).T @ np.abs(C) @ np.abs(turn)
    if (np.abs(damping - np.diag(np.diag(damping))) > COUPLED * size).any():
        return None
    return squares, np.diag(damping), back @ turn


def _commute(K: np.ndarray, C: np.ndarray) -> bool:
    """Whether K C = C K but for rounding, as seen along one vector."""
    along = probe(len(K))
    apart = K @ (C @ along) - C @ (K @ along)
    K, C = np.abs(K), np.abs(C)
    return bool((np.abs(apart) <= COUPLED * len(K) * (K @ (C @ along) + C @ (K @ along))).all())


class PairedModes(NamedTuple):
    """λ of pairs above the axis and real ones; real vectors: right, (n, m), of a pair Re and Im; left, (m, n), None
    where D is the same as Dᵀ; shares gives left·b of the vectors that were asked for; pace, a frequency."""

    pairs: np.ndarray
    real: np.ndarray
    right: np.ndarray
    left: np.ndarray | None
    shares: Callable[[np.ndarray], np.ndarray]
    pace: float


def coupled(system: Any, reduced: UnitMass, asked: Sequence[np.ndarray]) -> PairedModes | None:
    """The PairedModes, in real numbers; None where these are nearly dependent."""
    K, C, back = reduced
    n = len(K)
    pace = np.sqrt(max(np.abs(K).max(), np.finfo(float).tiny))
    count_floats(2 * n)
    values, vectors = np.linalg.eig(first_order(K, C, pace))
    above, alone = values.imag > 0, values.imag == 0
    W = np.hstack([vectors.real[:, above], vectors.imag[:, above], vectors.real[:, alone]])
    try:
        shares, left = _shares(system, W, back, asked)
    except np.linalg.LinAlgError:
        return None
    right = back @ W[:n] / pace
    return shares and PairedModes(values[above], values[alone].real, right, left, shares, pace)


def _shares(system: Any, W: np.ndarray, back: np.ndarray,
            asked: Sequence[np.ndarray]) -> tuple[Callable[[np.ndarray], np.ndarray] | None, np.ndarray | None]:
    """(the function that gives L b, L), the latter None where D is the same as Dᵀ; (None, None) where the modes are
    nearly dependent, as seen along what is asked for."""
    n = len(back)
    if not all(_same(matrix, matrix.T) for matrix in (system.K, system.C, system.M)):
        inverse = np.linalg.inv(W)
        left = inverse[:, n:] @ back.T
        known = np.linalg.norm(inverse) * np.linalg.norm(W) < DEPENDENT
        return (lambda b: left @ b, left) if known else (None, None)
    right = np.concatenate([np.zeros((n, len(asked))), back.T @ np.stack(asked, axis=1)])
    found = np.linalg.solve(W, right)
    if not (np.linalg.norm(found, axis=0) * np.linalg.norm(W)
            <= DEPENDENT * np.linalg.norm(right, axis=0)).all():
        return None, None
    kept = {part.tobytes(): share for part, share in zip(asked, found.T, strict=True)}
    return (lambda b: kept[b.tobytes()]), None
