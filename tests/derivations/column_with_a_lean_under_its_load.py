"""P L sin u = k L^2 (sin u - sin a) cos u, u = -phi: extreme where sin^3 u = sin a, P = k L (1 - sin^(2/3) a)^(3/2)."""

import mpmath


def answers(p):
    k, L, P, a = p["k"], p["L"], p["P"], p["phi0"]
    most = k * L * (1 - mpmath.sin(a) ** (mpmath.mpf(2) / 3)) ** mpmath.mpf("1.5")
    lean = mpmath.findroot(lambda u: P * mpmath.sin(u) - k * L * (mpmath.sin(u) - mpmath.sin(a)) * mpmath.cos(u), 1.3 * a)
    return {"equilibrium[phi]": -lean, "fold[1, P]": most, "fold[1, k]": k * P / most,
            "fold[1, P](phi)": -mpmath.asin(mpmath.cbrt(mpmath.sin(a)))}
