"""Half waves about (P ∓ F0)/k to either side of the middle, cut off there."""

import mpmath


def answers(p):
    m, F, k, P, A = (p[name] for name in ("m", "F0", "k", "P", "A"))
    omega = mpmath.sqrt(k / m)

    def quarter(X, force):
        """From rest at the distance X to the middle under force + k x: cos ωt = c/(X + c), c = force/k."""
        c = force / k
        return mpmath.acos(c / (X + c)) / omega

    def other(X):
        """k x²/2 + (F0 + P) x = k X²/2 + (F0 − P) X."""
        b = (F + P) / k
        return mpmath.sqrt(b * b + X * X + 2 * (F - P) / k * X) - b

    def period(X):
        return 2 * (quarter(X, F - P) + quarter(other(X), F + P))

    right = mpmath.findroot(lambda X: (X + other(X)) / 2 - A, A)
    return {"equilibrium[x]": 0, "equilibrium[detent.force]": P, "period(x)": period(A), "min(x)": -other(A),
            "backbone[1](x)(A)": 2 * mpmath.pi / period(right)}
