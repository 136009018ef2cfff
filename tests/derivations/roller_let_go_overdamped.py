"""Power balance about the instantaneous centre (3/2 m, the cord at twice the speed); the over-damped motion as the
matrix exponential of the first-order system, its greatest speed by a search on it."""
import numpy as np
from scipy.linalg import expm
from scipy.optimize import minimize_scalar


def answers(p):
    m, k, c, F = (p[n] for n in ("m", "k", "c", "F"))
    inertia, damping = m + m / 2, c * 2**2
    A = np.array([[0, 1], [-k / inertia, -damping / inertia]])

    def state(t):
        return expm(A * t) @ [F / k, 0]

    rates = np.sort(-np.linalg.eigvals(A).real)
    found = minimize_scalar(lambda t: state(t)[1], bounds=(0, 5 / rates[1]), method="bounded", options={"xatol": 1e-12})
    time = np.log(rates[1] / rates[0]) / (rates[1] - rates[0])
    assert abs(found.x - time) < 1e-5 * time
    return {
        "equation[x]": lambda q, v, a: inertia * a["x"] + damping * v["x"] + k * q["x"],
        "zeta[1]": sum(rates) / 2 / np.sqrt(rates[0] * rates[1]),
        "eigenvalue[1,1]": -rates[0],
        "eigenvalue[1,2]": -rates[1],
        "x(0 s)": F / k,
        "x(0.3 s)": state(0.3)[0],
        "min(x')": found.fun,
        "argmin(x')": time,
        "max(d.force)": -2 * c * found.fun,
    }
