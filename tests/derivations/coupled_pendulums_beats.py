"""Symmetry: in phase the spring keeps its length, in opposition its middle stands still.

In phase each pendulum swings as if alone. In opposition each has half the spring, of stiffness 2k, from
its rod to a fixed point. The moment equation of the left pendulum is written with the spring's force; V
from the places of the spring's ends.
"""
from math import cos, hypot, pi, sin, sqrt


def answers(p):
    m, L, a, d, k, g = (p[n] for n in ("m", "L", "a", "d", "k", "g"))
    inertia = m * L**2
    alone = sqrt(m * g * L / inertia)
    opposed = sqrt((m * g * L + (2 * k) * a * a) / inertia)

    def left(q, v, acc):
        pull = k * (a * q["phi2"] - a * q["phi1"])
        return inertia * acc["phi1"] + m * g * L * q["phi1"] - pull * a

    def V(q):
        f1, f2 = q["phi1"], q["phi2"]
        end1, end2 = (a * sin(f1), -a * cos(f1)), (d + a * sin(f2), -a * cos(f2))
        stretch = hypot(end2[0] - end1[0], end2[1] - end1[1]) - d
        return m * g * L * (1 - cos(f1)) + m * g * L * (1 - cos(f2)) + k * stretch**2 / 2

    return {
        "omega[1]": alone,
        "omega[2]": opposed,
        "period[1]": 2 * pi / alone,
        "mode[1][phi2]": 1.0,
        "mode[2][phi2]": -1.0,
        "equation[phi1]": left,
        "V": V,
    }
