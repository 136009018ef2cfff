"""By the inclination alone: A is a chord of the bowl away from the rim, 2r cos th; V and T by it, differentiated by
mpmath. The rest fulfils 4r cos 2th = 2a cos th, a quadratic in cos th."""
from math import acos, sqrt

import mpmath


def answers(p):
    m, r, a, g = (p[n] for n in ("m", "r", "a", "g"))
    cosine = (a + sqrt(a * a + 32 * r * r)) / (8 * r)
    rest = acos(cosine)

    def height(th):
        return -r * mpmath.sin(2 * th) + a * mpmath.sin(th)

    def across(th):
        return -r * mpmath.cos(2 * th) + a * mpmath.cos(th)

    assert abs(mpmath.diff(height, rest)) < 1e-12
    inertia = m * (mpmath.diff(height, rest) ** 2 + mpmath.diff(across, rest) ** 2) + m * (2 * a) ** 2 / 12
    return {"beta": rest,
            "omega[1]": float(mpmath.sqrt(m * g * mpmath.diff(height, rest, 2) / inertia))}
