"""Roots of b tan b = mu L/M in 30 digits; u ~ sin(b x/L) vanishes at x = pi L/b."""
from mpmath import cos, findroot, mp, mpf, pi, sin, sqrt


def answers(p):
    with mp.workdps(30):
        L, A, E, rho, M = (mpf(p[n]) for n in ("L", "A", "E", "rho", "M"))
        ratio = rho * A * L / M
        b = [findroot(lambda x: x * sin(x) - ratio * cos(x), (n * pi + mpf("1e-9"), n * pi + pi / 2), "anderson")
             for n in range(3)]
        omega = [x / L * sqrt(E / rho) for x in b]
        return {**{f"omega[{i}]": w for i, w in enumerate(omega, 1)},
                "omega[1]/sqrt(E*A/(L*M))": omega[0] / sqrt(E * A / (L * M)), "node[2][rod, 1]": pi * L / b[1]}
