"""Energies of the two rods from the velocities and heights of their centres, differenced in 30 digits.

T is written with the velocity vectors of the centres at the hanging position, V with the exact heights;
second differences give M and K. Frequencies are the roots of the quadratic det(K - lambda M) = 0, the
ratio from its first row.
"""
from mpmath import cos, diff, mp, mpf, sqrt


def answers(p):
    with mp.workdps(30):
        m1, m2, L1, L2, g = (mpf(p[n]) for n in ("m1", "m2", "L1", "L2", "g"))

        def T(u1, u2):
            upper = m1 * (L1 / 2 * u1) ** 2 + m1 * L1**2 / 12 * u1**2
            lower = m2 * (L1 * u1 + L2 / 2 * u2) ** 2 + m2 * L2**2 / 12 * u2**2
            return (upper + lower) / 2

        def V(f1, f2):
            return -g * (m1 * L1 / 2 * cos(f1) + m2 * (L1 * cos(f1) + L2 / 2 * cos(f2)))

        def second(f):
            return [diff(f, (0, 0), n) for n in ((2, 0), (1, 1), (0, 2))]

        (M11, M12, M22), (K11, K12, K22) = second(T), second(V)
        A, B, D = M11 * M22 - M12**2, M11 * K22 + M22 * K11 - 2 * M12 * K12, K11 * K22 - K12**2
        out = {"M[1,1]": M11, "M[1,2]": M12, "M[2,2]": M22, "K[1,1]": K11, "K[2,1]": K12, "K[2,2]": K22}
        for i, sign in ((1, -1), (2, 1)):
            lam = (B + sign * sqrt(B**2 - 4 * A * D)) / (2 * A)
            out[f"omega[{i}]"] = sqrt(lam)
            out[f"mode[{i}][phi2]"] = -(K11 - lam * M11) / (K12 - lam * M12)
        return {key: float(value) for key, value in out.items()}
