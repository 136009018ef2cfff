"""Numeric eigenvalues of the hand-written tridiagonal matrix k[-1, 2, -1]/m.

No use is made of the known sine solution; the modes are scaled to 1 at the first mass.
"""
import numpy as np


def answers(p):
    A = 2 * np.eye(6) - np.eye(6, k=1) - np.eye(6, k=-1)
    lam, vec = np.linalg.eigh(p["k"] / p["m"] * A)
    out = {f"omega[{i}]": float(np.sqrt(value)) for i, value in enumerate(lam, 1)}
    out["mode[1][x2]"] = float(vec[1, 0] / vec[0, 0])
    out["mode[6][x6]"] = float(vec[5, 5] / vec[0, 5])
    return out
