"""x = -z, y = 0: both springs of an outer block are stretched by x, m x'' + 2 (k x - b x^3) = 0, by quadrature:
T = 4 int_0^A dx/sqrt(2 (E - V)), with x = A sin u."""

import mpmath


def answers(p):
    def omega(A):
        def integrand(u):
            return 1 / mpmath.sqrt(2 * (p["k"] - p["b"] * A**2 * (1 + mpmath.sin(u) ** 2) / 2) / p["m"])

        return mpmath.pi / (2 * mpmath.quad(integrand, [0, mpmath.pi / 2]))

    stretch = mpmath.findroot(lambda d: p["k"] * d - p["b"] * d**3 - 7, 7 / p["k"])
    return {"omega[2]": mpmath.sqrt(2 * p["k"] / p["m"]), "backbone[2](x)(5 cm)": omega(mpmath.mpf("0.05")),
            "backbone[2](z)(A)": omega(p["A"]), "backbone[2](s.force)(7 N)": omega(stretch)}
