"""The planet's turn is found from equal arcs: the contact wanders by R·theta on the fixed gear, the
planet turns by as much arc against the arm, plus the arm's own turn. Places of the three bodies follow;
velocities are their numerical derivatives along theta, heights give V, and the frequency is √(V″/2T)
from second differences.
"""


def answers(p):
    import mpmath as mp

    m1, m2, m3, R, r = p["m1"], p["m2"], p["m3"], p["R"], p["r"]

    def turn(theta):
        return theta + R * theta / r

    def bead(theta):
        hub = mp.matrix([mp.sin(theta), -mp.cos(theta)]) * (R + r)
        return hub + r * mp.matrix([mp.sin(turn(theta)), -mp.cos(turn(theta))])

    def inertia(theta):
        """Twice the kinetic energy at unit theta'."""
        arm = m1 * (R + r) ** 2 / 12 + m1 * (R + r) ** 2 / 4
        planet = m2 * (R + r) ** 2 + m2 * r**2 / 2 * mp.diff(turn, theta) ** 2
        vx, vy = (mp.diff(lambda u, i=i: bead(u)[i], theta) for i in (0, 1))
        return arm + planet + m3 * (vx**2 + vy**2)

    def potential(theta):
        return p["g"] * ((m1 / 2 + m2) * -(R + r) * mp.cos(theta) + m3 * bead(theta)[1])

    return {
        "T": lambda q, v: float(inertia(q["theta"]) * v["theta"] ** 2 / 2),
        "V": lambda q: float(potential(q["theta"])),
        "omega[1]": float(mp.sqrt(mp.diff(potential, 0, 2) / inertia(0))),
    }
