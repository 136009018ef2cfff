"""Moments about the moving pin with the fictitious force of the carriage; momentum of rod and disc."""
from math import sin


def answers(p):
    m1, m2, L, r, X, Omega, g = (p[n] for n in ("m1", "m2", "L", "r", "X", "Omega", "g"))
    J = m1 * L**2 / 12 + m1 * (L / 2) ** 2 + m2 * r**2 / 2 + m2 * L**2
    S = m1 * L / 2 + m2 * L

    def moments(q, v, a):
        fictitious = X * Omega**2 * sin(Omega * q["t"])
        return J * a["phi"] + S * g * q["phi"] - S * fictitious

    phi = S * X * Omega**2 / (S * g - J * Omega**2)
    momentum = m1 * (X + L / 2 * phi) + m2 * (X + L * phi)
    return {
        "M[phi,phi]": J,
        "equation[phi]": moments,
        "amplitude(phi)": abs(phi),
        "amplitude(disc.x)": abs(X + L * phi),
        "amplitude((m1/2*(disc.x + carriage.x) + m2*disc.x)*Omega^2)": Omega**2 * abs(momentum),
    }
