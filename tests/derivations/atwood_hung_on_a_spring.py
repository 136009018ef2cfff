"""Free bodies: the two weights and the pulley, the rope tensions S1 (left) and S2 (right) as unknowns.

The rope keeps each weight as far from the rim as it is: a point of the left rim rises by y − r·phi, one of the right
by y + r·phi. Newton and Euler give the residuals of the axle's force and of the pulley's moment; their response to
unit displacements and accelerations gives K and M, their zero the position of rest.
"""
import numpy as np


def answers(p):
    m0, m1, m2, J, r, k0, k1, g = (p[n] for n in ("m0", "m1", "m2", "J", "r", "k0", "k1", "g"))

    def residual(q, a):
        """Force on the axle and moment on the pulley that are missing for the accelerations a at q."""
        (y, phi), (ay, aphi) = q, a
        s1 = m1 * (ay - r * aphi) + m1 * g + k1 * (y - r * phi)
        s2 = m2 * (ay + r * aphi) + m2 * g
        return np.array([m0 * ay + m0 * g + k0 * y + s1 + s2, J * aphi - r * s1 + r * s2])

    none, units = np.zeros(2), np.eye(2)
    load = residual(none, none)
    K = np.column_stack([residual(u, none) - load for u in units])
    M = np.column_stack([residual(none, u) - load for u in units])
    y, phi = np.linalg.solve(K, -load)

    def motion(q, v, a):
        return residual((q["y"], q["phi"]), (a["y"], a["phi"]))[1]

    return {
        "M[y,y]": M[0, 0], "M[y,phi]": M[0, 1], "M[phi,phi]": M[1, 1],
        "K[y,y]": K[0, 0], "K[y,phi]": K[0, 1], "K[phi,phi]": K[1, 1],
        "equilibrium[y]": y, "equilibrium[phi]": phi, "equilibrium[x1]": y - r * phi,
        "motion[phi]": motion,
    }
