"""Energies of the springs differenced with 60 digits; forces by the product of coefficients and powers."""
from math import factorial

from mpmath import diff, hypot, mp, mpf


def answers(p):
    with mp.workdps(60):
        k1, b, k2, N, length = (mpf(p[name]) for name in ("k1", "b", "k2", "N", "l"))

        def duffing(d):
            return k1 * d**2 / 2 + b * d**4 / 4

        def linear(d):
            return N * d + k2 * d**2 / 2

        def stretch(X, Y, x, y):
            return hypot(x - X, y - Y) - length

        def V(x, y):
            pair = sum(duffing(stretch(X, mpf(0), x, y)) for X in (-length, length))
            return pair + sum(linear(stretch(mpf(0), Y, x, y)) for Y in (-length, length))

        def left(x, y):
            return duffing(stretch(-length, mpf(0), x, y)) - duffing(x)

        def below(x, y):
            return linear(stretch(mpf(0), -length, x, y)) - linear(y)

        def factor(energy, i, j):
            return float(diff(energy, (mpf(0), mpf(0)), (i, j))) / (factorial(i) * factorial(j))

        c = {(i, j): factor(V, i, j) for i, j in ((2, 0), (0, 2), (4, 0), (0, 4), (2, 2))}
        found = {"V[x^4]": c[4, 0], "V[x^2*y^2]": c[2, 2]} | {
            f"stiffness_correction[{name}]": n * factor(energy, i, j) for name, energy, n, i, j in (
                ("left, y", left, 2, 0, 2), ("left, y^3", left, 4, 0, 4), ("left, x*y^2", left, 2, 2, 2),
                ("below, x", below, 2, 2, 0), ("below, x*y", below, 2, 2, 1))}

    def along(one, other, two, four):
        return lambda q, v, a: (p["m"] * a[one] + 2 * c[two] * q[one] + 4 * c[four] * q[one]**3
                                + 2 * c[2, 2] * q[one] * q[other]**2)

    return found | {"motion[x]": along("x", "y", (2, 0), (4, 0)), "motion[y]": along("y", "x", (0, 2), (0, 4))}
