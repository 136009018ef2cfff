"""Free fall for sqrt(2 s0/g), then a part of a harmonic motion about m g/k below, with the amplitude that the energy
gives; the fall again, upwards."""
from math import acos, sqrt


def answers(p):
    m, k, s0, g = (p[n] for n in ("m", "k", "s0", "g"))
    sag, w = m * g / k, sqrt(k / m)
    A = sqrt(sag * sag + 2 * g * s0 / w**2)
    fall, held = sqrt(2 * s0 / g), 2 * acos(-sag / A) / w
    return {"max(y)": s0 + sag + A, "argmax(y)": fall + held / 2, "max(rope.force)": k * (sag + A),
            "period(y)": 2 * fall + held}
