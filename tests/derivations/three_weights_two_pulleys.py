"""Free bodies: weights on light pulleys that turn freely, so one tension S in the lower rope and 2S in the upper one.

The upper rope sinks the moving axle as the large weight rises; the lower rope keeps the sum of the small weights'
rises at twice that of the axle. Newton for each weight, with x3 = -2 x1 - x2, leaves two residuals once S is taken
from the third weight; their response to unit displacements and accelerations gives K and M, the characteristic
polynomial the frequencies, and the amplitudes follow from one row.
"""
import numpy as np


def answers(p):
    m, k, g = p["m"], p["k"], p["g"]

    def residual(x, a):
        x3, a3 = -2 * x[0] - x[1], -2 * a[0] - a[1]
        tension = m * (a3 + g) + k * x3
        return np.array([4 * m * (a[0] + g) + k * x[0] - 2 * tension, m * (a[1] + g) + k * x[1] - tension])

    none, units = np.zeros(2), np.eye(2)
    load = residual(none, none)
    M = np.column_stack([residual(none, u) - load for u in units])
    K = np.column_stack([residual(u, none) - load for u in units])
    rest = np.linalg.solve(K, -load)
    slow, fast = np.sort(np.roots([
        np.linalg.det(M),
        -(M[0, 0] * K[1, 1] + M[1, 1] * K[0, 0] - 2 * M[0, 1] * K[0, 1]),
        np.linalg.det(K),
    ]).real)
    row, other = K[0] - slow * M[0], K[0] - fast * M[0]
    return {
        "M[x1,x1]": M[0, 0], "M[x1,x2]": M[0, 1], "M[x2,x2]": M[1, 1],
        "K[x1,x1]": K[0, 0], "K[x1,x2]": K[0, 1], "K[x2,x2]": K[1, 1],
        "equilibrium[x1]": rest[0], "equilibrium[x3]": -2 * rest[0] - rest[1],
        "omega[1]": slow**0.5, "omega[2]": fast**0.5,
        "mode[1, x2]": -row[0] / row[1], "mode[2, x1]": -other[1] / other[0],
    }
