"""Newton along the plane and Euler about the wheel's centre, with the friction F and the cord's force S
= k·(length paid out) unknown until the motion is known; F is eliminated by solving the two equations.
The cord is paid out at the velocity of the hub's far side, found from the instantaneous centre at the
contact.
"""


def answers(p):
    from math import pi, sin, sqrt

    import numpy as np

    m, R, r = p["m"], p["R"], p["r"]

    def acceleration(x, weight):
        paid_out = x / R * (R + r)
        cord = p["k"] * paid_out
        # Unknowns x'' and F, up the slope: m x'' = weight - S - F; J x''/R = F R - S r.
        rows = [[m, 1], [m * p["i"] ** 2 / R, -R]]
        return np.linalg.solve(rows, [weight - cord, -cord * r])[0]

    start = acceleration(0, m * p["g"] * sin(p["beta"]))
    square = start - acceleration(1, m * p["g"] * sin(p["beta"]))
    return {
        "equilibrium[x]": start / square,
        "equation[x]": lambda q, v, a: a["x"] - acceleration(q["x"], 0.0),
        "period[1]": 2 * pi / sqrt(square),
    }
