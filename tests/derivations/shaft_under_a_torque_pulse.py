"""Angular momentum of each disc, integrated by Runge-Kutta on the pulse and behind it, the extremes as events of the
twists' rates. The twists at the end of the pulse again by a matrix exponential, to which the half sine is joined
as an oscillator.
"""
import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import expm


def answers(p):
    J = np.array([p["J1"], p["J2"], p["J3"]])
    k1, k2, c1, c2, M0, t1 = (p[n] for n in ("k1", "k2", "c1", "c2", "M0", "t1"))
    twist = np.array([[-1, 1, 0], [0, -1, 1]])
    k, c = np.array([k1, k2]), np.array([c1, c2])
    A = np.zeros((8, 8))
    A[:3, 3:6] = np.eye(3)
    A[3:6, :3] = -(twist.T * k @ twist) / J[:, None]
    A[3:6, 3:6] = -(twist.T * c @ twist) / J[:, None]
    A[5, 6] = -1 / J[2]
    A[6, 7], A[7, 6] = np.pi / t1, -np.pi / t1
    end = (expm(A * t1) @ [0, 0, 0, 0, 0, 0, 0, M0])[:6]
    free = A[:6, :6]

    def rates(t, z):
        torque = -M0 * np.sin(np.pi * t / t1) if t < t1 else 0.0
        return free @ z + np.array([0, 0, 0, 0, 0, torque / J[2]])

    events = [lambda t, z, row=row: row @ z[3:] for row in twist]
    tight = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-16, "events": events}
    pulse = solve_ivp(rates, (0, t1), np.zeros(6), **tight)
    after = solve_ivp(rates, (t1, 0.3), pulse.y[:, -1], **tight)
    assert np.allclose(pulse.y[:, -1], end, rtol=1e-8, atol=1e-11)
    assert np.allclose(J @ after.y[3:, -1], -2 / np.pi * M0 * t1)

    def least(i):
        return min((k[i] * twist[i] @ z[:3], t) for leg in (pulse, after)
                   for t, z in zip(leg.t_events[i], leg.y_events[i], strict=True) if t > 1e-6)

    inertias = np.diag(J**-0.5)
    squares = np.linalg.eigvalsh(inertias @ (twist.T * k @ twist) @ inertias)
    roots = sorted((root for root in np.linalg.eigvals(free) if root.imag > 1), key=abs)
    (low1, time1), (low2, time2) = least(0), least(1)
    return {
        "omega[1]": 0.0,
        "omega[2]": squares[1] ** 0.5,
        "omega[3]": squares[2] ** 0.5,
        "zeta[2]": -roots[0].real / abs(roots[0]),
        "zeta[3]": -roots[1].real / abs(roots[1]),
        "s1.stretch(t1)": twist[0] @ end[:3],
        "s2.stretch(t1)": twist[1] @ end[:3],
        "min(s1.force)": low1,
        "argmin(s1.force)": time1,
        "min(s2.force)": low2,
        "argmin(s2.force)": time2,
        "theta1'(0.3 s)": after.y[3, -1],
        "(J1*theta1' + J2*theta2' + J3*theta3')(0.2 s)": J @ end[3:],
    }
