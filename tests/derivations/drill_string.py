"""b tan b = rho Ip L/J."""
from mpmath import cos, findroot, mp, mpf, pi, sin, sqrt


def answers(p):
    with mp.workdps(30):
        L, D, d, G, rho, J = (mpf(p[n]) for n in ("L", "D", "d", "G", "rho", "J"))
        ratio = rho * pi * (D**4 - d**4) / 32 * L / J
        b = [findroot(lambda x: x * sin(x) - ratio * cos(x), (n * pi + mpf("1e-9"), n * pi + pi / 2), "anderson")
             for n in range(3)]
        return {f"omega[{i}]": x / L * sqrt(G / rho) for i, x in enumerate(b, 1)}
