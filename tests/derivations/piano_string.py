"""f_n = n f_0 sqrt(1 + B n^2), B = pi^2 EI/(S L^2), f_0 = sqrt(S/mu)/(2L)."""
from math import log, pi, sqrt


def answers(p):
    L, d, S, E, rho = (p[n] for n in ("L", "d", "S", "E", "rho"))
    mu, B = rho * pi * d**2 / 4, pi**2 * E * pi * d**4 / 64 / (S * L**2)
    f = {n: n * sqrt(S / mu) / (2 * L) * sqrt(1 + B * n * n) for n in (1, 16)}
    return {"frequency[1]": f[1], "frequency[16]": f[16],
            "1200*log(omega[16]/(16*omega[1]))/log(2)": 1200 * log(f[16] / f[1] / 16) / log(2)}
