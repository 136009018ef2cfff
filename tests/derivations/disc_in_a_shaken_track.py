"""Newton and Euler for the disc: tangential balance at its centre, moments about it, no slip, friction eliminated."""
from math import cos, sin


def answers(p):
    r, e, X, Omega, g = (p[n] for n in ("r", "e", "X", "Omega", "g"))

    def balance(q, v, a):
        psi, frame = q["psi"], -X * Omega**2 * sin(Omega * q["t"])
        spin = -e / r * a["psi"]
        friction = r * spin / 2                     # per mass, along +psi, acts under the centre: J spin = f r
        return e * a["psi"] + frame * cos(psi) + g * sin(psi) - friction

    swing = X * Omega**2 / (g - (e + e / 2) * Omega**2)
    return {
        "motion[psi]": balance,
        "omega[1]": (g / (e + e / 2)) ** 0.5,
        "amplitude(psi)": abs(swing),
        "amplitude(disc.x)": abs(X + e * swing),
        "amplitude(disc.angle)": e / r * abs(swing),
    }
