"""H(iΩ) of many degrees of freedom at many frequencies: banded LU, real modes where damping does not couple them, else
complex modes. Each method gives (H, dH/ds or None, whether there is a pole) at each s."""

from collections.abc import Callable
from typing import Any

import numpy as np

from vibcli.analyses.frequency_response.direct import SINGULAR, along, direct, probe, scales
from vibcli.analyses.frequency_response.quadratics import polynomial, slope
from vibcli.base.work import counted
from vibcli.numerics.fixed_point import MILLION
from vibcli.numerics.state_space import first_order

NARROW, COUPLED = 16, 1e-14     # widest band on either side; coupling relative to the damping of two modes
DEPENDENT = 1e5                 # condition of complex modes from which on they lose too many digits


def chosen(system: Any) -> Callable:
    """The method for this system; None where none of them fits."""
    order, width = _ordered(system)
    if width <= NARROW:
        bands = _bands(system, order, width)
        return lambda system, s, steep=False: _banded(system, s, steep, order, width, bands)
    reduced = _reduced(system)
    if reduced is None:
        return None
    modes = _modes(system, *reduced)
    if modes is not None:
        return lambda system, s, steep=False: _by_modes(system, s, steep, *modes)
    modes = _complex_modes(*reduced)
    return None if modes is None else lambda system, s, steep=False: _by_complex_modes(system, s, steep, *modes)


def _ordered(system):
    """(order of the coordinates, half the width of the band)."""
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import reverse_cuthill_mckee

    pattern = (system.K != 0) | (system.M != 0) | (system.C != 0)
    pattern |= pattern.T
    order = reverse_cuthill_mckee(csr_array(pattern), symmetric_mode=True)
    rows, columns = np.nonzero(pattern[np.ix_(order, order)])
    return order, int(np.abs(rows - columns).max(initial=0))


def _bands(system, order, width):
    """K, C, M as LAPACK stores bands, with room for what pivoting adds."""
    at, bands = np.arange(system.n), np.zeros((3, 3 * width + 1, system.n))
    rows, columns = np.nonzero(np.abs(at[:, None] - at) <= width)
    for k, matrix in enumerate((system.K, system.C, system.M)):
        bands[k, 2 * width + rows - columns, columns] = matrix[np.ix_(order, order)][rows, columns]
    return bands


def _banded(system, s, steep, order, width, bands):
    from scipy.linalg import lapack

    n, at = system.n, np.arange(system.n)
    scale = scales(system, s)[:, order]
    b, c = polynomial(system.b, s)[:, order] * scale, polynomial(system.c, s)[:, order] * scale
    rows = np.clip(np.arange(3 * width + 1)[:, None] - 2 * width + at, 0, n - 1)
    x, y, lost = np.zeros(b.shape, complex), np.zeros(b.shape, complex), []
    right = np.empty((n, 2), complex)
    right[:, 1] = probe(n)
    for k, point in enumerate(s.tolist()):
        counted(n * (width + 1)**2 / MILLION)
        band = (bands[0] + point * bands[1] + point * point * bands[2]) * scale[k] * scale[k][rows]
        right[:, 0] = b[k]
        factors, pivots, info = lapack.zgbtrf(band, width, width)
        found, _ = lapack.zgbtrs(factors, width, width, right, pivots)
        if info or not np.abs(found[:, 1]).max() * SINGULAR * 64 < 1:
            lost.append(k)
            continue
        x[k] = found[:, 0]
        if steep:
            y[k] = lapack.zgbtrs(factors, width, width, c[k], pivots, trans=1)[0]
    values, slopes, back = np.einsum("ki,ki->k", c, x) + polynomial(system.d, s), None, np.argsort(order)
    if steep:
        slopes = along(system, s, (x * scale)[:, back], (y * scale)[:, back])
    return _repaired(system, s, values, slopes, lost)


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
    """(ω², 2ζω, shapes) of real modes where damping does not couple them, else None."""
    if not (_symmetric(system.K) and _symmetric(system.C)):
        return None
    squares, turn = np.linalg.eigh((K + K.T) / 2)
    damping = turn.T @ C @ turn
    size = np.abs(turn).T @ np.abs(C) @ np.abs(turn)
    apart = np.abs(damping - np.diag(np.diag(damping)))
    return None if (apart > COUPLED * size).any() else (squares, np.diag(damping), back @ turn)


def _by_modes(system, s, steep, squares, damping, shapes):
    """Σ (cᵀφ)(φᵀb)/(s² + 2ζω s + ω²)."""
    at = s[:, None]
    stiffness = squares + at * damping + at * at
    size = np.abs(squares) + np.abs(at) ** 2
    return _summed(system, s, steep, (shapes, shapes), (stiffness, 2 * at + damping), size)


def _complex_modes(K, C, back):
    """(λ, right and left shapes) of the first-order form; None where its vectors are nearly dependent."""
    n = len(K)
    pace = np.sqrt(max(np.abs(K).max(), np.finfo(float).tiny))
    values, right = np.linalg.eig(first_order(K, C, pace))
    left = np.linalg.inv(right)
    if np.linalg.norm(left, 2) * np.linalg.norm(right, 2) > DEPENDENT:
        return None
    return values, back @ right[:n], (left[:, n:] @ back.T).T / pace


def _by_complex_modes(system, s, steep, values, right, left):
    """Σ (cᵀx)(yᵀb)/(s − λ)."""
    at = s[:, None]
    return _summed(system, s, steep, (left, right), (at - values, np.ones((1, 1))), np.abs(values) + np.abs(at))


def _summed(system, s, steep, shapes, distance, size):
    """Σ (cᵀx)(yᵀb)/distance + d; by LU where a pole is as near as rounding. `distance`: with its slope."""
    far, steeper = distance
    lost = np.flatnonzero((np.abs(far) <= 64 * SINGULAR * size).any(axis=1))
    far[lost] = 1.0
    (left, right), slopes = shapes, None
    driven, seen = polynomial(system.b, s) @ left, polynomial(system.c, s) @ right
    values = np.sum(driven * seen / far, axis=1) + polynomial(system.d, s)
    if steep:
        moved = slope(system.b, s) @ left * seen + driven * (slope(system.c, s) @ right)
        slopes = np.sum((moved - driven * seen * steeper / far) / far, axis=1) + slope(system.d, s)
    return _repaired(system, s, values, slopes, lost)


def _repaired(system, s, values, slopes, lost):
    resonant = np.zeros(len(s), bool)
    if len(lost):
        values[lost], steep, resonant[lost] = direct(system, s[lost], slopes is not None)
        if slopes is not None:
            slopes[lost] = steep
    return values, slopes, resonant
