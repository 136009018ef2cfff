"""Disc about its contact (instantaneous centre), rod as two equivalent masses.

The disc turns about the contact with J_P = 3/2 m1 r^2 at the rate (R - r) psi'/r. The rod is replaced by
three particles m/6, 2m/3, m/6 at its ends and middle, which have its mass, centre and inertia. Places of
all particles give T at the lowest position and V anywhere; M and K by differences in 30 digits,
frequencies by eigenvalues.
"""
from mpmath import cos, diff, mp, mpf, sqrt


def answers(p):
    with mp.workdps(30):
        m1, r, R, m2, L, g = (mpf(p[n]) for n in ("m1", "r", "R", "m2", "L", "g"))
        arm = R - r
        dumbbell = [(m2 / 6, mpf(0)), (2 * m2 / 3, L / 2), (m2 / 6, L)]

        def T(u, w):
            disc = mpf(3) / 2 * m1 * r**2 * (arm * u / r) ** 2
            return (disc + sum(m * (arm * u + s * w) ** 2 for m, s in dumbbell)) / 2

        def V(psi, phi):
            disc = -m1 * g * arm * cos(psi)
            return disc - sum(m * g * (arm * cos(psi) + s * cos(phi)) for m, s in dumbbell)

        M, K = ([diff(f, (0, 0), n) for n in ((2, 0), (1, 1), (0, 2))] for f in (T, V))
        a, b, c = M[0] * M[2] - M[1] ** 2, M[0] * K[2] + M[2] * K[0], K[0] * K[2]
        root = sqrt(b * b - 4 * a * c)
        return {
            "M[psi,psi]": float(M[0]),
            "M[psi,phi]": float(M[1]),
            "M[phi,phi]": float(M[2]),
            "K[psi,psi]": float(K[0]),
            "K[phi,phi]": float(K[2]),
            "V": lambda q: float(V(q["psi"], q["phi"])),
            "omega[1]": float(sqrt(2 * c / (b + root))),
            "omega[2]": float(sqrt((b + root) / (2 * a))),
        }
