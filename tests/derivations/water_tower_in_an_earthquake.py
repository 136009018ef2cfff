"""Moments about the foot in the accelerated ground. Between the points of the record the moment is linear in time and
the motion is a matrix exponential of (turn, rate, moment, its slope); the turn at 1 s and 6 s again by Duhamel's
integral.
"""
import numpy as np
from scipy.integrate import quad
from scipy.linalg import expm
from scipy.optimize import brentq

RECORD = __file__.rpartition("tests")[0] + "problems/5_forced/quake_of_five_seconds.csv"


def answers(p):
    m1, L, m2, kt, ct, g = (p[n] for n in ("m1", "L", "m2", "kt", "ct", "g"))
    J, S = m1 * L**2 / 3 + m2 * L**2, m1 * L / 2 + m2 * L
    K = kt - S * g
    times, ground = np.loadtxt(RECORD, delimiter=",", skiprows=1).T
    A = np.zeros((4, 4))
    A[0, 1], A[1], A[2, 3] = 1, [-K / J, -ct / J, S / J, 0], 1
    slopes = [*(np.diff(ground) / np.diff(times)), 0.0]
    starts, state = [], np.zeros(2)
    for i, time in enumerate(times):
        starts.append(np.array([*state, ground[i], slopes[i]]))
        if i + 1 < len(times):
            state = (expm(A * (times[i + 1] - time)) @ starts[-1])[:2]

    def motion(t):
        i = np.searchsorted(times, t, side="right") - 1
        return expm(A * (t - times[i])) @ starts[i]

    grid = np.arange(0.001, 5, 0.02)
    rates = [motion(t)[1] for t in grid]
    turning = [brentq(lambda t: motion(t)[1], grid[i], grid[i + 1], xtol=1e-13) for i in range(len(grid) - 1)
               if rates[i] * rates[i + 1] < 0]
    high, low = max(turning, key=lambda t: motion(t)[0]), min(turning, key=lambda t: motion(t)[0])
    wn, decay = (K / J) ** 0.5, ct / J / 2
    wd = (wn**2 - decay**2) ** 0.5

    def duhamel(t):
        ends = [*(time for time in times if time < t), min(t, times[-1])]

        def blow(s):
            return S * np.interp(s, times, ground) / (J * wd) * np.exp(-decay * (t - s)) * np.sin(wd * (t - s))

        return sum(quad(blow, ends[i], ends[i + 1], epsabs=1e-14)[0] for i in range(len(ends) - 1))

    assert max(abs(duhamel(t) - motion(t)[0]) for t in (1.0, 6.0)) < 1e-10
    return {
        "K[phi,phi]": K,
        "omega[1]": wn,
        "zeta[1]": decay / wn,
        "max(phi)": motion(high)[0],
        "argmax(phi)": high,
        "min(phi)": motion(low)[0],
        "argmin(phi)": low,
        "phi(1 s)": motion(1.0)[0],
        "phi(6 s)": motion(6.0)[0],
        "max(soil.force)": kt * motion(high)[0],
    }
