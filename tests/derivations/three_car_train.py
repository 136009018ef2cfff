"""Symmetry: the motions are either odd or even about the middle car.

Rigid: all cars together, no spring changes. Odd: the middle car stands and an outer one swings on k.
Even: both outer cars move alike; the centre of mass at rest gives the middle car's share, and an outer
car is pulled by k times the difference.
"""
from math import sqrt


def answers(p):
    m1, m2, k = p["m1"], p["m2"], p["k"]
    middle = -(m1 + m1) / m2
    return {
        "omega[1]": 0.0,
        "omega[2]": sqrt(k / m1),
        "omega[3]": sqrt(k * (1 - middle) / m1),
        "mode[1][x2]": 1.0,
        "mode[1][x3]": 1.0,
        "mode[2][x2]": 0.0,
        "mode[2][x3]": -1.0,
        "mode[3][x2]": middle,
        "mode[3][x3]": 1.0,
    }
