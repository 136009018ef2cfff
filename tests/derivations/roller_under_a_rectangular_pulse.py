"""Moments about the contact: 3/2 m R^2, spring arm 2 R. The motion by Duhamel's integral of the pulse in quadrature."""
from math import pi, sin, sqrt

from scipy.integrate import quad


def answers(p):
    m, R, k, F0 = (p[n] for n in ("m", "R", "k", "F0"))
    inertia, stiffness = (m * R**2 / 2 + m * R**2) / R**2, k * (2 * R) ** 2 / R**2
    w = sqrt(stiffness / inertia)

    def x(u, length):
        """At the time u/w of a pulse that lasts length/w."""
        return F0 / stiffness * quad(lambda s: sin(u - s), 0, min(u, length), epsabs=1e-13)[0]

    def extreme(length, sense):
        """The residual motion is a sine: its amplitude from two values a quarter apart."""
        residual = sqrt(x(length, length) ** 2 + x(length + pi / 2, length) ** 2)
        within = [x(length * i / 400, length) for i in range(401)]
        return max(residual, *within) if sense > 0 else min(-residual, *within)

    quarter, half, whole = pi / 2, pi, 2 * pi
    return {
        "omega[1]": w,
        "x(t1)": x(quarter, quarter),
        "max(x)": extreme(quarter, 1),
        "argmax(x)": 3 * pi / 4 / w,
        "min(x)": extreme(quarter, -1),
        "max(s.force)": 2 * k * extreme(quarter, 1),
        "half:x(t1)": x(half, half),
        "half:min(x)": extreme(half, -1),
        "half:x(2*t1)": x(2 * half, half),
        "half:max(s.force)": 2 * k * extreme(half, 1),
        "whole:x(t1/2)": x(whole / 2, whole),
        "whole:x(3*t1/2)": clean(x(3 * whole / 2, whole), F0 / stiffness),
        "whole:max(x)": extreme(whole, 1),
        "whole:argmax(x)": pi / w,
        "whole:min(x)": clean(extreme(whole, -1), F0 / stiffness),
    }


def clean(value, scale):
    return 0.0 if abs(value) < 1e-12 * scale else value
