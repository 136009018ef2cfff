"""The quartic |λ² m + λ C + K| = 0 of the force of the dashpot along its own line, solved by companion roots."""
from math import cos, sin

import numpy as np


def answers(p):
    m, k1, k2, c, a = (p[n] for n in ("m", "k1", "k2", "c", "a"))
    first = np.array([m, c * cos(a) ** 2, k1])
    second = np.array([m, c * sin(a) ** 2, k2])
    mixed = np.array([c * sin(a) * cos(a), 0.0])
    found = np.roots(np.polysub(np.polymul(first, second), np.polymul(mixed, mixed)))
    oscillating = sorted((x for x in found if x.imag > 0), key=abs)
    return {"damping[p].max": c, "damping[p].min": 0.0, "damping[p].angle": a, "stiffness[p].max": k1,
            "stiffness[p].angle": 0.0, "zeta[1]": -oscillating[0].real / abs(oscillating[0]),
            "zeta[2]": -oscillating[1].real / abs(oscillating[1]), "omega_d[1]": oscillating[0].imag,
            "omega_d[2]": oscillating[1].imag}
