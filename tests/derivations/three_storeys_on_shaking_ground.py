"""Modal coordinates of the displacements z relative to the ground, M z'' + C z' + K z = -M 1 u'', each equation by its
own: eta'' + 2 zeta w eta' + w^2 eta = -phi M 1 u''; C from its definition.
"""
from math import tau

import numpy as np


def answers(p):
    m = np.array([p["m1"], p["m2"], p["m3"]])
    k1, k2, k3, A, W = (p[x] for x in ("k1", "k2", "k3", "A", "Omega"))
    K = np.array([[k1 + k2, -k2, 0], [-k2, k2 + k3, -k3], [0, -k3, k3]])
    root = np.sqrt(m)
    squares, vectors = np.linalg.eigh(K / np.outer(root, root))
    w, phi = np.sqrt(squares), vectors / root[:, None]
    zeta = np.array([p["z1"], p["z2"], p["z2"]])
    share = phi.T @ m               # phi M 1
    rows = m[:, None] * phi
    C = rows @ np.diag(2 * zeta * w) @ rows.T

    def relative(W):
        """z over the ground's complex amplitude."""
        return phi @ (share * W**2 / (w**2 - W**2 + 2j * zeta * w * W))

    z = relative(W)
    return {
        "omega[1]": w[0],
        "zeta[1]": zeta[0],
        "zeta[2]": zeta[1],
        "zeta[3]": zeta[2],
        "C[x1,x2]": C[0, 1],
        "amplitude(c1.stretch)": A * abs(z[0]),
        "amplitude(x3 - soil.x)": A * abs(z[2]),
        "amplitude(c1.force)": k1 * A * abs(z[0]),
        "abs(frf[x3, soil](f))": abs(1 + relative(tau * p["f"])[2]),
        "x3(t1)": A * np.sin(W * p["t1"]) + phi[2] @ from_rest(w, zeta, share * A * W**2, W, p["t1"], A * W, share),
    }


def from_rest(w, zeta, force, W, t, speed, share):
    """eta(t) of eta'' + 2 zeta w eta' + w^2 eta = force sin(W t); the floors rest, so that z' starts as -u'."""
    steady = force / (w**2 - W**2 + 2j * zeta * w * W)      # of e^{iWt}, whose imaginary part is meant
    start, rate = -steady.imag, -share * speed - (1j * W * steady).imag
    wd = w * np.sqrt(1 - zeta**2)
    free = np.exp(-zeta * w * t) * (start * np.cos(wd * t) + (rate + zeta * w * start) / wd * np.sin(wd * t))
    return free + (steady * np.exp(1j * W * t)).imag
