"""Power of the rope (2 y' at the right strand) and Duhamel's integral of the winch's travel; the force as weight plus
stiffness times (travel - 2 y), its extremes over a fine grid of one period."""
from math import pi, sin, sqrt

import numpy as np
from scipy.integrate import quad


def answers(p):
    m, mp, r, k, v, g = (p[n] for n in ("m", "mp", "r", "k", "v", "g"))
    inertia = m + mp + (mp * r**2 / 2) / r**2
    stiffness = k * 2 * 2
    w = sqrt(stiffness / inertia)

    def y(u):
        """At the time u/w: inertia y'' + 4 k y = 2 k v t."""
        return 2 * k * v / w / stiffness * quad(lambda s: s * sin(u - s), 0, u, epsabs=1e-13, epsrel=1e-13)[0]

    stretch = [v * u / w - 2 * y(u) for u in np.linspace(0, 2 * pi, 41)]
    static = (m + mp) * g / 2
    h = 1e-4
    return {
        "M[y,y]": inertia,
        "K[y,y]": stiffness,
        "omega[1]": w,
        "max(rope.force)": static + k * max(stretch),
        "min(rope.force)": static + k * min(stretch),
        "y(pi/w)": y(pi),
        "y'(pi/w)": w * (8 * (y(pi + h) - y(pi - h)) - y(pi + 2 * h) + y(pi - 2 * h)) / (12 * h),
    }
