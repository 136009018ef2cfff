"""T = 4 int_0^A sqrt((1 + x^2/R^2)/(g/R)) / sqrt(A^2 - x^2) dx = 4 sqrt(R/g) E(-A^2/R^2), E complete elliptic."""

import mpmath


def answers(p):
    period = 4 * mpmath.sqrt(p["R"] / p["g"]) * mpmath.ellipe(-p["A"] ** 2 / p["R"] ** 2)
    return {"omega[1]": mpmath.sqrt(p["g"] / p["R"]), "backbone[1](x)(A)": 2 * mpmath.pi / period}
