"""Moment of momentum of the ring in space: J chi'' = -kt (chi - phi) - ct (chi' - phi'), theta = chi - phi.

Complex amplitudes of exp(i Omega t); the angle in space first, what is recorded by the difference.
"""
from cmath import phase
from math import sqrt


def answers(p):
    J, kt, ct, Phi, Omega = (p[n] for n in ("J", "kt", "ct", "Phi", "Omega"))
    link = complex(kt, ct * Omega)
    ring = Phi * link / (link - J * Omega**2)
    recorded = ring - Phi
    w = sqrt(kt / J)
    return {
        "omega[1]": w,
        "zeta[1]": ct / J / 2 / w,
        "amplitude(theta)": abs(recorded),
        "phase(theta)": -phase(recorded),
        "amplitude(ring.angle)": abs(ring),
        "amplitude(spiral.force)": kt * abs(recorded),
    }
