"""Reduced mass from the kinetic energy; the critical motion as Duhamel's answer to the blow M v0: x = v0 t exp(-t/T)
with T = sqrt(M/k), checked to obey the equation of motion by differences; its maximum by golden search.
"""
from math import exp, sqrt

from scipy.optimize import minimize_scalar


def answers(p):
    m, J, r, k, v0 = (p[n] for n in ("m", "J", "r", "k", "v0"))
    reduced = m + J / r / r
    T = sqrt(reduced / k)
    brake = 2 * reduced / T * r**2

    def x(t):
        return v0 * t * exp(-t / T)

    h, t = 1e-4 * T, 0.7 * T
    slope, bend = (x(t + h) - x(t - h)) / (2 * h), (x(t + h) - 2 * x(t) + x(t - h)) / h**2
    assert abs(reduced * bend + brake / r**2 * slope + k * x(t)) < 1e-6 * k * v0 * T
    peak = minimize_scalar(lambda t: -x(t * T), bounds=(0.5, 2), method="bounded", options={"xatol": 1e-9})
    assert abs(peak.x - 1) < 1e-6
    return {
        "ct": brake,
        "max(x)": -peak.fun,
        "argmax(x)": T,
        "x(3*sqrt((m + J/r^2)/k))": x(3 * T),
        "max(recuperator.force)": k * -peak.fun,
    }
