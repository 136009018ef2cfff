"""H(iΩ) at many frequencies, each to the rounding that the condition of K − Ω²M + iΩC allows.

Few degrees of freedom, or few frequencies: LU of every matrix, rows and columns scaled by powers of two; else one of the
methods of many.py. A frequency at which the matrix is singular but for rounding is a pole, unless the input does not
excite that mode or the output does not see it: then that mode is left out.
"""

import numpy as np

from vibcli.analyses.frequency.transfer import polynomial
from vibcli.errors import PhysicsError

SINGULAR = 2.0**-46     # 1/condition of the scaled matrix below which a frequency counts as one of a pole
UNSEEN = 1e-9           # residue, relative to |c| |b|, below which a mode takes no part
WORK, BLOCK = 3e8, 2.0**22


def frf(system, Omega):
    """H(iΩ) of a Transfer, complex; PhysicsError where a frequency is that of a pole."""
    values, resonant = sampled(system, Omega)
    if resonant.any():
        Omega = float(np.ravel(Omega)[np.ravel(resonant)][0])
        raise PhysicsError(f"the input drives an undamped mode at its natural frequency, {Omega:.6g} rad/s: its "
                           "amplitude grows without bound", "add damping, or ask at another frequency")
    return values


def sampled(system, Omega):
    """(H, whether there is a pole) at each frequency; H is 0 at poles."""
    shape = np.shape(Omega)
    Omega = np.atleast_1d(np.asarray(Omega, dtype=float)).ravel()
    values, resonant = _method(system, len(Omega))(system, Omega)
    values = values * (1j * Omega) ** system.order if system.order else values
    values = np.where(resonant, 0.0, values)
    return values.reshape(shape), resonant.reshape(shape)


def phase_lag(values):
    """θ = −arg H in (−π, π], so that cos Ωt gives |H| cos(Ωt − θ)."""
    angle = -np.angle(values)
    return np.where(angle <= -np.pi, np.pi, angle) + 0.0


def _method(system, count):
    if count * system.n**3 <= WORK:
        return direct
    from vibcli.analyses.frequency.many import chosen

    return chosen(system) or direct


def dynamic_stiffness(system, Omega):
    """K − Ω²M + iΩC of each frequency, (N, n, n)."""
    Omega = Omega[:, None, None]
    return (system.K - Omega * Omega * system.M) + 1j * (Omega * system.C)


def direct(system, Omega):
    """By LU in blocks of frequencies."""
    size = max(1, int(BLOCK / max(system.n, 1) ** 2))
    parts = [_block(system, Omega[k:k + size]) for k in range(0, len(Omega), size)]
    return np.concatenate([values for values, _ in parts]), np.concatenate([resonant for _, resonant in parts])


def scales(system, Omega):
    """Powers of two that bring rows and columns to the size 1: (N, n)."""
    Omega = Omega[:, None]
    parts = [np.abs(matrix) for matrix in (system.K, system.C, system.M)]
    size = sum(Omega**k * np.diag(part) for k, part in enumerate(parts))
    across = sum(Omega**k * part.max(axis=1) for k, part in enumerate(parts))
    size = np.where(size > 0, size, np.where(across > 0, across, 1.0))
    return np.exp2(-np.round(np.log2(size) / 2))


def _block(system, Omega):
    s, scale = 1j * Omega, scales(system, Omega)
    D = dynamic_stiffness(system, Omega) * scale[:, :, None] * scale[:, None, :]
    b, c = polynomial(system.b, s) * scale, polynomial(system.c, s) * scale
    right = np.stack([b, np.broadcast_to(probe(system.n), b.shape)], axis=2)
    try:
        x = np.linalg.solve(D, right)
        suspicious = ~np.isfinite(x).all(axis=(1, 2)) | (np.abs(x[:, :, 1]).max(axis=1) * SINGULAR * 64 > 1)
    except np.linalg.LinAlgError:
        x, suspicious = np.zeros_like(right), np.ones(len(Omega), bool)
    values = np.einsum("ki,ki->k", c, x[:, :, 0])
    resonant = np.zeros(len(Omega), bool)
    for k in np.flatnonzero(suspicious):
        values[k], resonant[k] = _singular(D[k], b[k], c[k])
    return values + polynomial(system.d, s), resonant


def probe(n):
    """A vector with a part along every mode."""
    return 1.0 + 0.5 * np.sin(np.arange(1, n + 1) * 2.399963)


def _singular(D, b, c):
    """(cᵀD⁻¹b, False), or (0, True) where D is singular along a mode that b drives and c sees."""
    u, size, v = np.linalg.svd(D)
    driven, seen = u.conj().T @ b, c @ v.conj().T
    small = size <= SINGULAR * size[0]
    if (np.abs(driven * seen)[small] > UNSEEN * np.linalg.norm(b) * np.linalg.norm(c)).any():
        return 0.0, True
    return np.sum((driven * seen)[~small] / size[~small]), False
