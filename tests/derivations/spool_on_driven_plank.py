"""Newton and Euler for the spool, with the friction at the plank between them.

The axle moves with plank and path together; the spool turns by -s/R, since the plank only slides. Friction f turns it
with the arm R and pushes it along.
"""
from math import pi, sin, sqrt


def answers(p):
    m, R, i, k, c, Y, Omega = (p[n] for n in ("m", "R", "i", "k", "c", "Y", "Omega"))
    inertia = m * i**2

    def newton(q, v, a):
        plank, push = Y * sin(Omega * q["t"]), -Y * Omega**2 * sin(Omega * q["t"])
        friction = inertia * (-a["s"] / R) / R
        return m * (a["s"] + push) + k * (q["s"] + plank) + c * v["s"] - friction

    def kinetic(q, v):
        axle = v["s"] + Y * Omega * sin(Omega * q["t"] + pi / 2)
        return m * axle**2 / 2 + inertia * (v["s"] / R) ** 2 / 2

    still = {"s": 0.0, "t": 0.0}
    effective = newton(still, still, {"s": 1.0}) - newton(still, still, {"s": 0.0})
    own = sqrt(k / effective)
    return {
        "T": kinetic,
        "motion[s]": newton,
        "equation[s]": newton,
        "J[spool]": inertia,
        "omega[1]": own,
        "zeta[1]": c / (2 * effective) / own,
    }
