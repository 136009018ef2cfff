"""Rayleigh's quotient of two deflections of a blade, by quadrature in mpmath of second derivatives by hand."""
from mpmath import cos, mpf, pi, quad, sqrt


def answers(p):
    L, EI, mu, M, k = (mpf(p[n]) for n in ("L", "EI", "mu", "M", "k"))

    def quotient(f, bent):
        stored = quad(lambda x: EI * bent(x) ** 2, [0, L]) + k * f(2 * L / 3) ** 2
        return sqrt(stored / (quad(lambda x: mu * f(x) ** 2, [0, L]) + M * f(L) ** 2))

    w = pi / (2 * L)
    return {"rayleigh[x^2]": quotient(lambda x: x**2, lambda x: 2),
            "rayleigh[1 - cos(pi*x/(2*L))]": quotient(lambda x: 1 - cos(w * x), lambda x: w**2 * cos(w * x))}
