"""Seen from the first shaft the second one's impedance counts (r1/r2)^2; transfer matrices in 30 digits."""
from mpmath import mp, mpf, pi
from support.transfer_matrices import bar, condition, first_roots, mass


def answers(p):
    with mp.workdps(30):
        names = ("Jm", "Jf", "J1", "J2", "L1", "L2", "r1", "r2", "d", "G", "rho")
        Jm, Jf, J1, J2, L1, L2, r1, r2, d, G, rho = (mpf(p[n]) for n in names)
        polar, n2 = pi * d**4 / 32, (r1 / r2) ** 2
        one = bar(L1, G * polar, rho * polar)
        two = bar(L2, n2 * G * polar, n2 * rho * polar)
        chain = [mass(2, Jm), one, mass(2, J1), mass(2, n2 * J2), two, mass(2, n2 * Jf)]
        roots = first_roots(condition(chain, "free", "free"), 2, mpf(11))
        return {"omega[2]": roots[0], "omega[3]": roots[1]}
