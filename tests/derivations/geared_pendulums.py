"""Each of the three shafts is freed, with the force F between the teeth and the pull B of the belt as unknowns.

Equal arcs roll off at the pitch point and along the belt. The moments of the weights follow from the lever arms of
the centres; three moment equations are solved for phi'', F and B. Energies are the work of the weights, by
quadrature, and the work that brings the shafts to speed.
"""
import numpy as np


def answers(p):
    m1, m2, L, a, r1, r2, R2, R3, g = (p[n] for n in ("m1", "m2", "L", "a", "r1", "r2", "R2", "R3", "g"))
    inertias = p["J1"] + m1 * L**2 / 3, p["J2"] + m2 * a**2, p["J3"]
    back, on = -r1 / r2, -R2 / R3                   # turns of the second shaft per first, of the third per second

    def weights(phi):
        return -m1 * g * L / 2 * np.sin(phi), -m2 * g * a * np.sin(back * phi)

    def acceleration(phi):
        first, second = weights(phi)
        rows = [[inertias[0], -r1, 0], [inertias[1] * back, -r2, -R2], [inertias[2] * back * on, 0, -R3]]
        return np.linalg.solve(rows, [first, second, 0.0])[0]

    def kinetic(q, v):
        speeds = v["phi"], back * v["phi"], on * back * v["phi"]
        return sum(J * w**2 for J, w in zip(inertias, speeds, strict=True)) / 2

    def potential(q):
        nodes, parts = np.polynomial.legendre.leggauss(20)
        turned = (nodes + 1) / 2 * q["phi"]
        first, second = weights(turned)
        return -float(np.sum(parts / 2 * (first + back * second)) * q["phi"])

    step = 1e-5
    square = -(acceleration(step) - acceleration(-step)) / (2 * step)
    return {
        "T": kinetic,
        "V": potential,
        "motion[phi]": lambda q, v, a: a["phi"] - acceleration(q["phi"]),
        "omega[1]": square**0.5,
    }
