"""Critical motion phi = (a + b t) exp(-w t) from the two initial values; its zero, and the least value by a search."""
from math import exp, sqrt

from scipy.optimize import minimize_scalar


def answers(p):
    J, m, R, r, k, phi0, n = (p[name] for name in ("J", "m", "R", "r", "k", "phi0", "n"))
    inertia, stiffness = J + m * R**2, k * r**2
    w = sqrt(stiffness / inertia)
    damping = 2 * inertia * w
    speed = -(1 + n) * w * phi0
    rate = speed + w * phi0

    def phi(t):
        return (phi0 + rate * t) * exp(-w * t)

    crossing = -phi0 / rate
    end = crossing + 1 / w
    least = minimize_scalar(phi, bounds=(crossing, crossing + 5 / w), method="bounded", options={"xatol": 1e-9 / w})
    assert abs(least.x - end) < 1e-6 / w
    return {
        "equation[phi]": lambda q, v, a: inertia * a["phi"] + damping * v["phi"] + stiffness * q["phi"],
        "zeta[1]": damping / (2 * sqrt(inertia * stiffness)),
        "zero[1](phi)": crossing,
        "argmin(phi)": end,
        "min(phi)": least.fun,
    }
