"""Moments about the two hinges; decay and damped frequency as real and imaginary part of the root of the quadratic."""
from cmath import sqrt as csqrt
from math import exp, log, pi


def answers(p):
    M, m, L, c, phi0, g = (p[n] for n in ("M", "m", "L", "c", "phi0", "g"))
    inertia = M * L**2 + 2 * (m * L**2 / 12 + m * L**2 / 4)
    damping = c * (0.4 / 0.5) ** 2 * L**2
    stiffness = M * g * L + 2 * m * g * L / 2
    root = (-damping + csqrt(damping**2 - 4 * inertia * stiffness)) / (2 * inertia)
    decay, wd = -root.real, root.imag
    return {
        "equation[phi]": lambda q, v, a: inertia * a["phi"] + damping * v["phi"] + stiffness * q["phi"],
        "zeta[1]": decay / abs(root),
        "decrement(phi)": decay * 2 * pi / wd,
        "period(phi)": 2 * pi / wd,
        "min(phi)": -phi0 * exp(-decay * pi / wd),
        "time_to[0.1](phi)": log(10) / decay,
        "cycles_to[0.1](phi)": log(10) / (decay * 2 * pi / wd),
        "envelope(phi)(5 s)": phi0 * abs(1 + 1j * decay / wd) * exp(-5 * decay),
    }
