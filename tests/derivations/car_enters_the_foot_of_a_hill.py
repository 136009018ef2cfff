"""Seen from axes that rise with the road, body and wheel stand under the weights m a downwards: statics for what they
come to, and the motion in these axes from rest integrated numerically."""
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar


def answers(p):
    m1, m2, k1, k2, c1, a = (p[n] for n in ("m1", "m2", "k1", "k2", "c1", "a"))

    def rate(_, s):
        y, z, v, w = s
        push = k1 * (z - y) + c1 * (w - v)
        return [v, w, push / m1 - a, (-push - k2 * z) / m2 - a]

    run = solve_ivp(rate, (0, 3), [0, 0, 0, 0], method="DOP853", rtol=1e-12, atol=1e-15, dense_output=True)

    def pressed(t):
        y, z, _, _ = run.sol(t)
        return z - y

    grid = np.linspace(0, 3, 3001)
    near = grid[np.argmax([pressed(t) for t in grid])]
    top = minimize_scalar(lambda t: -pressed(t), bounds=(near - 0.01, near + 0.01), method="bounded",
                          options={"xatol": 1e-12})
    tyre, suspension = (m1 + m2) * a / k2, m1 * a / k1
    return {
        "final(road.x - z)": tyre,
        "final(z - y)": suspension,
        "final(road.x - y)": tyre + suspension,
        "max(z - y)": pressed(top.x),
        "argmax(z - y)": top.x,
        "steady(y)(0 s)": -(tyre + suspension),
        "steady(y')(2 s)": a * 2,
        "final(road.x' - y')": 0.0,
    }
