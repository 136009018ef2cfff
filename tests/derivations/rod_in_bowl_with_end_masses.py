"""The normal forces of the bowl pass through its centre: moments about it hold weights and inertia alone.

The moment of inertia about the centre is added up along the rod and for the particles, the moment of the weights from
their places beside the centre. Rest is the root of that moment nearest the drawn position on the side where the rod
turns, the frequency follows from its slope there.
"""


def answers(p):
    import mpmath as mp
    import numpy as np

    m, m1, m2, a, d, g = (p[n] for n in ("m", "m1", "m2", "a", "d", "g"))
    nodes, weights = np.polynomial.legendre.leggauss(4)
    parts = [(m * w / 2, a * u) for w, u in zip(weights, nodes, strict=True)] + [(m1, -a), (m2, a)]
    inertia = sum(mass * (u**2 + d**2) for mass, u in parts)

    def moment(phi):
        """Of the weights, counter-clockwise."""
        return -sum(mass * g * (u * mp.cos(phi) + d * mp.sin(phi)) for mass, u in parts)

    def residual(q, v, acc):
        return inertia * acc["phi"] - float(moment(q["phi"]))

    with mp.workdps(30):
        rest = mp.findroot(moment, (-1.5, 1.5), solver="anderson")
        square = -mp.diff(moment, rest) / inertia
    return {
        "motion[phi]": residual,
        "T": lambda q, v: inertia * v["phi"] ** 2 / 2,
        "equilibrium[phi]": float(rest),
        "omega[1]": float(mp.sqrt(square)),
    }
