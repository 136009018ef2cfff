"""Lagrange's equations of both masses, from T, V and R differentiated twice, numerically.

T = m1 x1'^2/2 + m2 x2'^2/2 + b s'^2/2 and V = k1 s^2/2 + k2 x2^2/2 with s = x1 - x2, damped by
R = c1 s'^2/2. The steady state is that of the complex amplitudes, solved in 30 digits; the frame stands
still where the forces of the spring and the inerter cancel.
"""
from mpmath import diff, matrix, mp, mpf, sqrt


def lagrange(p, b):
    """M, C and K in the order x1, x2."""
    m1, m2, k1, k2, c1 = (mpf(p[name]) for name in ("m1", "m2", "k1", "k2", "c1"))

    def T(v1, v2):
        return (m1 * v1**2 + m2 * v2**2 + b * (v1 - v2) ** 2) / 2

    def R(v1, v2):
        return c1 * (v1 - v2) ** 2 / 2

    def V(x1, x2):
        return (k1 * (x1 - x2) ** 2 + k2 * x2**2) / 2

    return [matrix([[diff(form, (0, 0), (2, 0)), diff(form, (0, 0), (1, 1))],
                    [diff(form, (0, 0), (1, 1)), diff(form, (0, 0), (0, 2))]]) for form in (T, R, V)]


def steady(p, b):
    """Complex amplitudes of x1 and x2."""
    M, C, K = lagrange(p, b)
    Omega = mpf(p["Omega"])
    return mp.lu_solve(K - Omega**2 * M + 1j * Omega * C, matrix([mpf(p["F0"]), 0]))


def answers(p):
    with mp.workdps(30):
        b, Omega = mpf(p["b"]), mpf(p["Omega"])
        M, C, K = lagrange(p, b)
        mixed = M[0, 0] * K[1, 1] + M[1, 1] * K[0, 0] - 2 * M[0, 1] * K[0, 1]      # det(K - W M) = 0, W = omega^2
        root = sqrt(mixed**2 - 4 * mp.det(M) * mp.det(K))
        squares = [(mixed - root) / (2 * mp.det(M)), (mixed + root) / (2 * mp.det(M))]
        x1, x2 = steady(p, b)
        bare = steady(p, mpf(0))

        def row(i):
            def residual(q, v, a):
                load = p["F0"] * mp.sin(Omega * q["t"]) if i == 0 else 0
                forces = sum(M[i, j] * a[n] + C[i, j] * v[n] + K[i, j] * q[n] for j, n in enumerate(("x1", "x2")))
                return float(forces - load)
            return residual

        return {
            "M[x1,x1]": float(M[0, 0]),
            "M[x1,x2]": float(M[0, 1]),
            "M[x2,x2]": float(M[1, 1]),
            "equation[x1]": row(0),
            "equation[x2]": row(1),
            "omega[1]": float(sqrt(squares[0])),
            "omega[2]": float(sqrt(squares[1])),
            "amplitude(x1)": float(abs(x1)),
            "amplitude(x2)": float(abs(x2)),
            "amplitude(i.force)": float(b * Omega**2 * abs(x1 - x2)),
            "amplitude(ground.force)": float(p["k2"] * abs(x2)),
            "without the inerter: amplitude(ground.force)": float(p["k2"] * abs(bare[1])),
            "without the damper: antiresonance[1](frf[x2, drive])": float(sqrt(mpf(p["k1"]) / b)),
        }
