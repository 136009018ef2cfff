"""Transfer of the state (u, u', EI u'', EI u''') by e^{Ax} along each half, the spring's force and the mass's inertia
added between; the estimate from strain and kinetic energy by quadrature.
"""
from math import sqrt

import numpy as np
from scipy.integrate import quad
from scipy.linalg import expm
from scipy.optimize import brentq


def answers(p):
    EI, mu, L, M, k = (p[x] for x in ("EI", "mu", "L", "M", "k"))

    def along(w, length):
        A = np.zeros((4, 4))
        A[0, 1], A[1, 2], A[2, 3], A[3, 0] = 1.0, 1 / EI, 1.0, mu * w**2
        return expm(A * length)

    def whole(w):
        jump, half = np.eye(4), along(w, L / 2)
        jump[3, 0] = -k
        return half @ jump @ half

    def missed(w):
        """The determinant of moment and shear at the tip."""
        T = whole(w)
        rows = np.array([T[2, 2:], T[3, 2:] + w**2 * M * T[0, 2:]])
        return np.linalg.det(rows)

    grid = np.linspace(10.0, 1300.0, 400)
    values = [missed(w) for w in grid]
    roots = [brentq(missed, grid[i], grid[i + 1], xtol=1e-11) for i in range(len(grid) - 1)
             if values[i] * values[i + 1] < 0]

    def shape(w, x):
        """The deflection there, from the clamped end."""
        T = whole(w)
        one = np.array([T[2, 3], -T[2, 2]])
        if x <= L / 2:
            return along(w, x)[0, 2:] @ one
        jump = np.eye(4)
        jump[3, 0] = -k
        return (along(w, x - L / 2) @ jump @ along(w, L / 2))[0, 2:] @ one

    strain = EI / 2 * quad(lambda x: (6 * L - 6 * x) ** 2, 0, L)[0] + k / 2 * ((L / 2) ** 2 * (3 * L - L / 2)) ** 2
    kinetic = mu / 2 * quad(lambda x: (x**2 * (3 * L - x)) ** 2, 0, L)[0] + M / 2 * (2 * L**3) ** 2
    return {
        **{f"omega[{i}]": root for i, root in enumerate(roots[:3], 1)},
        "rayleigh[x^2*(3*L-x)]": sqrt(strain / kinetic),
        "node[2][wing,1]": brentq(lambda x: shape(roots[1], x), 0.5 * L, L, xtol=1e-12),
    }
