"""Phasors of both walls are added before the block's equation is solved; the start by quadrature of Duhamel's integral,
with the free vibration of the initial values.
"""
from cmath import exp, phase
from math import cos, sin, sqrt
from math import exp as real_exp

from scipy.integrate import quad


def answers(p):
    m, k1, k2, c, Y1, Y2, W, psi = (p[x] for x in ("m", "k1", "k2", "c", "Y1", "Y2", "W", "psi"))
    wall = Y2 * exp(1j * psi)
    X = (k1 * Y1 + (k2 + 1j * W * c) * wall) / (k1 + k2 - m * W**2 + 1j * W * c)
    omega, delta, T = sqrt((k1 + k2) / m), c / (2 * m), 0.8
    rate = sqrt(omega**2 - delta**2)

    def push(t):
        return k1 * Y1 * sin(W * t) + k2 * Y2 * sin(W * t + psi) + c * W * Y2 * cos(W * t + psi)

    def free(t):
        return real_exp(-delta * t) * (p["x0"] * cos(rate * t) + (delta * p["x0"] - p["v0"]) / rate * sin(rate * t))

    driven, _ = quad(lambda s: push(s) * real_exp(-delta * (T - s)) * sin(rate * (T - s)) / (m * rate), 0, T,
                     epsabs=1e-15, epsrel=1e-12)
    return {
        "omega[1]": omega,
        "zeta[1]": delta / omega,
        "amplitude(x)": abs(X),
        "phase(x)": -phase(X),
        "amplitude(s1.force)": k1 * abs(X - Y1),
        "amplitude(s2.force + d.force)": abs((k2 + 1j * W * c) * (wall - X)),
        "x(0.8 s)": free(T) + driven,
    }
