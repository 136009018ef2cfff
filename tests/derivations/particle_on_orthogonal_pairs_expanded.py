"""Energies of the four springs differenced with 60 digits."""
from math import factorial

from mpmath import diff, hypot, mp, mpf


def answers(p):
    with mp.workdps(60):
        k1, k2, N1, N2, length = (mpf(p[name]) for name in ("k1", "k2", "N1", "N2", "l"))
        springs = [(k1, N1, -length, 0), (k1, N1, length, 0), (k2, N2, 0, -length), (k2, N2, 0, length)]

        def V(x, y):
            stretches = [(k, N, hypot(X - x, Y - y) - length) for k, N, X, Y in springs]
            return sum(N * d + k * d**2 / 2 for k, N, d in stretches)

        def factor(i, j):
            return float(diff(V, (mpf(0), mpf(0)), (i, j))) / (factorial(i) * factorial(j))

        found = {"V[x^2]": (2, 0), "V[y^2]": (0, 2), "V[x^4]": (4, 0), "V[y^4]": (0, 4), "V[x^2*y^2]": (2, 2)}
        assert max(abs(factor(1, 1)), abs(factor(1, 2))) < 1e-9 * abs(factor(2, 0))
        return {name: factor(*orders) for name, orders in found.items()} | {"V[x*y]": 0.0, "V[x*y^2]": 0.0}
