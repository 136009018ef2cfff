"""Velocities of the planet's two pitch points, those of sun and ring there; its centre and spin from them.

The tooth forces by the momentum laws of the planet: with the forces F1 of the sun and F2 of the ring along the tangent,
m c'' = F1 + F2 and (m r2^2/2) w' = (F2 - F1) r2, so F1 = m c''/2 - m r2 w'/4; the sun feels -F1 at r1.
"""


def answers(p):
    J1, J2, m, r1, r2, kt = (p[n] for n in ("J1", "J2", "m", "r1", "r2", "kt"))
    outer = r1 + 2 * r2

    def planet(alpha, gamma):
        """(speed of the centre, spin)."""
        inner_point, outer_point = r1 * alpha, outer * gamma
        return (inner_point + outer_point) / 2, (outer_point - inner_point) / (2 * r2)

    def T(alpha, gamma):
        c, w = planet(alpha, gamma)
        return (J1 * alpha**2 + J2 * gamma**2 + m * c**2 + m * r2**2 / 2 * w**2) / 2

    def sun(q, v, a):
        c, w = planet(a["alpha"], a["gamma"])
        return J1 * a["alpha"] + kt * q["alpha"] + r1 * (m * c / 2 - m * r2 * w / 4)

    return {
        "T": lambda q, v: T(v["alpha"], v["gamma"]),
        "M[alpha,alpha]": 2 * T(1, 0),
        "M[alpha,gamma]": T(1, 1) - T(1, 0) - T(0, 1),
        "equation[alpha]": sun,
    }
