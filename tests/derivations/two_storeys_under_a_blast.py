"""Newton's law of both girders. The force that falls off joins the state (force, slope), so the motion is one matrix
exponential on the pulse and one behind it; extremes by roots of the rates; the state at the end again by
Runge-Kutta.
"""
import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.optimize import brentq


def answers(p):
    m1, m2, k1, k2, c1, c2, F1, F2, td = (p[n] for n in ("m1", "m2", "k1", "k2", "c1", "c2", "F1", "F2", "td"))
    K, C = np.array([[k1 + k2, -k2], [-k2, k2]]), np.array([[c1 + c2, -c2], [-c2, c2]])
    weights, push = np.array([[m1], [m2]]), np.array([F1, F2])
    free = np.block([[np.zeros((2, 2)), np.eye(2)], [-K / weights, -C / weights]])
    A = np.zeros((6, 6))
    A[:4, :4], A[2:4, 4], A[4, 5] = free, push / weights[:, 0], 1
    end = (expm(A * td) @ [0, 0, 0, 0, 1, -1 / td])[:4]

    def state(t):
        return (expm(A * t) @ [0, 0, 0, 0, 1, -1 / td])[:4] if t < td else expm(free * (t - td)) @ end

    def rates(t, z):
        return free @ z + np.concatenate([[0, 0], push / weights[:, 0] * (1 - t / td)])

    run = solve_ivp(rates, (0, td), np.zeros(4), method="DOP853", rtol=1e-12, atol=1e-15)
    assert np.allclose(run.y[:, -1], end, rtol=1e-8, atol=1e-11)

    def extremes(x):
        grid = np.linspace(1e-3, 0.7, 120)
        values = [x @ state(t)[2:] for t in grid]
        turning = [brentq(lambda t: x @ state(t)[2:], grid[j], grid[j + 1], xtol=1e-15) for j in range(len(grid) - 1)
                   if values[j] * values[j + 1] < 0]
        return [best(turning, key=lambda t: x @ state(t)[:2]) for best in (min, max)]

    first, second, shear = np.array([1, 0]), np.array([0, 1]), np.array([-1, 1])
    (back1, top1), (_, top2), (back, top) = extremes(first), extremes(second), extremes(shear)
    scale = np.diag(weights[:, 0] ** -0.5)
    squares = np.linalg.eigvalsh(scale @ K @ scale)
    roots = sorted((root for root in np.linalg.eigvals(free) if root.imag > 0), key=abs)
    return {
        "omega[1]": squares[0] ** 0.5,
        "omega[2]": squares[1] ** 0.5,
        "zeta[1]": -roots[0].real / abs(roots[0]),
        "zeta[2]": -roots[1].real / abs(roots[1]),
        "max(x1)": state(top1)[0],
        "argmax(x1)": top1,
        "max(x2)": state(top2)[1],
        "argmax(x2)": top2,
        "max(s1.force)": k1 * state(top1)[0],
        "min(s1.force)": k1 * state(back1)[0],
        "max(s2.force)": k2 * shear @ state(top)[:2],
        "min(s2.force)": k2 * shear @ state(back)[:2],
        "x1(td)": end[0],
        "x2(td)": end[1],
    }
