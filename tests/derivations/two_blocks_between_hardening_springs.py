"""x = y leaves the middle spring at rest, x = -y stretches it by 2 x: m x'' + K x + G x^3 = 0 by elliptic integrals."""

import mpmath


def answers(p):
    def omega(K, G):
        cubic = G * p["A"] ** 2
        return mpmath.pi * mpmath.sqrt((K + cubic) / p["m"]) / (2 * mpmath.ellipk(cubic / (2 * (K + cubic))))

    against = p["k"] + 2 * p["c"]
    first, second = omega(p["k"], p["b"]), omega(against, p["b"] + 8 * p["f"])
    return {"omega[1]": mpmath.sqrt(p["k"] / p["m"]), "backbone[1](x)(A)": first, "backbone[1](y)(A)": first,
            "omega[2]": mpmath.sqrt(against / p["m"]), "backbone[2](x)(A)": second,
            "backbone[2](t.stretch)(2*A)": second}
