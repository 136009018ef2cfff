"""d = −a W(−P/(k a)); V = k a² (1 − (1 + u) e^(−u)), u = d/a; the period by quadrature from rest at 0 to rest at X."""

import mpmath


def answers(p):
    m, k, a, P = (p[name] for name in ("m", "k", "a", "P"))
    u = mpmath.re(-mpmath.lambertw(-P / (k * a)))

    def V(x):
        s = abs(x) / a
        return k * a**2 * (1 - (1 + s) * mpmath.exp(-s))

    X = mpmath.findroot(lambda x: V(x) - P * x, (1.1 * a * u, a), solver="anderson")

    def speed(t):
        """Of x = X sin² t, over dx/dt."""
        x = X * mpmath.sin(t) ** 2
        return X * mpmath.sin(2 * t) / mpmath.sqrt(2 / m * (P * x - V(x)))

    return {"equilibrium[x]": a * u, "equilibrium[s.energy]": V(a * u),
            "omega[1]": mpmath.sqrt(k / m * (1 - u) * mpmath.exp(-u)),
            "period(x)": 2 * mpmath.quad(speed, [0, mpmath.pi / 4, mpmath.pi / 2], method="gauss-legendre")}
