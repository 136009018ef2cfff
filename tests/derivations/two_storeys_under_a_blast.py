"""Newton's law of both girders, integrated by Runge-Kutta on the pulse and behind it, the extremes as events of the
rates; the state at the end of the pulse again by a matrix exponential, to which force and slope are joined.
"""
import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import expm


def answers(p):
    m1, m2, k1, k2, c1, c2, F1, F2, td = (p[n] for n in ("m1", "m2", "k1", "k2", "c1", "c2", "F1", "F2", "td"))
    K, C = np.array([[k1 + k2, -k2], [-k2, k2]]), np.array([[c1 + c2, -c2], [-c2, c2]])
    weights, push = np.array([[m1], [m2]]), np.array([F1, F2])
    free = np.block([[np.zeros((2, 2)), np.eye(2)], [-K / weights, -C / weights]])
    A = np.zeros((6, 6))
    A[:4, :4], A[2:4, 4], A[4, 5] = free, push / weights[:, 0], 1
    end = (expm(A * td) @ [0, 0, 0, 0, 1, -1 / td])[:4]

    def rates(t, z):
        return free @ z + np.concatenate([[0, 0], push / weights[:, 0] * max(1 - t / td, 0)])

    shapes = np.array([[1, 0], [0, 1], [-1, 1]])        # displacements x1 and x2, and the upper storey's drift
    events = [lambda t, z, shape=shape: shape @ z[2:] - 1e-13 for shape in shapes]
    tight = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-15, "events": events}
    pulse = solve_ivp(rates, (0, td), np.zeros(4), **tight)
    after = solve_ivp(rates, (td, 0.7), pulse.y[:, -1], **tight)
    assert np.allclose(pulse.y[:, -1], end, rtol=1e-8, atol=1e-11)

    def extremes(i):
        """(value, time) of the least and the greatest one."""
        found = [(shapes[i] @ z[:2], t) for leg in (pulse, after)
                 for t, z in zip(leg.t_events[i], leg.y_events[i], strict=True) if t > 1e-6]
        return min(found), max(found)

    (back1, top1), (_, top2), (back, top) = extremes(0), extremes(1), extremes(2)
    scale = np.diag(weights[:, 0] ** -0.5)
    squares = np.linalg.eigvalsh(scale @ K @ scale)
    roots = sorted((root for root in np.linalg.eigvals(free) if root.imag > 0), key=abs)
    return {
        "omega[1]": squares[0] ** 0.5,
        "omega[2]": squares[1] ** 0.5,
        "zeta[1]": -roots[0].real / abs(roots[0]),
        "zeta[2]": -roots[1].real / abs(roots[1]),
        "max(x1)": top1[0],
        "argmax(x1)": top1[1],
        "max(x2)": top2[0],
        "argmax(x2)": top2[1],
        "max(s1.force)": k1 * top1[0],
        "min(s1.force)": k1 * back1[0],
        "max(s2.force)": k2 * top[0],
        "min(s2.force)": k2 * back[0],
        "x1(td)": end[0],
        "x2(td)": end[1],
    }
