"""Energy of the weights by second differences (the spring's preload is linear in the turn); the sawtooth's series,
sines of 2 F0/(n pi), as phasors; the effective value by Parseval's sum, and by the steady motion over one ramp in
closed form.
"""
import numpy as np
from scipy.integrate import quad


def answers(p):
    m, ml, L, beta, kt, c, F0, Omega, g = (p[n] for n in ("m", "ml", "L", "beta", "kt", "c", "F0", "Omega", "g"))
    J = m * L**2 + 2 * ml * L**2 / 3
    h = 1e-3

    def weight(phi):
        return (m + ml) * g * L * np.cos(beta - phi)

    fourth = [weight(i * h) for i in (-2, -1, 0, 1, 2)]
    K = kt - (m + ml) * g * L * np.cos(beta)
    assert abs(kt + np.dot([-1, 16, -30, 16, -1], fourth) / (12 * h**2) - K) < 1e-6 * kt
    C, moment = c * (L * np.cos(beta)) ** 2, F0 * L * np.cos(beta)

    def harmonic(n):
        return 2 * moment / (n * np.pi) / abs(complex(K - J * (n * Omega) ** 2, C * n * Omega))

    period = 2 * np.pi / Omega
    A = np.array([[0, 1], [-K / J, -C / J]])
    roots, shapes = np.linalg.eig(A)
    back = np.linalg.inv(shapes)

    def propagated(t, state):
        return (shapes * np.exp(roots * t) @ back @ state).real

    slope = 2 * moment / period

    def particular(t):
        """Under the moment -moment + slope t."""
        return np.array([(-moment + slope * t - C * slope / K) / K, slope / K])

    step = np.column_stack([propagated(period, unit) for unit in np.eye(2)])
    start = np.linalg.solve(np.eye(2) - step, particular(period) - step @ particular(0))

    def state(t):
        return particular(t) + propagated(t, start - particular(0))

    square = quad(lambda t: state(t)[0] ** 2, 0, period, epsabs=1e-14, limit=200)[0] / period
    series = sum(harmonic(n) ** 2 / 2 for n in range(1, 4000))
    assert abs(square - series) < 1e-8 * square
    wn = (K / J) ** 0.5
    return {
        "M[phi,phi]": J,
        "K[phi,phi]": K,
        "C[phi,phi]": C,
        "omega[1]": wn,
        "zeta[1]": C / (2 * J * wn),
        "harmonic[1](phi)": harmonic(1),
        "harmonic[2](phi)": harmonic(2),
        "harmonic[3](phi)": harmonic(3),
        "rms(phi)": series**0.5,
        "rms(tray.x)": L * np.cos(beta) * series**0.5,
    }
