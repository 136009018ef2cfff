"""T = (M + m) x'^2/2 + m cos(beta) x' s' + 3/4 m s'^2; the quadratic in omega^2, and the mode from its first line."""
from math import cos, sin, sqrt


def answers(p):
    M, m, beta, k1, k2, g = (p[n] for n in ("M", "m", "beta", "k1", "k2", "g"))
    a, b, d = M + m, m * cos(beta), 1.5 * m
    det = a * d - b * b
    mean, product = (a * k2 + d * k1) / det, k1 * k2 / det
    root = sqrt(mean * mean / 4 - product)
    low, high = mean / 2 - root, mean / 2 + root
    return {"equilibrium[s]": -m * g * sin(beta) / k2, "omega[1]": sqrt(low), "omega[2]": sqrt(high),
            "mode[2][s]": (k1 - a * high) / (b * high)}
