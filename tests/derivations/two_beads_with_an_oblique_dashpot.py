"""Along the line of each dashpot and square to it: the dashpot's force is c times the speed of approach in its line
alone. Both beads' components are integrated as x' = A x, the eigenvalues of A give damping and damped frequencies.
"""
import numpy as np
from scipy.linalg import expm


def answers(p):
    line = np.array([np.cos(p["b"]), np.sin(p["b"])])
    other = np.array([-0.5, np.sqrt(3) / 2])
    stiff = np.array([p["k"], p["k"] / 2])

    def rates(x):
        one, two, v, w = x[:2], x[2:4], x[4:6], x[6:]
        between = p["c1"] * ((w - v) @ line) * line
        ground = p["c2"] * (w @ other) * other
        return np.concatenate([v, w, (between - stiff * one) / p["m1"], (-between - ground - stiff * two) / p["m2"]])

    A = np.array([rates(column) for column in np.eye(8)]).T
    values = sorted((x for x in np.linalg.eigvals(A) if x.imag > 0), key=abs)
    at = expm(0.3 * A) @ np.array([0.01, 0, 0, 0, 0, 0, 0, 0.3])
    return {
        **{f"zeta[{i}]": -x.real / abs(x) for i, x in enumerate(values, 1)},
        **{f"omega_d[{i}]": x.imag for i, x in enumerate(values, 1)},
        "C[x1,y2]": -p["c1"] * line[0] * line[1],
        "damping[q].max": _largest(p["c1"] * np.outer(line, line) + p["c2"] * np.outer(other, other)),
        "x1(0.3 s)": at[0],
        "y2(0.3 s)": at[3],
    }


def _largest(C):
    """The largest c of cᵤ = uᵀ C u over all directions u, by looking round in them."""
    angles = np.linspace(0.0, np.pi, 200001)
    u = np.array([np.cos(angles), np.sin(angles)])
    return float(np.einsum("ia,ij,ja->a", u, C, u).max())
