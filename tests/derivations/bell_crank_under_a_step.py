"""Moments about the pin; the step response by Duhamel's integral of the impulse response, in quadrature. A turn > 0
lowers the end of the level arm at the left and presses the spring.
"""
from math import exp, pi, sin, sqrt

from scipy.integrate import quad
from scipy.optimize import minimize_scalar


def answers(p):
    J, a, b, k, F0 = (p[n] for n in ("J", "a", "b", "k", "F0"))
    K, C = k * a * a, sqrt(k * J) * a / (2 * b * b) * b * b
    w = sqrt(K / J)
    ratio = C / (2 * J * w)
    root = sqrt(1 - ratio**2)

    def turn(u):
        """Divided by F0 b/K, at the time u/w."""
        return quad(lambda s: exp(-ratio * s) * sin(root * s) / root, 0, u, epsabs=1e-13, epsrel=1e-12)[0]

    static, first = F0 * b / K, pi / root
    peak = minimize_scalar(lambda u: -turn(u), bounds=(first / 2, first * 1.5), method="bounded",
                           options={"xatol": 1e-8})
    assert abs(peak.x - first) < 1e-5
    return {
        "zeta[1]": ratio,
        "final(phi)": static,
        "max(phi)": static * turn(first),
        "argmax(phi)": first / w,
        "overshoot(phi)": turn(first) - 1,
        "phi(8*pi/(sqrt(15)*w))": static * turn(2 * first),
        "min(s.force)": -k * a * static * turn(first),
    }
