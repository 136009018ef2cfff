"""Newton for each particle: accelerations by vectors, moments without the link forces.

Accelerations of both particles are built from the unit vectors of the links. Moments about the fixed
hinge minus those of the lower particle about the upper one's place leave the virtual work of the upper
angle: u1 . (F1 + F2) and u2 . F2 with the inertia forces. Frequencies: eigenvalues of the flexibility
form K^-1 M, for which K is diagonal.
"""
from math import cos, sin, sqrt

import numpy as np


def particle_forces(p, q, v, a):
    L, m, g = p["L"], p["m"], p["g"]
    acc, out, tangents = np.zeros(2), [], []
    for name in ("phi1", "phi2"):
        tangent = np.array([cos(q[name]), sin(q[name])])
        normal = np.array([-sin(q[name]), cos(q[name])])
        acc = acc + L * (a[name] * tangent + v[name] ** 2 * normal)
        out.append(m * acc + np.array([0.0, m * g]))
        tangents.append(tangent)
    return out, tangents


def answers(p):
    L, m, g = p["L"], p["m"], p["g"]
    M = m * L * L * np.array([[2.0, 1.0], [1.0, 1.0]])
    flexibility = np.diag([1 / (2 * m * g * L), 1 / (m * g * L)])
    lam, vec = np.linalg.eig(flexibility @ M)
    order = np.argsort(-lam)
    ratio = [vec[1, j] / vec[0, j] for j in order]

    def upper(q, v, a):
        (f1, f2), (t1, _) = particle_forces(p, q, v, a)
        return float(t1 @ (f1 + f2))

    def lower(q, v, a):
        (_, f2), (_, t2) = particle_forces(p, q, v, a)
        return float(t2 @ f2)

    return {
        "omega[1]": 1 / sqrt(lam[order[0]]),
        "omega[2]": 1 / sqrt(lam[order[1]]),
        "mode[1][phi2]": ratio[0],
        "mode[2][phi2]": ratio[1],
        "motion[phi1]": upper,
        "motion[phi2]": lower,
    }
