"""The place at rest by the cubic's real root (Cardano); the frequency from the slope of the force there, its derivative
by the mass by differences of that.
"""
from math import sqrt


def answers(p):
    k, k3, g = p["k"], p["k3"], p["g"]

    def rest(m):
        half, third = m * g / (2 * k3), k / (3 * k3)
        root = sqrt(half**2 + third**3)
        return (root + half) ** (1 / 3) - (root - half) ** (1 / 3)

    def omega(m):
        return sqrt((k + 3 * k3 * rest(m) ** 2) / m)

    def slope(step):
        return (omega(p["m"] + step) - omega(p["m"] - step)) / (2 * step)

    return {
        "equilibrium[x]": rest(p["m"]),
        "omega[1]": omega(p["m"]),
        "sensitivity[1,m]": (4 * slope(1e-3) - slope(2e-3)) / 3,
        "V[x^2]": (k + 3 * k3 * rest(p["m"]) ** 2) / 2,
        "V[x^3]": k3 * rest(p["m"]),
        "V[x^4]": k3 / 4,
    }
