"""Moments over the half disc in polar coordinates by quadrature; the decaying motion as Re(a exp(s t)) with the complex
root s of the characteristic equation."""
from cmath import exp, sqrt
from math import log, pi

from mpmath import cos, quad


def answers(p):
    m, R, phi0, g, c = (p[n] for n in ("m", "R", "phi0", "g", "c"))
    area = pi * R**2 / 2
    e = float(quad(lambda r: r * r, [0, R]) * quad(cos, [-pi / 2, pi / 2])) / area
    J = m / area * float(quad(lambda r: r**3 * pi, [0, R]))
    C, K = c * R**2, m * g * e
    s = (-C + sqrt(C**2 - 4 * J * K)) / (2 * J)
    a = phi0 * (1 - 1j * s.real / -s.imag)

    def phi(t):
        return (a * exp(s * t)).real

    assert abs((a * s).real) < 1e-9 * abs(a * s)
    half = pi / s.imag
    return {
        "equation[phi]": lambda q, v, acc: J * acc["phi"] + C * v["phi"] + K * q["phi"],
        "zeta[1]": -s.real / abs(s),
        "decrement(phi)": log(phi(0) / phi(2 * half)),
        "min(phi)": phi(half),
        "argmin(phi)": half,
        "time_to[0.5](phi)": log(2) / -s.real,
        "phi(2*pi*sqrt(3*pi*R/(8*g)))": phi(2 * pi / abs(s)),
    }
