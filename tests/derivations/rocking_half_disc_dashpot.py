"""Half disc integrated in polar coordinates; the contact as instantaneous centre.

The area's first and second moments about O are integrals over the half disc; J_C = J_O - m e^2. In the
middle position the contact lies R under O, so J_P = J_C + m(R - e)^2; O moves with R phi', and the mass
centre has the height R - e cos(phi) (O keeps its height). Damping ratio from decay rate over natural
frequency.
"""
from math import cos, pi, sqrt

from mpmath import cos as mpcos
from mpmath import quad


def answers(p):
    m, R, c, g = (p[n] for n in ("m", "R", "c", "g"))
    area = pi * R**2 / 2
    e = float(quad(lambda r: r * r, [0, R]) * quad(mpcos, [-pi / 2, pi / 2])) / area
    JC = m / area * float(quad(lambda r: r**3 * pi, [0, R])) - m * e**2
    JP = JC + m * (R - e) ** 2
    C, K = c * R**2, m * g * e
    return {
        "J[rocker]": JC,
        "equation[phi]": lambda q, v, a: JP * a["phi"] + C * v["phi"] + K * q["phi"],
        "zeta[1]": C / (2 * JP) / sqrt(K / JP),
        "V": lambda q: m * g * (R - e * cos(q["phi"])),
    }
