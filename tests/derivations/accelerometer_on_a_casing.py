"""Relative motion z = y - Y of the mass: m z'' + c z' + k z = -m Y''; complex amplitudes, the peak by a search."""
from cmath import phase
from math import pi, sqrt

from scipy.optimize import brentq


def answers(p):
    m, k, c, Y, Omega = (p[n] for n in ("m", "k", "c", "Y", "Omega"))

    def stretch(W):
        """The casing's displacement minus the mass's, by the casing's; where the spring's upper end is the casing."""
        return -(m * W**2) / complex(k - m * W**2, c * W)

    w = sqrt(k / m)
    h = w * 1e-4
    top = brentq(lambda W: abs(stretch(W + h)) - abs(stretch(W - h)), w, 4 * w, xtol=1e-12 * w)
    exact = w / sqrt(1 - c**2 / (2 * k * m))
    assert abs(top - exact) < 1e-6 * w
    X = Y * stretch(Omega)
    return {
        "omega[1]": w,
        "zeta[1]": c / m / 2 / w,
        "amplitude(s.stretch)": abs(X),
        "phase(s.stretch)": -phase(X),
        "abs(frf[s.stretch, S](40 Hz))": abs(stretch(80 * pi)),
        "abs(frf[s.stretch, S](100 Hz))": abs(stretch(200 * pi)),
        "abs(frf[s.stretch, S](300 Hz))": abs(stretch(600 * pi)),
        "abs(frf[s.stretch, S](40 Hz))*k/m/(80*pi*1 rad/s)^2": abs(stretch(80 * pi)) * w**2 / (80 * pi) ** 2,
        "peak[1](frf[s.stretch, S]).Omega": exact,
        "peak[1](frf[s.stretch, S]).value": abs(stretch(exact)),
    }
