"""Newton's law for each weight and for the second pulley, Euler's law for both discs, and the ropes' kinematics: one
linear system for four accelerations and four tensions, solved as it stands."""
import numpy as np


def answers(p):
    m1, m2, m3, mp, r, g = (p[n] for n in ("m1", "m2", "m3", "mp", "r", "g"))
    J = mp * r * r / 2
    # a1 (rise of m1), a2, a3, alpha (second pulley), S1 (over m1), S2 (over the axle), S3 (over m2), S4 (over m3);
    # the axle falls as m1 rises: u'' = −a1, and the first pulley turns by −a1/r
    rows = [[m1, 0, 0, 0, -1, 0, 0, 0], [0, m2, 0, 0, 0, 0, -1, 0], [0, 0, m3, 0, 0, 0, 0, -1],
            [-mp, 0, 0, 0, 0, -1, 1, 1], [J / r, 0, 0, 0, r, -r, 0, 0], [0, 0, 0, J, 0, 0, -r, r],
            [1, 1, 0, r, 0, 0, 0, 0], [1, 0, 1, -r, 0, 0, 0, 0]]
    right = [-m1 * g, -m2 * g, -m3 * g, -mp * g, 0, 0, 0, 0]
    a1, a2, _, _, S1, _, S3, S4 = np.linalg.solve(rows, right)
    return {"y1''(0 s)": a1, "y2''(0 s)": a2, "long.force.1(0 s)": S1, "short.force.1(0 s)": S3,
            "short.force.2(0 s)": S4}
