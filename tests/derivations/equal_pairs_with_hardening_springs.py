"""Energies of the four springs differenced with 60 digits; forces by the product of coefficients and powers."""
from math import factorial

from mpmath import diff, hypot, mp, mpf


def answers(p):
    with mp.workdps(60):
        k, g, length = (mpf(p[name]) for name in ("k", "g", "l"))
        ends = [(-length, 0), (length, 0), (0, -length), (0, length)]

        def V(x, y):
            stretches = [hypot(X - x, Y - y) - length for X, Y in ends]
            return sum(k * d**2 / 2 + g * d**4 / 4 for d in stretches)

        def factor(i, j):
            return float(diff(V, (mpf(0), mpf(0)), (i, j))) / (factorial(i) * factorial(j))

        two, four, mixed = factor(2, 0), factor(4, 0), factor(2, 2)

    def left_side(one, other):
        def motion(q, v, a):
            u, w = q[one], q[other]
            return p["m"] * a[one] + 2 * two * u + 4 * four * u**3 + 2 * mixed * u * w**2
        return motion

    return {"V[x^2]": two, "V[x^4]": four, "V[x^2*y^2]": mixed, "motion[x]": left_side("x", "y"),
            "motion[y]": left_side("y", "x")}
