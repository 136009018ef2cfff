"""The deflection by bisection of k d + γ d³ = m g; the stiffness is the slope of that force."""
from math import sqrt


def answers(p):
    m, k, gamma, g = (p[n] for n in ("m", "k", "gamma", "g"))
    low, high = 0.0, m * g / k
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if k * middle + gamma * middle**3 < m * g else (low, middle)
    return {"equilibrium[mount.force]": -m * g, "equilibrium[mount.deflection]": -low,
            "omega[1]": sqrt((k + 3 * gamma * low**2) / m)}
