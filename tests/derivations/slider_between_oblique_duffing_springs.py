"""Energies of a spring behind and of one ahead by differences; the force of one less that of its law alone."""
from math import cos as cosine
from math import sqrt as root

from mpmath import cos, mp, mpf, sin, sqrt, taylor


def answers(p):
    with mp.workdps(60):
        k, b, length, a = (mpf(p[name]) for name in ("k", "b", "l", "a"))

        def stored(d):
            return k * d**2 / 2 + b * d**4 / 4

        def of(X):
            return taylor(lambda x: stored(sqrt((X + x)**2 + (length * sin(a))**2) - length), 0, 4)

        behind, ahead = of(length * cos(a)), of(-length * cos(a))
        straight = taylor(lambda x: stored(x * cos(a)), 0, 4)
        found = {f"V[x^{n}]": float(2 * (behind[n] + ahead[n])) for n in (2, 3, 4)}
        found |= {f"stiffness_correction[s1, x{power}]": float(n * (behind[n] - straight[n]))
                  for power, n in (("", 2), ("^2", 3), ("^3", 4))}
        return found | {"omega[1]": 2 * abs(cosine(p["a"])) * root(p["k"] / p["m"])}
