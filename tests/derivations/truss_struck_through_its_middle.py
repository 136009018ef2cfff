"""Newton's law of the guided weight, integrated by an Adams-BDF and an eighth-order Runge-Kutta method at tight
tolerances, which must agree; turning points by events."""
import numpy as np
from scipy.integrate import solve_ivp


def answers(p):
    m, k, b, h, c = (p[n] for n in ("m", "k", "b", "h", "c"))
    free = np.hypot(b, h)

    def spring(y):
        length = np.hypot(b, h + y)
        return 2 * k * (length - free) * (h + y) / length

    def run(v, method="DOP853", rtol=1e-13):
        def turns(t, z):
            return z[1]
        return solve_ivp(lambda t, z: [z[1], -(spring(z[0]) + c * z[1]) / m], (0, 0.5), [0, -v], method=method,
                         rtol=rtol, atol=1e-15, dense_output=True, events=turns)

    fast, slow, check = run(p["v"]), run(1.5), run(p["v"], "LSODA", 1e-11)
    assert np.allclose(fast.sol(0.3), check.sol(0.3), rtol=1e-5, atol=1e-6)

    def lowest(found):
        best = min(range(len(found.t_events[0])), key=lambda i: found.y_events[0][i][0])
        return found.y_events[0][best][0], found.t_events[0][best]

    y, rate = fast.sol(0.05)
    return {
        "motion[y]": lambda q, v, a: m * a["y"] + c * v["y"] + spring(q["y"]),
        "min(y)": lowest(fast)[0],
        "argmin(y)": lowest(fast)[1],
        "y(0.05 s)": y,
        "y(0.3 s)": fast.sol(0.3)[0],
        "left.energy(0.05 s)": k * (np.hypot(b, h + y) - free) ** 2 / 2,
        "y'(0.05 s)": rate,
        "slow:min(y)": lowest(slow)[0],
        "slow:argmin(y)": lowest(slow)[1],
        "slow:y(0.3 s)": slow.sol(0.3)[0],
    }
