"""Moments about the coupling. The response by Runge-Kutta integration of the two halves (on the bump, behind it) with
dense output, and the state at the end of the bump again by Duhamel's integral."""
import numpy as np
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq


def answers(p):
    L, m, m2, a, k, c, h, b, v, g = (p[n] for n in ("L", "m", "m2", "a", "k", "c", "h", "b", "v", "g"))
    J, K, C, end = m * L**2 / 3 + m2 * L**2, k * a**2, c * a**2, b / v

    def moment(t):
        return a * h * (k * np.sin(np.pi * t / end) + c * np.pi / end * np.cos(np.pi * t / end)) if t < end else 0.0

    def leg(start, stop, state, on):
        def rates(t, z):
            return [z[1], ((moment(t) if on else 0.0) - C * z[1] - K * z[0]) / J]
        return solve_ivp(rates, (start, stop), state, method="DOP853", rtol=1e-12, atol=1e-16, dense_output=True)

    bump = leg(0, end * (1 - 1e-15), [0, 0], True)
    after = leg(end, end + 2, bump.y[:, -1], False)

    def theta(t, i=0):
        return (bump if t < end else after).sol(t)[i]

    def extremes(signal, h=1e-6):
        grid = np.linspace(1e-4, 0.9, 600)
        slopes = [signal(t + h) - signal(t - h) if abs(t - end) > 2 * h else np.nan for t in grid]
        return [brentq(lambda t: signal(t + h) - signal(t - h), grid[i], grid[i + 1], xtol=1e-13)
                for i in range(len(grid) - 1) if slopes[i] * slopes[i + 1] < 0]

    turning = [brentq(lambda t: theta(t, 1), t - 2e-3, t + 2e-3, xtol=1e-14) for t in extremes(theta)]
    high, low = max(turning, key=theta), min(turning, key=theta)

    def stretch(t):
        return a * theta(t) - (h * np.sin(np.pi * t / end) if t < end else 0.0)

    static = -(m * L / 2 + m2 * L) * g / a
    least = min(stretch(t) for t in [*extremes(stretch), end])
    wn, decay = (K / J) ** 0.5, C / J / 2
    wd = (wn**2 - decay**2) ** 0.5
    duhamel = quad(lambda s: moment(s) * np.exp(-decay * (end - s)) * np.sin(wd * (end - s)) / (J * wd), 0, end)[0]
    assert abs(duhamel - theta(end)) < 1e-10
    return {
        "omega[1]": wn,
        "zeta[1]": decay / wn,
        "max(theta)": theta(high),
        "argmax(theta)": high,
        "min(theta)": theta(low),
        "argmin(theta)": low,
        "theta(t1)": theta(end),
        "theta'(t1)": theta(end, 1),
        "min(s.force)": static + k * least,
    }
