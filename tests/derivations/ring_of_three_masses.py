"""Travelling waves on a closed ring of three.

A motion x_n = exp(i n theta) must close after three masses: theta = 0, 2 pi/3 or -2 pi/3. Each mass is
pulled by both neighbours, m omega^2 = k |1 - exp(i theta)|^2; the two directions of travel give the same
frequency. Stiffness entries: the spring forces under a unit displacement of one mass.
"""
from cmath import exp
from math import pi, sqrt


def answers(p):
    m, k = p["m"], p["k"]
    waves = sorted(abs(1 - exp(1j * theta)) * sqrt(k / m) for theta in (0.0, 2 * pi / 3, -2 * pi / 3))

    def forces(x):
        return [k * ((x[i] - x[i - 1]) - (x[(i + 1) % 3] - x[i])) for i in range(3)]

    column = forces([1.0, 0.0, 0.0])
    return {
        "omega[1]": 0.0,
        "omega[2]": waves[1],
        "omega[3]": waves[2],
        "mode[1][x2]": 1.0,
        "mode[1][x3]": 1.0,
        "K[1,1]": column[0],
        "K[1,3]": column[2],
    }
