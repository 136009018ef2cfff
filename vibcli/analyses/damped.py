"""Damped free vibration: (λ² M + λ (C + G) + K) x = 0."""

import math

from vibcli.analyses.modal import undamped


class DampedMode:
    """One damped mode, q = Re(shape e^{λt}): a conjugate pair (λ with Im > 0) or one real eigenvalue.

    omega = |λ|, zeta = −Re λ/|λ|, omega_d = Im λ or None, decay = −Re λ, growth_rate = Re λ where positive or None.
    The two real eigenvalues of one over-damped mode share `index`, omega = √(λ₁λ₂) and zeta = −(λ₁ + λ₂)/(2 omega).
    error: bound of the error of λ relative to |λ|.
    """

    __slots__ = ("decay", "eigenvalue", "error", "growth_rate", "index", "note", "omega", "omega_d", "shape", "zeta")

    def __init__(self, index, eigenvalue, shape, error, note=None):
        self.index, self.eigenvalue, self.shape, self.error, self.note = index, eigenvalue, shape, error, note
        self.omega = abs(eigenvalue)
        self.zeta = -eigenvalue.real / self.omega if eigenvalue.imag else None
        self.omega_d = eigenvalue.imag or None
        self.decay = -eigenvalue.real
        self.growth_rate = eigenvalue.real if eigenvalue.real > 0 else None


def damped(elements, precise=None, exact=None, digits=None):
    """The damped modes by ascending |λ|; None where nothing damps and nothing turns."""
    damps = any(c for c, _ in elements.dampers) or any(elements.C.values())
    if not damps and not any(elements.G.values()):
        return None
    import numpy as np

    modes = undamped(elements, precise)
    n, phi = elements.n, np.array([m.shape for m in modes]).T
    c = np.zeros((n, n))
    for weight, row in elements.dampers:
        for i, x in row.items():
            for j, y in row.items():
                c[i, j] += weight * x * y
    for matrix in (elements.C, elements.G):
        for (i, j), x in matrix.items():
            c[i, j] += x
    c = phi.T @ c @ phi
    w = np.array([m.omega if m.omega is not None else m.growth_rate for m in modes])
    sign = np.array([1.0 if m.omega is not None else -1.0 for m in modes])
    elastic = [i for i, m in enumerate(modes) if not m.rigid]
    k, size = len(elastic), len(modes)
    a = np.zeros((size + k, size + k))
    a[:size, :size] = -c
    for place, i in enumerate(elastic):
        a[size + place, i], a[i, size + place] = w[i], -sign[i] * w[i]
    values, vectors = np.linalg.eig(a)
    out = [DampedMode(1, 0.0, phi[:, i].astype(complex), 0.0) for i, m in enumerate(modes) if m.rigid]
    for value, y in zip(values, vectors.T, strict=True):
        if value.imag >= 0:
            value = complex(value)
            out.append(DampedMode(1, value, phi @ (y[:size] / value if value else y[:size]), 1e-12))
    out.sort(key=lambda m: abs(m.eigenvalue))
    for place, mode in enumerate(out, 1):
        mode.index = place
    return out


_ = math
