"""Newton and Euler for the freed rod: the guides push with N_A (horizontal, at A) and N_B (vertical, at
B), the spring pulls A upwards. The two force equations give N_A and N_B, the moment about the mass
centre is the residual of the motion. Rest is found by bisection of that residual with no motion, the
frequency from its slope. T is the energy of the rod's elements added up along it.
"""


def answers(p):
    from math import cos, radians, sin, sqrt

    import numpy as np
    from scipy.optimize import brentq

    m, L, g = p["m"], p["L"], p["g"]

    def residual(angle, rate, acceleration):
        c, s = cos(angle), sin(angle)
        ax = L / 2 * (-s * acceleration - c * rate**2)
        ay = L / 2 * (c * acceleration - s * rate**2)
        spring = p["k"] * ((p["H"] - L * s) - (p["H"] - L))
        push_a, push_b = m * ax, m * ay + m * g - spring
        # The rod turns clockwise as theta grows: its angular acceleration is -theta''.
        moment = (-L / 2 * c) * spring - (L / 2 * s) * push_a + (L / 2 * c) * push_b
        return moment - m * L**2 / 12 * -acceleration

    rest = brentq(residual, radians(20), radians(85), args=(0.0, 0.0), xtol=1e-15)
    step = 1e-5
    slope = (residual(rest + step, 0, 0) - residual(rest - step, 0, 0)) / (2 * step)
    square = slope / (residual(rest, 0, 1) - residual(rest, 0, 0))

    def kinetic(q, v):
        nodes, weights = np.polynomial.legendre.leggauss(4)
        s = (nodes + 1) / 2
        vx = -(1 - s) * L * sin(q["theta"]) * v["theta"]
        vy = s * L * cos(q["theta"]) * v["theta"]
        return float(np.sum(weights / 2 * m / 2 * (vx**2 + vy**2)))

    return {
        "equilibrium[theta]": rest,
        "stable": square > 0,
        "T": kinetic,
        "motion[theta]": lambda q, v, a: residual(q["theta"], v["theta"], a["theta"]),
        "omega[1]": sqrt(square),
    }
