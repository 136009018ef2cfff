"""Virtual work of a displacement along each axis: 2 k2 sin² a = 2 k and k + 2 k2 cos² a = 2 k, by squares added."""
from math import atan, sqrt


def answers(p):
    k = p["k"]
    up, along = 2 * k, k                    # what the two equal springs resist with: 2 k2 sin² a and 2 k2 cos² a
    k2, a = (up + along) / 2, atan(sqrt(up / along))
    omega = sqrt(2 * k / p["m"])
    return {"k2": k2, "a": a, "stiffness[bead].max": 2 * k, "stiffness[bead].min": 2 * k, "omega[1]": omega,
            "omega[2]": omega}
