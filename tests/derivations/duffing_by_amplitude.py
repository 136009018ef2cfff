"""m x'' + k x + g x^3 = 0: omega = pi sqrt((k + g A^2)/m) / (2 K(mu)), mu = g A^2/(2 (k + g A^2)) = modulus squared."""

import mpmath


def answers(p):
    def omega(g):
        whole = p["k"] + g * p["A"] ** 2
        return mpmath.pi * mpmath.sqrt(whole / p["m"]) / (2 * mpmath.ellipk(g * p["A"] ** 2 / (2 * whole)))

    return {"backbone[1](x)(A)": omega(p["g3"]), "softening: backbone[1](x)(A)": omega(-p["g3"])}
