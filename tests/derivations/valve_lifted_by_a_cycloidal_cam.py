"""Moments about the rocker's pin; the response by Runge-Kutta integration over the lift and after it, the turn at the
end of the lift again by Duhamel's integral; extremes of turn and push-rod force by roots of their rates.
"""
from math import cos, exp, pi, sin, sqrt

import numpy as np
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq


def answers(p):
    J, a, b, mv, kv, c, kp, h, t1 = (p[n] for n in ("J", "a", "b", "mv", "kv", "c", "kp", "h", "t1"))
    inertia, stiffness, damping = J + mv * b**2, kp * a**2 + kv * b**2, c * b**2

    def lift(t):
        return h * (t / t1 - sin(2 * pi * t / t1) / (2 * pi)) if t < t1 else h

    def speed(t):
        return h / t1 * (1 - cos(2 * pi * t / t1)) if t < t1 else 0.0

    def rates(t, z):
        return [z[1], (kp * a * lift(t) - damping * z[1] - stiffness * z[0]) / inertia]

    tight = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-17, "dense_output": True, "max_step": t1 / 80}
    rise = solve_ivp(rates, (0, t1), [0, 0], **tight)
    rest = solve_ivp(rates, (t1, 8 * t1), rise.y[:, -1], **tight)

    def state(t):
        return (rise if t < t1 else rest).sol(t)

    def roots(function):
        grid = np.linspace(1e-3 * t1, 4 * t1, 801)
        values = [function(t) for t in grid]
        return [brentq(function, grid[i], grid[i + 1], xtol=1e-16) for i in range(800)
                if values[i] * values[i + 1] < 0]

    def force(t):
        return kp * (a * state(t)[0] - lift(t))

    top = max(roots(lambda t: state(t)[1]), key=lambda t: state(t)[0])
    pulls = [force(t) for t in roots(lambda t: a * state(t)[1] - speed(t))]
    wn, decay = sqrt(stiffness / inertia), damping / inertia / 2
    wd = sqrt(wn**2 - decay**2)
    duhamel = quad(lambda s: kp * a * lift(s) * exp(-decay * (t1 - s)) * sin(wd * (t1 - s)) / (inertia * wd), 0, t1,
                   epsabs=1e-14, limit=200)[0]
    assert abs(duhamel - state(t1)[0]) < 1e-9
    return {
        "M[phi,phi]": inertia,
        "K[phi,phi]": stiffness,
        "omega[1]": wn,
        "zeta[1]": decay / wn,
        "phi(t1/2)": state(t1 / 2)[0],
        "phi(t1)": state(t1)[0],
        "max(phi)": state(top)[0],
        "argmax(phi)": top,
        "final(phi)": kp * a * h / stiffness,
        "min(rod.force)": min(pulls),
    }
