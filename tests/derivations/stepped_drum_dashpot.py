"""Moments about the point of contact, which is the instantaneous centre.

Kinetic energy is J_P omega^2/2 with J_P = m(i^2 + r^2); the spring acts at the height r + R and the
dashpot at r - R over the contact, each with force = law times (height times the turn). The turn is x/r.
"""
from math import sqrt


def answers(p):
    m, i, r, R, k, c = (p[n] for n in ("m", "i", "r", "R", "k", "c"))
    JP = m * i**2 + m * r**2
    high, low = r + R, r - R
    stiffness, damping = k * high * high, c * low * low
    wn = sqrt(stiffness / JP)
    decay = damping / JP / 2
    return {
        "equation[x]": lambda q, v, a: (JP * a["x"] + damping * v["x"] + stiffness * q["x"]) / r,
        "zeta[1]": decay / wn,
        "omega_d[1]": sqrt((wn - decay) * (wn + decay)),
        "energy: T": lambda q, v: JP * (v["x"] / r) ** 2 / 2,
    }
