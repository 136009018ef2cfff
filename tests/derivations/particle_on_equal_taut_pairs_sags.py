"""The place of rest by the forces of the springs; energies differenced there with 60 digits, of one spring less that of
its deflection of the first order."""
from math import factorial

from mpmath import diff, findroot, hypot, mp, mpf, sqrt


def answers(p):
    with mp.workdps(60):
        m, k, N, length, g = (mpf(p[name]) for name in ("m", "k", "N", "l", "g"))
        h = length / sqrt(mpf(2))
        ends = [(-h, h), (h, h), (h, -h), (-h, -h)]

        def tension(X, Y, y):
            return N + k * (hypot(X, y - Y) - length)

        rest = findroot(lambda y: sum(tension(X, Y, y) * (Y - y) / hypot(X, y - Y) for X, Y in ends) - m * g,
                        mpf("-0.05"))

        def stored(d):
            return N * d + k * d**2 / 2

        def V(x, y):
            return sum(stored(hypot(x - X, y - Y) - length) for X, Y in ends) + m * g * y

        X, Y = ends[0]
        r = hypot(X, rest - Y)
        slope = (-X / r, (rest - Y) / r)

        def geometric(x, y):
            straight = r - length + slope[0] * x + slope[1] * (y - rest)
            return stored(hypot(x - X, y - Y) - length) - stored(straight)

        def factor(energy, i, j):
            return float(diff(energy, (mpf(0), rest), (i, j))) / (factorial(i) * factorial(j))

        found = {f"V[{name}]": factor(V, i, j) for name, i, j in (
            ("x^2", 2, 0), ("y^2", 0, 2), ("x^2*y", 2, 1), ("y^3", 0, 3), ("x^2*y^2", 2, 2))}
        found |= {f"stiffness_correction[s1, {name}]": 2 * factor(geometric, i, j) for name, i, j in (
            ("x", 2, 0), ("y", 0, 2), ("x*y", 2, 1))}
        least = min(found["V[x^2]"], found["V[y^2]"])
        return found | {"equilibrium[x]": 0.0, "equilibrium[y]": float(rest), "V[y]": 0.0,
                        "omega[1]": float(sqrt(2 * least / m))}
