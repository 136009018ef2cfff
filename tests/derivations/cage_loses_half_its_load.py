"""Angular momentum about the axle; free motion as the sum of two eigensolutions from the turn under the lost weight.

A turn phi > 0 (counter-clockwise) lowers the cage at the left by R phi and raises the counterweight by r phi."""
import numpy as np
from scipy.optimize import minimize_scalar


def answers(p):
    J, m1, m2, R, r, kt, c, G = (p[n] for n in ("J", "m1", "m2", "R", "r", "kt", "c", "G"))
    inertia, damping = J + m1 * R**2 + m2 * r**2, c * r**2
    A = np.array([[0, 1], [-kt / inertia, -damping / inertia]])
    roots, shapes = np.linalg.eig(A)
    back = np.linalg.inv(shapes)

    start = np.array([G * R / kt, 0])

    def state(t):
        return (shapes * np.exp(roots * t) @ back @ start).real

    root = roots[0]
    period = 2 * np.pi / abs(root.imag)
    least = minimize_scalar(lambda t: state(t)[0], bounds=(0, period), method="bounded", options={"xatol": 1e-12})
    return {
        "M[phi,phi]": inertia,
        "C[phi,phi]": damping,
        "zeta[1]": -root.real / abs(root),
        "phi(0 s)": start[0],
        "max(y)": -R * least.fun,
        "period(phi)": period,
        "y(1 s)": -R * state(1.0)[0],
        "z(1 s)": r * state(1.0)[0],
        "decrement(y)": -root.real * period,
    }
