"""Newton along the wire: its slope is phi/2, the path from the lowest point 4 R sin(phi/2).

Wind and weight together are an inclined field of gravity. The bead rests where the wire lies across it, and swings
there as a pendulum whose length is the radius of curvature 4 R cos(phi/2).
"""
from math import atan2, cos, hypot, sin, sqrt


def answers(p):
    m, R, F, g = (p[n] for n in ("m", "R", "F", "g"))

    def along(q, v, a):
        slope = q["phi"] / 2
        path = 2 * R * cos(slope) * a["phi"] - R * sin(slope) * v["phi"] ** 2
        return 2 * cos(slope) * (m * path + m * g * sin(slope) - F * cos(slope))

    def kinetic(q, v):
        return m * (2 * R * cos(q["phi"] / 2) * v["phi"]) ** 2 / 2

    slope = atan2(F, m * g)
    square = hypot(g, F / m) / (4 * R * cos(slope))
    return {
        "T": kinetic,
        "motion[phi]": along,
        "equilibrium[phi]": 2 * slope,
        "K[phi,phi]": square * m * (2 * R * cos(slope)) ** 2,
        "omega[1]": sqrt(square),
        "still air: equilibrium[phi]": 0.0,
        "still air: omega[1]": sqrt(g / (4 * R)),
    }
