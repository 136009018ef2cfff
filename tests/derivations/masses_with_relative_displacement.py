"""Newton's law of both cars in absolute displacements, from numbers; then u = x2 - x.

The second car feels the coupling alone, the first one buffer and coupling: m x2'' = -k (x2 - x) and
2 m x'' = -k x + k (x2 - x). The frequencies are those of the general eigenvalue problem in (x, x2).
"""
import numpy as np
from scipy.linalg import eigh


def answers(p):
    m, k = p["m"], p["k"]
    M, K = np.diag([2 * m, m]), np.array([[2 * k, -k], [-k, k]])
    squares, modes = eigh(K, M)
    seen = np.array([[1.0, 0.0], [1.0, 1.0]])       # (x, x2) of (x, u)

    def T(q, v):
        return (2 * m * v["x"] ** 2 + m * (v["x"] + v["u"]) ** 2) / 2

    def V(q):
        return (k * q["x"] ** 2 + k * (q["x"] + q["u"] - q["x"]) ** 2) / 2

    relative = [modes[1, i] / modes[0, i] - 1 for i in range(2)]
    inertia, stiffness = seen.T @ M @ seen, seen.T @ K @ seen
    return {
        "T": T,
        "V": V,
        "equation[u]": lambda q, v, a: m * (a["x"] + a["u"]) + k * q["u"],
        "M[x,x]": inertia[0, 0], "M[x,u]": inertia[0, 1], "M[u,u]": inertia[1, 1],
        "K[x,u]": 0.0 if abs(stiffness[0, 1]) < 1e-12 * k else stiffness[0, 1], "K[u,u]": stiffness[1, 1],
        "omega[1]": squares[0] ** 0.5, "omega[2]": squares[1] ** 0.5,
        "mode[1][u]": relative[0], "mode[2][u]": relative[1],
    }
