"""Free bodies with the tensions S0 (ceiling to moving pulley), S1 (between the pulleys), S2 (to the counterweight).

The moving pulley rolls up the standing part of the rope: its other side rises twice as fast as its axle. Newton for
the load with its pulley and for the counterweight, Euler for both discs are a linear system for y'' and the tensions,
solved at two places for rest and period; a unit force at the load gives the inertia.
"""
from math import pi, sqrt

import numpy as np


def answers(p):
    m1, m2, m3, m4, r1, r2, k, g = (p[n] for n in ("m1", "m2", "m3", "m4", "r1", "r2", "k", "g"))

    def acceleration(y, push, gravity):
        """y'' at the rise y under an upward force on the load."""
        z = -2 * y
        load = [m1 + m4, -1, -1, 0]                      # (m1 + m4) y'' = S0 + S1 - weight + push
        block = [m1 * r1**2 / 2 / r1, r1, -r1, 0]        # J y''/r1 = (S1 - S0) r1
        sheave = [m2 * r2**2 / 2 * 2 / r2, 0, r2, -r2]   # J 2y''/r2 = (S2 - S1) r2
        counterweight = [-2 * m3, 0, 0, -1]              # m3 z'' = S2 - weight - k z
        right = [push - (m1 + m4) * gravity, 0, 0, -m3 * gravity - k * z]
        return np.linalg.solve([load, block, sheave, counterweight], right)[0]

    at_drawn = acceleration(0, 0, g)
    square = at_drawn - acceleration(1, 0, g)
    inertia = 1 / acceleration(0, 1, 0)
    return {
        "equilibrium[y]": at_drawn / square,
        "equilibrium[z]": -2 * at_drawn / square,
        "M[y,y]": inertia,
        "K[y,y]": square * inertia,
        "period[1]": 2 * pi / sqrt(square),
    }
