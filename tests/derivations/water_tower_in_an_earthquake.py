"""Moments about the foot in the accelerated ground. Between the points of the record the moment is linear in time and
the motion is a matrix exponential of (turn, rate, moment, its slope); the turn at 1 s and 6 s again by Duhamel's
integral.
"""
import numpy as np
from scipy.integrate import quad, solve_ivp
from scipy.linalg import expm

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

    turning = []
    for i, time in enumerate(times):
        end = times[i + 1] - time if i + 1 < len(times) else 1.0
        leg = solve_ivp(lambda t, z: A @ z, (0, end), starts[i], method="DOP853", rtol=1e-12, atol=1e-15,
                        events=lambda t, z: z[1] - 1e-15)
        turning += [(z[0], time + t) for t, z in zip(leg.t_events[0], leg.y_events[0], strict=True)]
    low, high = min(turning), max(turning)
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
        "max(phi)": high[0],
        "argmax(phi)": high[1],
        "min(phi)": low[0],
        "argmin(phi)": low[1],
        "phi(1 s)": motion(1.0)[0],
        "phi(6 s)": motion(6.0)[0],
        "max(soil.force)": kt * high[0],
    }
