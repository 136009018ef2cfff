"""The restoring force, written as forces along the springs, differenced at the place where it balances the load."""
from math import factorial

from mpmath import diff, findroot, hypot, mp, mpf


def answers(p):
    with mp.workdps(50):
        k, N, b, h, P = (mpf(p[name]) for name in ("k", "N", "b", "h", "P"))

        def force(x):
            length = hypot(b - x, h)
            return -2 * (N + k * (length - hypot(b, h))) * (b - x) / length

        x = findroot(lambda x: force(x) + P, mpf(0))
        found = {"equilibrium[x]": float(x), "V[x]": float(force(x))}
        for n in (2, 3, 4):
            found[f"{n}*V[x^{n}]"] = float(diff(force, x, n - 1)) / factorial(n - 1)
        return found
