"""Newton and Euler for rise and pitch at unit inputs of each wheel, by complex amplitudes; the wheels are added with
the phase by which the rear one follows.
"""
from cmath import exp, phase
from math import pi, sqrt

import numpy as np


def answers(p):
    m, J, a, b, k1, k2, c1, c2 = (p[x] for x in ("m", "J", "a", "b", "k1", "k2", "c1", "c2"))
    W = 2 * pi * p["v"] / p["lam"]
    rear, front = k1 + 1j * W * c1, k2 + 1j * W * c2
    bounce = rear + front - m * W**2
    coupled = b * front - a * rear
    pitch = a**2 * rear + b**2 * front - J * W**2

    def under(push, moment):
        """(y, phi) under a complex force and a moment about the mass centre."""
        below = bounce * pitch - coupled**2
        return (push * pitch - moment * coupled) / below, (moment * bounce - push * coupled) / below

    behind = exp(-1j * W * (a + b) / p["v"])
    y, phi = (p["Y"] * (one + behind * two) for one, two in zip(under(front, b * front), under(rear, -a * rear),
                                                               strict=True))
    both = b * k2 - a * k1
    still = np.linalg.eigvals([[(k1 + k2) / m, both / m], [both / J, (a**2 * k1 + b**2 * k2) / J]])
    return {
        "omega[1]": sqrt(min(still)),
        "omega[2]": sqrt(max(still)),
        "amplitude(y)": abs(y),
        "phase(y)": -phase(y),
        "amplitude(phi)": abs(phi),
        "phase(phi)": -phase(phi),
    }
