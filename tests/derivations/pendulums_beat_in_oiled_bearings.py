"""Sum and difference of the angles are oscillators of one degree, in the difference the spring counting twice: each is
integrated numerically, and its arrow u - i (u' + decay u)/frequency read off the integrated motion."""
from math import pi, sqrt

from scipy.integrate import solve_ivp
from scipy.optimize import brentq


def answers(p):
    m, L, a, k, c, g, phi0 = (p[n] for n in ("m", "L", "a", "k", "c", "g", "phi0"))
    inertia = m * L**2
    decay = c / (2 * inertia)
    speeds = [sqrt((m * g * L + extra) / inertia - decay**2) for extra in (0.0, 2 * k * a * a)]

    def arrows(t):
        found = []
        for w in speeds:
            run = solve_ivp(lambda _, y, w=w: [y[1], -2 * decay * y[1] - (w * w + decay**2) * y[0]], (0, t), [phi0, 0],
                            method="DOP853", rtol=1e-12, atol=1e-14)
            u, v = run.y[:, -1]
            found.append(u - 1j * (v + decay * u) / w)
        return found

    def envelope(t, sense):
        together, opposed = arrows(t)
        return abs(together + sense * opposed) / 2

    def slope(t):
        """Half the rate of |together - opposed|²."""
        together, opposed = arrows(t)
        rates = [complex(-decay, w) for w in speeds]
        return ((together - opposed).conjugate() * (rates[0] * together - rates[1] * opposed)).real
    half = pi / (speeds[1] - speeds[0])
    top = brentq(slope, 0.6 * half, 1.1 * half, xtol=1e-12)
    return {
        "beat_period(phi1)": 2 * half,
        "max(envelope(phi2))": envelope(top, -1),
        "argmax(envelope(phi2))": top,
        "envelope(phi1)(6 s)": envelope(6.0, 1),
        "envelope(phi1)(12 s)": envelope(12.0, 1),
        "envelope(phi2)(12 s)": envelope(12.0, -1),
        "envelope(link.stretch)(12 s)": a * abs(arrows(12.0)[1]),
    }
