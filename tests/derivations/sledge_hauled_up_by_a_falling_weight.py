"""Newton's law along and across the slope and for the weight, Euler's law for the drum: a linear system for the one
acceleration and both tensions; the acceleration is constant."""
from math import cos, sin

import numpy as np


def answers(p):
    m, M, J, r, g, t = (p[n] for n in ("m", "M", "J", "r", "g", "t1"))
    c, s = cos(p["alpha"]), sin(p["alpha"])
    normal = m * g * c
    rows = [[m, -1, 0], [M, 0, 1], [J / r, r, -r]]       # s'', tension at the sledge, tension at the weight
    a, S1, S2 = np.linalg.solve(rows, [-m * g * s - p["mu"] * normal, M * g, 0])
    assert a > 0
    return {"s''(0 s)": a, "phi''(0 s)": -a / r, "rope.force.1(0 s)": S1, "rope.force.2(0 s)": S2,
            "sledge.reaction.x(0 s)": -normal * s, "sledge.reaction.y(0 s)": normal * c, "s(t1)": a * t**2 / 2,
            "s'(t1)": a * t}
