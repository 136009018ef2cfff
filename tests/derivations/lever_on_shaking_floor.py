"""Moments about the hinge: the bar as three particles (m/6, 2m/3, m/6), spring and damper with the upward
displacements of both their ends. The constant weight is in balance with the static compression of the spring.
"""
from math import cos, sin, sqrt


def answers(p):
    M, L, m, k, c, b, d, Y, Omega = (p[n] for n in ("M", "L", "m", "k", "c", "b", "d", "Y", "Omega"))
    particles = [(2 * M / 3, L / 2), (M / 6 + m, L)]
    J = sum(mass * x**2 for mass, x in particles)

    def moments(q, v, a):
        floor, rate = Y * sin(Omega * q["t"]), Y * Omega * cos(Omega * q["t"])
        spring = -k * (b * q["phi"] - floor)
        damper = -c * (d * v["phi"] - rate)
        return J * a["phi"] - b * spring - d * damper

    half, square = c * d**2 / (2 * J), k * b**2 / J
    return {
        "J[lever]": sum(mass * (x - L / 2) ** 2 for mass, x in [(M / 6, 0), (2 * M / 3, L / 2), (M / 6, L)]),
        "M[phi,phi]": J,
        "C[phi,phi]": c * d**2,
        "equilibrium[phi]": 0.0,
        "equation[phi]": moments,
        "zeta[1]": half / sqrt(square),
        "omega_d[1]": sqrt(square - half**2),
    }
