"""Angular momentum of drum and load; the motion from rest by Duhamel's integral, computed by quadrature."""
from math import pi, sin, sqrt

from scipy.integrate import quad
from scipy.optimize import minimize_scalar


def answers(p):
    J, m, R, r, k, M0 = (p[n] for n in ("J", "m", "R", "r", "k", "M0"))
    inertia, stiffness = J + m * R * R, k * r * r
    w = sqrt(stiffness / inertia)

    def phi(u):
        """At the time u/w."""
        return M0 / stiffness * quad(lambda s: sin(s) * sin(u - s), 0, u, epsabs=1e-13, epsrel=1e-13)[0]

    peak = minimize_scalar(lambda u: -phi(u) / M0 * stiffness, bounds=(2 * pi, 4 * pi), method="bounded",
                           options={"xatol": 1e-8})
    assert abs(peak.x - 3 * pi) < 1e-5
    return {
        "equation[phi]": lambda q, v, a: inertia * a["phi"] + stiffness * q["phi"] - M0 * sin(w * q["t"]),
        "omega[1]": w,
        "phi(pi/Omega)": phi(pi),
        "phi(3*pi/(2*Omega))": phi(3 * pi / 2),
        "phi(2*pi/Omega)": phi(2 * pi),
        "max(phi)": phi(3 * pi),
        "argmax(phi)": 3 * pi / w,
    }
