"""The real root of c5 d⁵ + c3 d³ + k d = m g, and the derivatives of the law there; dω/dm with d(m)."""

import mpmath


def answers(p):
    k, c3, c5, m, g = (p[name] for name in ("k", "c3", "c5", "m", "g"))
    d = next(mpmath.re(root) for root in mpmath.polyroots([c5, 0, c3, 0, k, -m * g], maxsteps=200, extraprec=200)
             if abs(mpmath.im(root)) < mpmath.mpf(10) ** -20 * abs(root))
    K = k + 3 * c3 * d**2 + 5 * c5 * d**4
    second, third = 6 * c3 * d + 20 * c5 * d**3, 6 * c3 + 60 * c5 * d**2
    omega = mpmath.sqrt(K / m)
    by_m = (second * g / K / m - K / m**2) / (2 * omega)    # dd/dm = g/K
    # upwards y lessens d
    return {"equilibrium[mount.deflection]": d, "omega[1]": omega, "V[y^3]": -second / 6, "V[y^4]": third / 24,
            "sensitivity[1, m]": by_m}
