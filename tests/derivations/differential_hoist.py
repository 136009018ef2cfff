"""The rope's two free pieces shorten by R phi and lengthen by r phi: half their sum lifts the pulley, their
difference turns it. Moments about the drum's axle with both tensions, Newton for pulley and load, Euler for the
pulley are solved for phi'' at two turns of the drum; rest, frequency, and the energy from the inertia against a unit
moment.
"""
import numpy as np


def answers(p):
    R, r, J, m, mp, kt, g = (p[n] for n in ("R", "r", "J", "m", "mp", "kt", "g"))
    rho, lift, roll = (R + r) / 2, (R - r) / 2, 1.0     # per unit turn of the drum
    needed = kt * p["phi1"] + lift * (m + mp) * g

    def acceleration(phi, moment, gravity):
        rows = [[J, R, -r], [(m + mp) * lift, -1, -1], [mp * rho**2 / 2 * roll, -rho, rho]]   # phi'', right, left
        return np.linalg.solve(rows, [moment - kt * phi, -(m + mp) * gravity, 0])[0]

    inertia = 1 / acceleration(0, 1, 0)
    at_drawn = acceleration(0, needed, g)
    square = at_drawn - acceleration(1, needed, g)
    return {
        "equilibrium[phi]": at_drawn / square,
        "equilibrium[y]": lift * at_drawn / square,
        "T": lambda q, v: inertia * v["phi"] ** 2 / 2,
        "omega[1]": square**0.5,
    }
