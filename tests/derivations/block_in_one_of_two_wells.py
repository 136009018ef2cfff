"""x = x0 dn within a well, x = x0 cn through both: periods of Jacobi's functions; the largest speed by the energy, as
that of the rest at sqrt(k/b) is the least."""

import mpmath


def answers(p):
    m, k, b, x0 = p["m"], p["k"], p["b"], p["x0"]
    inner = 2 * k / b - x0**2
    far = mpmath.mpf(3) / 10
    rate = (b * far**2 - k) / m
    modulus = b * far**2 / (2 * m * rate)

    def potential(x):
        return b * x**4 / 4 - k * x**2 / 2

    return {"equilibrium[x]": mpmath.sqrt(k / b), "min(x)": mpmath.sqrt(inner),
            "period(x)": 2 * mpmath.ellipk(1 - inner / x0**2) / (x0 * mpmath.sqrt(b / (2 * m))),
            "through both: period(x)": 4 * mpmath.ellipk(modulus) / mpmath.sqrt(rate),
            "through both: max(x')": mpmath.sqrt(2 * (potential(far) - potential(mpmath.sqrt(k / b))) / m)}
