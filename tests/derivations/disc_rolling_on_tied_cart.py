"""Free bodies with the friction force F between disc and deck as a third unknown.

Disc: m(x'' + s'') = F - k2 s and m s''/2 = -F; cart: mc x'' = -F + k2 s - k1 x. Solving these for the
accelerations under unit displacements gives the dynamic matrix, whose eigenvalues are omega^2. The forces
needed for unit accelerations along x (on the whole) and along s (on the disc) give M, those for unit
displacements K.
"""
import numpy as np


def answers(p):
    mc, m, k1, k2 = p["mc"], p["m"], p["k1"], p["k2"]
    balance = np.array([[mc, 0, 1], [m, m, -1], [0, m / 2, 1]])
    loads = np.array([[k1, -k2], [0.0, k2], [0.0, 0.0]])
    dynamic = np.linalg.solve(balance, loads)[:2]
    slow, fast = np.sqrt(np.sort(np.linalg.eigvals(dynamic).real))
    # work on x: cart and disc together (F drops out); work on s: disc and its turning
    work = np.array([[1, 1, 0], [0, 1, 1]])
    M, K = (work @ balance)[:, :2], work @ loads
    return {
        "M[x,x]": float(M[0, 0]), "M[x,s]": float(M[0, 1]), "M[s,s]": float(M[1, 1]),
        "K[x,x]": float(K[0, 0]), "K[x,s]": float(K[0, 1]), "K[s,s]": float(K[1, 1]),
        "omega[1]": float(slow), "omega[2]": float(fast),
    }
