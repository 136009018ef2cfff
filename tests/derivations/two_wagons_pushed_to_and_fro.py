"""The centre of mass moves by itself under the whole force, F/m (t/W − sin(W t)/W²) from rest; the distance of the
wagons is one oscillator with the reduced mass, solved by its complex amplitude and its free part.
"""
from cmath import exp
from math import cos, sin, sqrt


def answers(p):
    m1, m2, k, c, F, W = (p[x] for x in ("m1", "m2", "k", "c", "F", "W"))
    whole, reduced, t = m1 + m2, m1 * m2 / (m1 + m2), 1.3
    # d = y − x:  reduced d'' + c d' + k d = −F sin(W t) m2/whole
    D = -F * m2 / whole / (k - reduced * W**2 + 1j * c * W)
    d0, v0 = -p["x0"] - D.imag, p["v0"] - (1j * W * D).imag
    delta = c / (2 * reduced)
    rate = sqrt(k / reduced - delta**2)
    apart = (D * exp(1j * W * t)).imag + exp(-delta * t).real * (
        d0 * cos(rate * t) + (v0 + delta * d0) / rate * sin(rate * t))
    centre = (m1 * p["x0"] + m2 * p["v0"] * t + F * (t / W - sin(W * t) / W**2)) / whole
    return {
        "omega[1]": 0.0,
        "omega[2]": sqrt(k / reduced),
        "zeta[2]": delta * sqrt(reduced / k),
        "amplitude(s.stretch)": abs(D),
        "x(1.3 s)": centre - m2 / whole * apart,
        "y(1.3 s)": centre + m1 / whole * apart,
    }
