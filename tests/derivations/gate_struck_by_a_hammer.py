"""Angular momentum of the blow, energy of weights and spring by second differences; the motion as the impulse response
exp(-d t) sin(wd t)/(J wd), its extremes where tan(wd t) = wd/d."""
from math import atan2, exp, pi, sin, sqrt

import mpmath as mp


def answers(p):
    m, H, m2, k, a, c, d, S, w, g = (p[n] for n in ("m", "H", "m2", "k", "a", "c", "d", "S", "w", "g"))
    J = m * H**2 / 12 + m * H**2 / 4 + m2 * H**2

    def energy(phi):
        stretch = mp.hypot(w + a * mp.sin(phi), a - a * mp.cos(phi)) - w
        return k * stretch**2 / 2 - (m * H / 2 + m2 * H) * g * mp.cos(phi)

    with mp.workdps(30):
        K = float(mp.diff(energy, 0, 2))
    C = c * (d * 0.8) ** 2
    wn, decay = sqrt(K / J), C / J / 2
    wd = sqrt(wn**2 - decay**2)
    A = S * H / (J * wd)

    def phi(t):
        return A * exp(-decay * t) * sin(wd * t)

    first = atan2(wd, decay) / wd
    return {
        "K[phi,phi]": K,
        "C[phi,phi]": C,
        "omega[1]": wn,
        "zeta[1]": decay / wn,
        "max(phi)": phi(first),
        "argmax(phi)": first,
        "min(phi)": phi(first + pi / wd),
        "decrement(phi)": 2 * pi * decay / wd,
        "amplitude(phi)": A,
        "phase(phi)": pi / 2,
        "phi(0.5 s)": phi(0.5),
        "envelope(phi)(1 s)": A * exp(-decay),
    }
