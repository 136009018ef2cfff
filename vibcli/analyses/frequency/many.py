"""H(iΩ) of many degrees of freedom at many frequencies: banded LU, real modes where damping does not couple them, else
complex modes."""

import numpy as np

from vibcli.analyses.frequency.response import SINGULAR, direct, probe, scales
from vibcli.analyses.frequency.transfer import polynomial

NARROW, COUPLED = 16, 1e-14     # widest band on either side; coupling relative to the damping of two modes
DEPENDENT = 1e5                 # condition of complex modes from which on they lose too many digits


def chosen(system):
    """The method for this system, (system, Omega) → (values, resonant); None where neither fits."""
    order, width = _ordered(system)
    if width <= NARROW:
        return lambda system, Omega: _banded(system, Omega, order, width)
    reduced = _reduced(system)
    if reduced is None:
        return None
    modes = _modes(system, *reduced)
    if modes is not None:
        return lambda system, Omega: _modal(system, Omega, *modes)
    modes = _complex_modes(*reduced)
    return None if modes is None else lambda system, Omega: _by_complex_modes(system, Omega, *modes)


def _ordered(system):
    """(order of the coordinates, half the width of the band)."""
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import reverse_cuthill_mckee

    pattern = (system.K != 0) | (system.M != 0) | (system.C != 0)
    pattern |= pattern.T
    order = reverse_cuthill_mckee(csr_array(pattern), symmetric_mode=True)
    rows, columns = np.nonzero(pattern[np.ix_(order, order)])
    return order, int(np.abs(rows - columns).max(initial=0))


def _banded(system, Omega, order, width):
    from scipy.linalg import lapack

    n, at = system.n, np.arange(system.n)
    bands = np.zeros((3, 3 * width + 1, n))
    for k, matrix in enumerate((system.K, system.C, system.M)):
        rows, columns = np.nonzero(np.abs(at[:, None] - at) <= width)
        bands[k, 2 * width + rows - columns, columns] = matrix[np.ix_(order, order)][rows, columns]
    s, scale = 1j * Omega, scales(system, Omega)[:, order]
    b, c = polynomial(system.b, s)[:, order] * scale, polynomial(system.c, s)[:, order] * scale
    rows = np.clip(np.arange(3 * width + 1)[:, None] - 2 * width + at, 0, n - 1)
    values, lost = np.empty(len(Omega), complex), []
    right = np.empty((n, 2), complex)
    right[:, 1] = probe(n)
    for k, w in enumerate(Omega):
        band = (bands[0] - w * w * bands[2] + 1j * w * bands[1]) * scale[k] * scale[k][rows]
        right[:, 0] = b[k]
        _, _, x, info = lapack.zgbsv(width, width, band, right)
        if info or not np.abs(x[:, 1]).max() * SINGULAR * 64 < 1:
            lost.append(k)
        values[k] = c[k] @ x[:, 0]
    values += polynomial(system.d, s)
    resonant = np.zeros(len(Omega), bool)
    if lost:
        values[lost], resonant[lost] = direct(system, Omega[lost])
    return values, resonant


def _reduced(system):
    """(K̃, C̃, L⁻ᵀ) with M = L Lᵀ: q = L⁻ᵀ y gives ÿ + C̃ ẏ + K̃ y = L⁻¹ b; None where M is not positive definite."""
    M = system.M
    if not _symmetric(M):
        return None
    scale = np.exp2(-np.round(np.log2(np.where(np.diag(M) > 0, np.diag(M), 1.0)) / 2))
    try:
        L = np.linalg.cholesky(M * np.outer(scale, scale))
    except np.linalg.LinAlgError:
        return None
    back = np.linalg.inv(L).T * scale[:, None]
    return back.T @ system.K @ back, back.T @ system.C @ back, back


def _symmetric(matrix):
    return bool((np.abs(matrix - matrix.T) <= 1e-15 * np.abs(matrix)).all())


def _modes(system, K, C, back):
    """(λ₁ and λ₂ of each real mode, shapes) where damping does not couple them, else None."""
    if not (_symmetric(system.K) and _symmetric(system.C)):
        return None
    squares, turn = np.linalg.eigh((K + K.T) / 2)
    damping = turn.T @ C @ turn
    size = np.abs(turn).T @ np.abs(C) @ np.abs(turn)
    apart = np.abs(damping - np.diag(np.diag(damping)))
    return None if (apart > COUPLED * size).any() else (squares, np.diag(damping), back @ turn)


def _modal(system, Omega, squares, damping, shapes):
    """Σ (cᵀφ)(φᵀb)/(ω² − Ω² + iΩ·2ζω)."""
    s = 1j * Omega
    driven, seen = polynomial(system.b, s) @ shapes, polynomial(system.c, s) @ shapes
    stiffness = squares - (Omega * Omega)[:, None] + s[:, None] * damping
    return _summed(system, Omega, driven * seen, stiffness, np.abs(squares) + (Omega * Omega)[:, None])


def _complex_modes(K, C, back):
    """(λ, left and right shapes) of the first-order form; None where its vectors are nearly dependent."""
    n = len(K)
    pace = np.sqrt(max(np.abs(K).max(), np.finfo(float).tiny))
    A = np.block([[np.zeros((n, n)), pace * np.eye(n)], [-K / pace, -C]])
    values, right = np.linalg.eig(A)
    left = np.linalg.inv(right)
    if np.linalg.norm(left, 2) * np.linalg.norm(right, 2) > DEPENDENT:
        return None
    return values, back @ right[:n], left[:, n:] @ back.T / pace


def _by_complex_modes(system, Omega, values, right, left):
    """Σ (cᵀx)(yᵀb)/(iΩ − λ)."""
    s = 1j * Omega
    driven, seen = polynomial(system.b, s) @ left.T, polynomial(system.c, s) @ right
    return _summed(system, Omega, driven * seen, s[:, None] - values, np.abs(values) + np.abs(Omega)[:, None])


def _summed(system, Omega, residues, distances, size):
    """Σ residue/distance + d; by LU where a pole is as near as rounding."""
    lost = (np.abs(distances) <= 64 * SINGULAR * size).any(axis=1)
    distances[lost] = 1.0
    values = np.sum(residues / distances, axis=1) + polynomial(system.d, 1j * Omega)
    resonant = np.zeros(len(Omega), bool)
    if lost.any():
        values[lost], resonant[lost] = direct(system, Omega[lost])
    return values, resonant
