"""Free bodies: the pulley with its first load, and the second load, rope forces as unknowns.

Above the equilibrium the floor spring pulls k1 R phi and the rope spring k2(-r phi - y), positive in
tension. Pulley: the first load's rope force is m1 R phi'' + k1 R phi; second load: m2 y'' = rope spring.
Unit displacements and unit accelerations give the columns of K and M; frequencies from the roots of the
characteristic polynomial.
"""
import numpy as np


def answers(p):
    mp, i, R, r, m1, m2, k1, k2 = (p[n] for n in ("mp", "i", "R", "r", "m1", "m2", "k1", "k2"))

    def residual(q, a):
        spring = k2 * (-r * q[0] - q[1])
        rope1 = m1 * R * a[0] + k1 * R * q[0]
        return np.array([mp * i**2 * a[0] + rope1 * R - spring * r, m2 * a[1] - spring])

    none, units = np.zeros(2), np.eye(2)
    M = np.column_stack([residual(none, u) for u in units])
    K = np.column_stack([residual(u, none) for u in units])
    lam = np.roots([
        np.linalg.det(M),
        -(M[0, 0] * K[1, 1] + M[1, 1] * K[0, 0]),
        np.linalg.det(K),
    ])
    slow, fast = np.sqrt(np.sort(lam.real))

    def T(q, v):
        w, u = v["phi"], v["y"]
        return mp * (i * w) ** 2 / 2 + m1 * (R * w) ** 2 / 2 + m2 * u**2 / 2

    return {
        "M[1,1]": float(M[0, 0]), "M[1,2]": float(M[0, 1]), "M[2,2]": float(M[1, 1]),
        "K[1,1]": float(K[0, 0]), "K[1,2]": float(K[0, 1]), "K[2,2]": float(K[1, 1]),
        "omega[1]": float(slow), "omega[2]": float(fast), "T": T,
    }
