"""Moments about the pivot of bob and rider, turned by a small angle, and the roots of the quadratic for the rider.

J w^2 = g (M b - m a) with J = M b^2 + m a^2 as sums over the two particles; the limit is where the moment vanishes.
"""
from mpmath import mpf, pi, polyroots


def answers(p):
    M, b, m, g = (mpf(p[key]) for key in "Mbmg")
    out = {"a": float(polyroots([m, -M * b])[0])}
    for case, period in (("slow: ", 1), ("fast: ", mpf("0.5"))):
        square = (2 * pi / period) ** 2
        above = [root for root in polyroots([square * m, g * m, square * M * b**2 - g * M * b]) if root > 0]
        out[case + "a"] = float(above[0])
    out["slow: omega[1]"] = float(2 * pi)
    return out
