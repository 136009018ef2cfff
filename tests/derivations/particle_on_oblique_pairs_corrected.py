"""Energies by the tensions of the springs, differenced with 60 digits; of one spring less that of its deflection of the
first order."""
from math import factorial

from mpmath import cos, diff, hypot, mp, mpf, sin


def answers(p):
    with mp.workdps(60):
        k1, k2, N, length, a = (mpf(p[name]) for name in ("k1", "k2", "N", "l", "a"))
        c, s = length * cos(a), length * sin(a)
        springs = [(k1, N, -c, -s), (k1, N, c, s), (k2, mpf(0), -c, s), (k2, mpf(0), c, -s)]

        def stored(k, tension, d):
            return tension * d + k * d**2 / 2

        def stretch(X, Y, x, y):
            return hypot(x - X, y - Y) - length

        def V(x, y):
            return sum(stored(k, tension, stretch(X, Y, x, y)) for k, tension, X, Y in springs)

        def geometric(x, y):
            straight = (x * c + y * s) / length
            return stored(k1, N, stretch(-c, -s, x, y)) - stored(k1, N, straight)

        def factor(energy, i, j):
            return float(diff(energy, (mpf(0), mpf(0)), (i, j))) / (factorial(i) * factorial(j))

        found = {f"V[{name}]": factor(V, i, j) for name, i, j in (
            ("x^2", 2, 0), ("x*y", 1, 1), ("x^3", 3, 0), ("x^2*y", 2, 1), ("x^4", 4, 0), ("x^2*y^2", 2, 2))}
        return found | {f"stiffness_correction[s1, {name}]": n * factor(geometric, i, j) for name, n, i, j in (
            ("x", 2, 2, 0), ("y", 2, 0, 2), ("x^2", 3, 3, 0), ("x*y", 2, 2, 1))}
