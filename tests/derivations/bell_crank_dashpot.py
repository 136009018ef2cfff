"""Moments about the corner, by finite turns of the crank.

The places of both arms' centres and of the two fastenings are written for a turn of any size; the
potential energy (weights, spring with the preload that balances the horizontal arm) is differentiated
twice by central differences in 30 digits. The dashpot's rate comes from the same differences of its
length. Inertia: each arm's own m l^2/12 carried to the common mass centre by the parallel-axis theorem.
"""
from mpmath import cos, diff, hypot, mp, mpf, sin, sqrt


def answers(p):
    with mp.workdps(30):
        m1, m2, a, b, h, w, k, c, g = (mpf(p[n]) for n in ("m1", "m2", "a", "b", "h", "w", "k", "c", "g"))
        preload = -m1 * g / 2
        xc, yc = m1 * a / 2 / (m1 + m2), m2 * b / 2 / (m1 + m2)
        J = (m1 * a**2 + m2 * b**2) / 12
        J += m1 * ((a / 2 - xc) ** 2 + yc**2) + m2 * (xc**2 + (b / 2 - yc) ** 2)
        M = J + (m1 + m2) * (xc**2 + yc**2)

        def V(phi):
            weights = m1 * g * a / 2 * sin(phi) + m2 * g * b / 2 * cos(phi)
            d = hypot(a * cos(phi) - a, a * sin(phi) + h) - h
            return weights + k * d**2 / 2 + preload * d

        def dashpot(phi):
            return hypot(-b * sin(phi) + w, b * cos(phi) - b)

        assert abs(diff(V, 0)) < 1e-12
        K, C = diff(V, 0, 2), c * diff(dashpot, 0) ** 2
        wn, delta = sqrt(K / M), C / (2 * M)
        return {
            "J[crank]": float(J),
            "equation[phi]": lambda q, v, a: float(M) * a["phi"] + float(C) * v["phi"] + float(K) * q["phi"],
            "zeta[1]": float(delta / wn),
            "omega_d[1]": float(sqrt(wn**2 - delta**2)),
        }
