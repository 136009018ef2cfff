"""Energy of weights and preloaded spring by second differences; the rotating force u W^2 (cos, sin) as a phasor about
the hinge: b sin - e cos = Im((b - i e) exp(i W t)) as the phasor."""
from cmath import phase

import mpmath as mp


def answers(p):
    mb, L, k, c, mm, Jm, b, e, h, u, Omega, g = (
        p[n] for n in ("mb", "L", "k", "c", "mm", "Jm", "b", "e", "h", "u", "Omega", "g"))
    inertia = mb * L**2 / 12 + mb * L**2 / 4 + mm * (b * b + e * e) + Jm
    preload = -(mb * L / 2 + mm * b) * g / L

    def energy(phi):
        length = mp.hypot(L * mp.cos(phi) - L, L * mp.sin(phi) + h) - h
        height = mb * L / 2 * mp.sin(phi) + mm * (b * mp.sin(phi) + e * mp.cos(phi))
        return g * height + preload * length + k * length**2 / 2

    with mp.workdps(30):
        assert abs(mp.diff(energy, 0)) < 1e-9 * k
        stiffness = float(mp.diff(energy, 0, 2))
    damping = c * L**2

    def turn(W):
        return u * W**2 * complex(b, -e) / complex(stiffness - inertia * W**2, damping * W)

    def foot(W):
        return abs(turn(W)) * L * abs(complex(k, c * W))

    wn = (stiffness / inertia) ** 0.5
    decay = damping / inertia / 2
    X = turn(Omega)
    return {
        "M[phi,phi]": inertia,
        "K[phi,phi]": stiffness,
        "zeta[1]": decay / wn,
        "omega_d[1]": (wn**2 - decay**2) ** 0.5,
        "amplitude(phi)": abs(X),
        "phase(phi)": -phase(X),
        "amplitude(motor.x)": e * abs(X),
        "amplitude(motor.y)": b * abs(X),
        "amplitude(s.force + d.force)": foot(Omega),
        "double:amplitude(phi)": abs(turn(60)),
        "double:phase(phi)": -phase(turn(60)),
        "near:amplitude(phi)": abs(turn(50)),
        "near:amplitude(s.force + d.force)": foot(50),
    }
