"""Moments about the hinge, the rod as three particles (m/6, 2m/3, m/6); the static moment of the spring is that of the
weights on the level arm. The push of the wind on the board is b U times its upward speed L phi' cos(phi).
"""
from math import cos, sqrt


def answers(p):
    m, L, m0, kt, ct, b, g = (p[n] for n in ("m", "L", "m0", "kt", "ct", "b", "g"))
    particles = [(2 * m / 3, L / 2), (m / 6 + m0, L)]
    J = sum(mass * x**2 for mass, x in particles)

    def moments(U, q, v, a):
        reach = cos(q["phi"])
        weights = -sum(mass * g * x for mass, x in particles)
        spring = -weights - kt * q["phi"]
        push = b * U * L * v["phi"] * reach
        return J * a["phi"] - (weights * reach + spring - ct * v["phi"] + push * L * reach)

    rest = {"phi": 0.0}

    def damping(U):
        return moments(U, rest, {"phi": 1.0}, rest)

    own = sqrt(kt / J)
    calm, storm = damping(p["U"]), damping(15.0)
    return {
        "motion[phi]": lambda q, v, a: moments(p["U"], q, v, a),
        "C[phi,phi]": calm,
        "equilibrium[phi]": 0.0,
        "stable": calm > 0,
        "omega[1]": own,
        "zeta[1]": calm / (2 * J * own),
        "storm: stable": storm > 0,
        "storm: zeta[1]": storm / (2 * J * own),
    }
