"""V = k (2 L)^2 (cos u - cos a)^2/2 + P L sin u: P = 4 k L (cos u - cos a) tan u, extreme where cos^3 u = cos a."""

import mpmath


def answers(p):
    k, L, c, third = p["k"], p["L"], mpmath.cos(p["alpha"]), mpmath.mpf(1) / 3
    x = 2 * L * (c**third - c)
    steep = (1 - (p["P"] / (4 * k * L)) ** (2 * third)) ** mpmath.mpf("1.5")
    return {"fold[1, P]": 4 * k * L * (1 - c ** (2 * third)) ** mpmath.mpf("1.5"), "fold[1, P](x)": x,
            "fold[1, P](s.force)": -k * x, "fold[1, alpha]": mpmath.acos(steep)}
