"""First turning point by the linear first-order equation that the squared velocity obeys as a function of the angle
(closed by an integrating factor and quadrature); all in time by an eighth-order Runge-Kutta method with events.
"""
import numpy as np
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq


def answers(p):
    m, H, B, d, c2, W, phi0 = (p[n] for n in ("m", "H", "B", "d", "c2", "W", "phi0"))
    J = m * (H**2 + B**2) / 12 + m * H**2 / 4
    drag, weight = c2 * d**3, W * H / 2

    def rates(t, z):
        return [z[1], -(drag * z[1] * abs(z[1]) + weight * np.sin(z[0])) / J]

    events = [lambda t, z: z[1], lambda t, z: z[0], lambda t, z: rates(t, z)[1]]
    run = solve_ivp(rates, (0, 8), [phi0, 0], method="DOP853", rtol=1e-13, atol=1e-15, dense_output=True, events=events,
                    max_step=0.02)
    # going back: d(w^2)/dphi = (2 drag w^2 - 2 weight sin phi)/J
    rate = 2 * drag / J

    def squared(phi):
        return 2 * weight / J * quad(lambda s: np.sin(s) * np.exp(rate * (phi - s)), phi, phi0, epsabs=1e-14)[0]

    other_side = brentq(squared, -phi0, -1e-3, xtol=1e-15)
    turning = run.y_events[0][:, 0][run.t_events[0] > 1e-6]
    assert abs(turning[0] - other_side) < 1e-9
    return {
        "motion[phi]": lambda q, v, a: J * a["phi"] + drag * v["phi"] * abs(v["phi"]) + weight * np.sin(q["phi"]),
        "min(phi)": other_side,
        "argmin(phi)": run.t_events[0][run.t_events[0] > 1e-6][0],
        "max(phi')": max(run.y_events[2][:, 1]),
        "zero[1](phi)": run.t_events[1][0],
        "zero[2](phi)": run.t_events[1][1],
        "phi(3 s)": run.sol(3.0)[0],
    }
