"""k x = C/(g - x)^2: x (g - x)^2 is largest at x = g/3, 4 g^3/27."""

import mpmath


def answers(p):
    k, g, C = p["k"], p["gap"], p["C"]
    rest = mpmath.findroot(lambda x: k * x * (g - x) ** 2 / C - 1, C / (k * g**2))
    return {"equilibrium[x]": rest, "fold[1, C]": 4 * k * g**3 / 27, "fold[1, C](x)": g / 3,
            "fold[1, k]": 27 * C / (4 * g**3), "fold[1, gap]": mpmath.cbrt(27 * C / (4 * k))}
