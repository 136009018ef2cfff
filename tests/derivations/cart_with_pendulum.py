"""Newton: whole system along the track, moments of the bob about the moving hinge.

The bob's acceleration is that of the hinge plus the tangential and normal parts. Free cart: the common
centre does not move, so the bob swings about a point that divides the link, at the distance L m1/(m1 +
m2) from it; a simple pendulum of that length. Tied cart: eigenvalues of the hand-written pair M, K for
(x, L phi), scaled.
"""
from math import cos, sin, sqrt

import numpy as np


def answers(p):
    m1, m2, L, g = (p[n] for n in ("m1", "m2", "L", "g"))
    k = 240.0  # of the tied case

    def bob(q, v, a):
        f = q["phi"]
        ax = a["x"] + L * (a["phi"] * cos(f) - v["phi"] ** 2 * sin(f))
        ay = L * (a["phi"] * sin(f) + v["phi"] ** 2 * cos(f))
        return ax, ay

    def along(q, v, a):
        return m1 * a["x"] + m2 * bob(q, v, a)[0]

    def moment(q, v, a):
        ax, ay = bob(q, v, a)
        return m2 * L * (cos(q["phi"]) * ax + sin(q["phi"]) * (ay + g))

    tied = np.linalg.eigvals(np.linalg.solve([[m1 + m2, m2], [1.0, 1.0]], np.diag([k, g / L])))
    slow, fast = np.sqrt(np.sort(tied.real))
    node = L * m1 / (m1 + m2)
    return {
        "motion[x]": along,
        "motion[phi]": moment,
        "omega[1]": 0.0,
        "omega[2]": sqrt(g / node),
        "mode[1][phi]": 0.0,
        "mode[2][phi]": -1 / (L - node),
        "tied: omega[1]": float(slow),
        "tied: omega[2]": float(fast),
    }
