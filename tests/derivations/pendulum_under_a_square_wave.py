"""Steady motion as the state that changes sign after half a period of constant moment (matrix exponential); harmonics
and effective value by quadrature over a period, the harmonics again as phasors of the square's series 4 M0/(n pi).
"""
import numpy as np
from scipy.integrate import quad


def answers(p):
    m1, L, m2, ct, M0, Omega, g = (p[n] for n in ("m1", "L", "m2", "ct", "M0", "Omega", "g"))
    J = m1 * L**2 / 12 + m1 * L**2 / 4 + m2 * L**2
    K = m1 * g * L / 2 + m2 * g * L
    A = np.array([[0, 1], [-K / J, -ct / J]])
    roots, shapes = np.linalg.eig(A)
    back = np.linalg.inv(shapes)

    def propagated(t, state):
        return (shapes * np.exp(roots * t) @ back @ state).real

    half, rest = np.pi / Omega, np.array([M0 / K, 0])
    step = np.column_stack([propagated(half, unit) for unit in np.eye(2)])
    start = np.linalg.solve(-np.eye(2) - step, rest - step @ rest)

    def state(t):
        turns, within = divmod(t, half)
        return (-1) ** int(turns) * (rest + propagated(within, start - rest))

    def integral(weight):
        return 2 * quad(lambda t: state(t)[0] * weight(t), 0, half * (1 - 1e-15), epsabs=1e-13, epsrel=1e-12)[0]

    def harmonic(n):
        by_series = 4 * M0 / (n * np.pi) / abs(complex(K - J * (n * Omega) ** 2, ct * n * Omega))
        a, b = integral(lambda t: np.cos(n * Omega * t)), integral(lambda t: np.sin(n * Omega * t))
        assert abs(np.hypot(a, b) * Omega / np.pi - by_series) < 1e-9
        return by_series

    wn = (K / J) ** 0.5
    return {
        "M[phi,phi]": J,
        "omega[1]": wn,
        "zeta[1]": ct / (2 * J * wn),
        "harmonic[1](phi)": harmonic(1),
        "harmonic[3](phi)": harmonic(3),
        "harmonic[5](phi)": harmonic(5),
        "rms(phi)": (2 * quad(lambda t: state(t)[0] ** 2, 0, half * (1 - 1e-15), epsabs=1e-13)[0] / (2 * half)) ** 0.5,
        "mean(phi)": 0.0,
        "steady(phi)(2 s)": state(2.0)[0],
        "steady(phi')(2.1 s)": state(2.1)[1],
    }
