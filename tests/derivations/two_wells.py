"""2 (E - V)/m = b/(2 m) (q2^2 - x^2)(x^2 - q1^2), q1^2 + q2^2 = 2 k/b: T = 2 sqrt(2 m/b) K(1 - q1^2/q2^2)/q2."""

import mpmath


def answers(p):
    def omega(A):
        mean = mpmath.sqrt(p["k"] / p["b"] - A**2)
        low, high = mean - A, mean + A
        return mpmath.pi * high / (mpmath.sqrt(2 * p["m"] / p["b"]) * mpmath.ellipk(1 - low**2 / high**2))

    return {"equilibrium[x]": mpmath.sqrt(p["k"] / p["b"]), "omega[1]": mpmath.sqrt(2 * p["k"] / p["m"]),
            "backbone[1](x)(3 cm)": omega(mpmath.mpf("0.03")), "backbone[1](x)(10 cm)": omega(mpmath.mpf("0.1"))}
