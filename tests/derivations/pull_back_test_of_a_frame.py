"""Newton's second law of both girders, integrated by an eighth-order Runge-Kutta method from the pulled shape, and the
same at t1 by the matrix exponential; extremes by events of the integration."""
import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import expm


def answers(p):
    m1, m2, k1, k2, c1, c2, P, t1 = (p[n] for n in ("m1", "m2", "k1", "k2", "c1", "c2", "P", "t1"))

    def rates(_, z):
        x1, x2, v1, v2 = z
        lower, upper = k1 * x1 + c1 * v1, k2 * (x2 - x1) + c2 * (v2 - v1)
        return [v1, v2, (upper - lower) / m1, -upper / m2]

    A = np.column_stack([rates(0, unit) for unit in np.eye(4)])
    start = [P / k1, P / k1 + P / k2, 0, 0]
    events = [lambda t, z: z[3] - 1e-12, lambda t, z: z[3] - z[2] - 1e-12]
    run = solve_ivp(rates, (0, 2), start, method="DOP853", rtol=1e-12, atol=1e-15, events=events)
    least = min(range(len(run.t_events[0])), key=lambda i: run.y_events[0][i][1])
    shear = min(k2 * (z[1] - z[0]) for z in run.y_events[1])
    roots = np.linalg.eigvals(A)
    ratios = -roots[np.argsort(abs(roots))].real / np.sort(abs(roots))
    x1, x2, v1, _ = expm(A * t1) @ start
    return {
        "zeta[1]": ratios[0],
        "zeta[2]": ratios[2],
        "x1(0 s)": start[0],
        "x2(0 s)": start[1],
        "x1(t1)": x1,
        "x2(t1)": x2,
        "(s1.force + d1.force)(t1)": k1 * x1 + c1 * v1,
        "min(x2)": run.y_events[0][least][1],
        "argmin(x2)": run.t_events[0][least],
        "min(s2.force)": shear,
    }
