"""T = 4 sqrt(pi m (n + 1)/(2 a)) A^((1 - n)/2) Gamma(1/(n + 1))/((n + 1) Gamma(1/(n + 1) + 1/2)), n = 3/2."""

import mpmath


def answers(p):
    n = mpmath.mpf(3) / 2
    share = 1 / (n + 1)

    def omega(A):
        period = 4 * mpmath.sqrt(mpmath.pi * p["m"] / (2 * p["a"] * share)) * A ** ((1 - n) / 2) * share
        return 2 * mpmath.pi * mpmath.gamma(share + 0.5) / (period * mpmath.gamma(share))

    return {"backbone[1](x)(A)": omega(p["A"]), "backbone[1](x)(16*A)": 2 * omega(p["A"])}
