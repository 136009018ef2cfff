"""Newton-Euler about the hinge, the dashpot force resolved by vectors.

The plate's inertia about the hinge is the double integral of x^2 + y^2 over the plate. At unit angular
velocity the lug moves with the velocity of a rigid rotation; its component along the dashpot times c is
the force, and the cross product with the lug's place the moment. Damping ratio from the two real decay
rates: (s1 + s2)/(2 sqrt(s1 s2)).
"""
from math import cos, hypot, sqrt

import numpy as np


def answers(p):
    m, H, t, g = p["m"], p["H"], p["t"], p["g"]
    J = m / (H * t) * (t**3 / 12 * H + t * H**3 / 3)
    lug = np.array([0.0, -p["a"]])
    along = np.array([p["d"], -p["e"]]) / hypot(p["d"], p["e"])
    velocity = np.array([-lug[1], lug[0]])
    force = -p["c"] * (velocity @ along) * along
    C = -(lug[0] * force[1] - lug[1] * force[0])
    K = m * g * H / 2
    fast = (C + sqrt(C**2 - 4 * J * K)) / (2 * J)
    slow = K / J / fast
    return {
        "equation[phi]": lambda q, v, a: J * a["phi"] + C * v["phi"] + K * q["phi"],
        "zeta[1]": (fast + slow) / (2 * sqrt(fast * slow)),
        "eigenvalue[1,1]": -slow,
        "eigenvalue[1,2]": -fast,
        "V": lambda q: -m * g * H / 2 * cos(q["phi"]),
    }
