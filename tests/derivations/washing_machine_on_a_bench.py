"""Stiffness between tub and housing by second differences of the inclined springs' energy (force law with preload) in
30 digits; forced amplitudes by an impedance chain: the tub is driven through the loop of housing and bench.
"""
from cmath import phase

import mpmath as mp
import numpy as np


def answers(p):
    m1, m2, k1, b, c1, k2, c2, u, g = (p[n] for n in ("m1", "m2", "k1", "b", "c1", "k2", "c2", "u", "g"))
    preload = m1 * g / 2 / 0.8

    def energy(z):
        stretch = mp.hypot(3 * b / 5, 4 * b / 5 - z) - b
        return 2 * (preload * stretch + k1 * stretch**2 / 2) + m1 * g * z

    with mp.workdps(30):
        assert abs(mp.diff(energy, 0)) < 1e-10 * m1 * g
        inner = float(mp.diff(energy, 0, 2))

    def steady(W):
        """Complex amplitudes of tub, housing and ground force."""
        link, foot = complex(inner, c1 * W), complex(k2, c2 * W)
        below = foot - m2 * W**2
        series = link * below / (link + below)
        y1 = u * W**2 / (series - m1 * W**2)
        y2 = y1 * link / (link + below)
        return y1, y2, foot * y2

    masses, stiffness = np.diag([m1, m2]), np.array([[inner, -inner], [-inner, inner + k2]])
    damping = np.array([[c1, -c1], [-c1, c1 + c2]])
    squares = np.sort(np.linalg.eigvals(np.linalg.solve(masses, stiffness)))
    first = np.block([[np.zeros((2, 2)), np.eye(2)],
                      [-np.linalg.solve(masses, stiffness), -np.linalg.solve(masses, damping)]])
    roots = sorted((root for root in np.linalg.eigvals(first) if root.imag > 0), key=abs)
    y1, y2, ground = steady(p["Omega"])
    resonant, rising = steady(14), steady(45)
    return {
        "omega[1]": squares[0] ** 0.5,
        "omega[2]": squares[1] ** 0.5,
        "zeta[1]": -roots[0].real / abs(roots[0]),
        "zeta[2]": -roots[1].real / abs(roots[1]),
        "amplitude(y1)": abs(y1),
        "phase(y1)": -phase(y1),
        "amplitude(y2)": abs(y2),
        "phase(y2)": -phase(y2),
        "amplitude(ground.force.y)": abs(ground),
        "resonant:amplitude(y1)": abs(resonant[0]),
        "resonant:amplitude(y2)": abs(resonant[1]),
        "running_up:amplitude(y1)": abs(rising[0]),
        "running_up:amplitude(y2)": abs(rising[1]),
        "running_up:amplitude(ground.force.y)": abs(rising[2]),
    }
