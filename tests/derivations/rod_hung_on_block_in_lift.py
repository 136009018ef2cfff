"""Seen from the cabin, with the weight increased by the inertia force of its acceleration: Newton for the block and the
rod's mass centre, the rod freed at its pin, Euler about its mass centre.

The small motions are apart: block and rod together on the spring; the rod alone as a pendulum.
"""
from math import cos, sin, sqrt


def answers(p):
    m1, m2, L, k, c = (p[n] for n in ("m1", "m2", "L", "k", "c"))
    field = p["g"] + p["a"]

    def pin(q, v, a):
        """The force (X, Y) of the block on the rod."""
        s, co = sin(q["phi"]), cos(q["phi"])
        ax = L / 2 * (co * a["phi"] - s * v["phi"] ** 2)
        ay = a["y"] + L / 2 * (s * a["phi"] + co * v["phi"] ** 2)
        return m2 * ax, m2 * (ay + field)

    def block(q, v, a):
        return m1 * (a["y"] + field) + k * q["y"] + c * v["y"] + pin(q, v, a)[1]

    def rod(q, v, a):
        X, Y = pin(q, v, a)
        # The pin lies at L/2 (-sin phi, cos phi) from the mass centre.
        return m2 * L**2 / 12 * a["phi"] - L / 2 * (-sin(q["phi"]) * Y - cos(q["phi"]) * X)

    rest = {"y": 0.0, "phi": 0.0}
    step = 1e-6
    both = sorted((sqrt(k / (m1 + m2)), sqrt(m2 * field * L / 2 / (m2 * L**2 / 12 + m2 * (L / 2) ** 2))))
    return {
        "motion[y]": block,
        "motion[phi]": rod,
        "equilibrium[y]": -block(rest, rest, rest) / k,
        "K[phi,phi]": (rod(rest | {"phi": step}, rest, rest) - rod(rest | {"phi": -step}, rest, rest)) / (2 * step),
        "C[y,y]": block(rest, {"y": 1.0, "phi": 0.0}, rest) - block(rest, rest, rest),
        "equation[phi]": lambda q, v, a: m2 * L**2 / 3 * a["phi"] + m2 * field * L / 2 * q["phi"],
        "omega[1]": both[0],
        "omega[2]": both[1],
    }
