"""Numerical differences of the potential energy of particle and spring.

V(phi) = m g y + N (l - l0) + k (l - l0)^2/2 with the length l of the spring measured between its ends. Both the slope
at the drawn position, linear in N, and the curvature there, linear in k, are set to what is asked.
"""
from mpmath import cos, diff, hypot, mp, mpf, sin, sqrt

mp.dps = 30
WEAK = {"a": 0.4, "b": 0.2, "s": 0.3, "h": 0.1, "g": 9.81, "N": 25.0, "k": 2000.0}


def shapes(p):
    """Height of the particle, stretch of the spring, and half its square, as functions of phi."""
    a, b, s, h = (mpf(p[key]) for key in "absh")

    def stretch(phi):
        return hypot(s - b * sin(phi), b + h - b * cos(phi)) - hypot(s, h)

    return lambda phi: a * sin(phi), stretch, lambda phi: stretch(phi) ** 2 / 2


def slopes(p, order):
    return [diff(function, 0, order) for function in shapes(p)]


def answers(p):
    lift, pull, _ = slopes(WEAK, 1)
    m = -WEAK["N"] * pull / (WEAK["g"] * lift)
    bend = sum(x * y for x, y in zip((m * WEAK["g"], WEAK["N"], WEAK["k"]), slopes(WEAK, 2), strict=True))
    out = {"weak: m": float(m), "weak: omega[1]": float(sqrt(bend / (m * mpf(WEAK["a"]) ** 2)))}
    lift, pull, _ = slopes(p, 1)
    N = -p["m"] * p["g"] * lift / pull
    raised, bent, squared = slopes(p, 2)
    k = (p["m"] * (p["a"] * p["w"]) ** 2 - p["m"] * p["g"] * raised - N * bent) / squared
    return out | {"N": float(N), "k": float(k),
                  "equation[phi]": lambda q, v, a: a["phi"] + p["w"] ** 2 * q["phi"]}
