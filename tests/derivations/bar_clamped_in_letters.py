"""u = sin(beta x) with u'(L) = 0, so that beta L = (2n - 1) pi/2."""
from math import pi, sqrt


def answers(p):
    L, E, rho = p["L"], p["E"], p["rho"]
    return {f"omega[{n}]": (2 * n - 1) * pi / (2 * L) * sqrt(E / rho) for n in (1, 2, 7)}
