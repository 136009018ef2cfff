"""sin(n pi x/L) in EI u'''' + P u'' = mu omega^2 u."""
from math import pi, sqrt


def answers(p):
    L, EI, mu, P = (p[n] for n in ("L", "EI", "mu", "P"))
    return {f"omega[{n}]": sqrt((EI * (n * pi / L) ** 4 - P * (n * pi / L) ** 2) / mu) for n in (1, 2, 3)}
