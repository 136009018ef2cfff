"""Euler for each gear and Newton for the rack, with the tooth forces F (between the gears) and G (gear
to rack) as unknowns and the accelerations tied by equal velocities at the pitch points. The linear
system is solved under a unit moment on the first gear and under a unit turn; T adds the energies of the
bodies with their own speeds.
"""


def answers(p):
    from math import sqrt

    import numpy as np

    J1, J2, r1, r2, m = (p[name] for name in ("J1", "J2", "r1", "r2", "m"))

    def acceleration(phi, moment):
        rim = r1 * phi
        # Unknowns phi'', F, G; the second gear's turn is counted in its own sense, the rack follows its rim.
        rows = [[J1, r1, 0], [J2 * r1 / r2, -r2, r2], [m * r1, 0, -1]]
        right = [moment - p["kt1"] * phi, -p["kt2"] * rim / r2, -p["k"] * rim]
        return np.linalg.solve(rows, right)[0]

    def kinetic(q, v):
        rim = r1 * v["phi"]
        return J1 * v["phi"] ** 2 / 2 + J2 * (rim / r2) ** 2 / 2 + m * rim**2 / 2

    inertia = 1 / acceleration(0, 1)
    square = -acceleration(1, 0)
    return {"M[phi,phi]": inertia, "K[phi,phi]": inertia * square, "T": kinetic, "omega[1]": sqrt(square)}
