"""Flexibility about the two axles instead of stiffness about the mass centre.

The vertical displacements of the two fastenings are the coordinates: there the stiffness is diag(kf, kr),
and the inertia follows from y = (l2 u + l1 w)/(l1 + l2), phi = (w - u)/(l1 + l2). Eigenvalues of that
pair; the modes are turned back into y and phi. Stiffness entries for y and phi from the forces under unit
displacements.
"""
import numpy as np


def answers(p):
    m, i, l1, l2, kf, kr = (p[n] for n in ("m", "i", "l1", "l2", "kf", "kr"))
    span = l1 + l2
    back = np.array([[l2, l1], [-1.0, 1.0]]) / span
    M = back.T @ np.diag([m, m * i**2]) @ back
    lam, vec = np.linalg.eig(np.linalg.solve(np.diag([kf, kr]), M))
    order = np.argsort(-lam.real)
    out = {}
    for n, j in enumerate(order, 1):
        y, phi = back @ vec[:, j].real
        out[f"omega[{n}]"] = float(1 / np.sqrt(lam[j].real))
        out[f"mode[{n}][phi]"] = float(phi / y)
    front, rear = kf * -l1, kr * l2
    out["K[y,phi]"] = front + rear
    out["K[phi,phi]"] = front * -l1 + rear * l2
    out["equilibrium[y]"] = 0.0
    return out
