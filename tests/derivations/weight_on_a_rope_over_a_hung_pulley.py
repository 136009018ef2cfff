"""Instantaneous centre: the standing side of the rope touches the pulley at a point that does not move, about which the
pulley turns by y/r; its kinetic energy is ½ (J + m₁ r²)(y'/r)², the weight, 2 r from there, moves 2 y'.
"""
from math import sqrt


def answers(p):
    m1, m2, J, k, r, g = (p[x] for x in ("m1", "m2", "J", "k", "r", "g"))
    about_centre = J + m1 * r**2 + m2 * (2 * r) ** 2
    return {
        "equilibrium[s.force]": (m1 * g * r + m2 * g * 2 * r) / r,
        "equilibrium[rope.force.1]": m2 * g,
        "equilibrium[rope.force.2]": m2 * g,
        "omega[1]": sqrt(k * r**2 / about_centre),
        "mode[1][w.y]": 2.0,
        "M[y,y]": about_centre / r**2,
    }
