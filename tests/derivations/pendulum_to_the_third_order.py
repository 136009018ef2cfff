"""m l² φ̈ + m g l (φ − φ³/6) = 0: the softening oscillator of Duffing, φ = a sn, by the complete elliptic integral."""
from mpmath import ellipk, mpf, sqrt


def answers(p):
    m, length, g, a = (mpf(p[name]) for name in ("m", "l", "g", "a"))
    stiffness = m * g * length
    modulus = (a**2 / 12) / (1 - a**2 / 12)
    rate = sqrt(g / length * (1 - a**2 / 12))
    return {"V[phi^2]": float(stiffness / 2), "V[phi^4]": float(-stiffness / 24), "V[phi^3]": 0.0,
            "period(phi)": float(4 * ellipk(modulus) / rate)}
