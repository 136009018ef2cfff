"""By shooting: a motion from rest passes x = phi = 0 after a quarter of its period, both at once. One of the places at
the start is asked for; the other, and the time, are found."""

import math

import mpmath
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import root


def answers(p):
    M, m, L, k, g = (float(p[name]) for name in ("M", "m", "L", "k", "g"))

    def rates(_, s):
        x, phi, v, w = s
        inertia = [[M + m, m * L * math.cos(phi)], [m * L * math.cos(phi), m * L**2]]
        forces = [m * L * math.sin(phi) * w**2 - k * x, -m * g * L * math.sin(phi)]
        return [v, w, *np.linalg.solve(inertia, forces)]

    def quarter(u, which, amplitude):
        start = np.insert(u[:1], which, amplitude)
        return solve_ivp(rates, (0, u[1]), [*start, 0, 0], method="DOP853", rtol=1e-12, atol=1e-12).y[:2, -1]

    a, b, c = (M + m) * m * L**2 - m**2 * L**2, (M + m) * m * g * L + m * L**2 * k, k * m * g * L
    squares = [(b + sign * math.sqrt(b**2 - 4 * a * c)) / (2 * a) for sign in (-1, 1)]

    def omega(mode, which, amplitude):
        square = squares[mode]
        ratio = m * L * square / (k - (M + m) * square)         # x/phi of the small motion
        other = amplitude * ratio if which else amplitude / ratio
        u, size = np.array([other, math.pi / (2 * math.sqrt(square))]), amplitude
        for share in (0.5, 1):
            found = root(quarter, [u[0] * share * amplitude / size, u[1]], args=(which, share * amplitude), tol=1e-12)
            u, size = found.x, share * amplitude
        assert np.abs(quarter(u, which, amplitude)).max() < 1e-10
        return math.pi / (2 * u[1])

    degree = math.pi / 180
    return {"omega[1]": mpmath.sqrt(squares[0]), "omega[2]": mpmath.sqrt(squares[1]),
            "backbone[1](phi)(40 deg)": omega(0, 1, 40 * degree), "backbone[1](phi)(70 deg)": omega(0, 1, 70 * degree),
            "backbone[2](phi)(40 deg)": omega(1, 1, 40 * degree), "backbone[2](x)(10 cm)": omega(1, 0, 0.1)}
