"""Virtual work of inertia forces of every part at its own level acceleration, weights and dampers: complex amplitudes
of the two angles by Cramer's rule. Frequencies and damping from the roots of the characteristic polynomial.
"""
from cmath import phase

import numpy as np


def answers(p):
    M1, m1, L1, M2, m2, L2, ct, X, g = (p[n] for n in ("M1", "m1", "L1", "M2", "m2", "L2", "ct", "X", "g"))
    parts = [(2 * m1, L1 / 2, 0), (M1, L1, 0), (2 * m2, L1, L2 / 2), (M2, L1, L2)]    # mass, arms of alpha and beta
    M = sum(m * np.outer([a, b], [a, b]) for m, a, b in parts)
    M = M + np.diag([2 * m1 * L1**2 / 12, 2 * m2 * L2**2 / 12])
    K = np.diag([sum(m * g * a for m, a, _ in parts), sum(m * g * b for m, _, b in parts)])
    C = np.diag([ct, ct])
    moved = sum(m * np.array([a, b]) for m, a, b in parts)

    def steady(W):
        alpha, beta = np.linalg.solve(K - W**2 * M + 1j * W * C, moved * X * W**2)
        return alpha, beta, X + L1 * alpha, X + L1 * alpha + L2 * beta

    def determinant(s):
        entry = M * s * s + C * s + K
        return entry[0, 0] * entry[1, 1] - entry[0, 1] ** 2

    circle = np.exp(2j * np.pi * np.arange(5) / 5)
    roots = np.roots(np.polyfit(circle, [determinant(s) for s in circle], 4).real)
    roots = sorted(roots[roots.imag > 0], key=abs)
    b2, b1, b0 = np.linalg.det(M), -(M[0, 0] * K[1, 1] + M[1, 1] * K[0, 0]), K[0, 0] * K[1, 1]
    squares = np.sort(np.roots([b2, b1, b0]))
    alpha, beta, upper, lower = steady(p["Omega"])
    faster = steady(4.5)[3]
    return {
        "M[alpha,alpha]": M[0, 0],
        "M[alpha,beta]": M[0, 1],
        "M[beta,beta]": M[1, 1],
        "K[alpha,alpha]": K[0, 0],
        "K[beta,beta]": K[1, 1],
        "omega[1]": squares[0] ** 0.5,
        "omega[2]": squares[1] ** 0.5,
        "zeta[1]": -roots[0].real / abs(roots[0]),
        "zeta[2]": -roots[1].real / abs(roots[1]),
        "amplitude(alpha)": abs(alpha),
        "amplitude(beta)": abs(beta),
        "phase(alpha)": -phase(alpha),
        "phase(beta)": -phase(beta),
        "amplitude(upper.x)": abs(upper),
        "amplitude(lower.x)": abs(lower),
        "phase(lower.x)": -phase(lower),
        "faster:amplitude(lower.x)": abs(faster),
        "faster:phase(lower.x)": -phase(faster),
    }
