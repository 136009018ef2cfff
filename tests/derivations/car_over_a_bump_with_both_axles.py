"""Newton and Euler from the forces of both axles, integrated by Runge-Kutta from corner to corner of the bumps;
extremes by roots of the rates. Values at 0.3 s again by Duhamel's integral with the eigensolutions.
"""
import numpy as np
from scipy.integrate import quad_vec, solve_ivp
from scipy.optimize import brentq


def answers(p):
    m, i, a, b, k1, c1, k2, c2, v, h, L = (
        p[n] for n in ("m", "i", "a", "b", "k1", "c1", "k2", "c2", "v", "h", "L"))
    on, later = L / v, (a + b) / v
    arms, k, c = np.array([[1, a], [1, -b]]), np.array([k1, k2]), np.array([c1, c2])
    M = np.diag([m, m * i * i])
    K, C = arms.T * k @ arms, arms.T * c @ arms
    A = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])

    def road(t):
        """Height and rate under both axles."""
        since = np.array([t, t - later])
        there = (since > 0) & (since < on)
        return h * np.sin(np.pi * since / on) * there, h * np.pi / on * np.cos(np.pi * since / on) * there

    def load(t):
        height, rate = road(t)
        return np.concatenate([[0, 0], np.linalg.solve(M, arms.T @ (k * height + c * rate))])

    corners, legs, state = [0, on, later, later + on, 4.0], [], np.zeros(4)
    for j in range(4):
        start, end = corners[j] + 1e-13, corners[j + 1] - 1e-13
        legs.append(solve_ivp(lambda t, z, s=start, e=end: A @ z + load(min(max(t, s), e)), corners[j:j + 2], state,
                              method="DOP853", rtol=1e-12, atol=1e-16, dense_output=True, max_step=0.02))
        state = legs[-1].y[:, -1]

    def motion(t):
        return legs[max(j for j in range(4) if corners[j] <= t)].sol(t)

    def extremes(index):
        grid = np.linspace(1e-3, 1.5, 401)
        rates = [motion(t)[index + 2] for t in grid]
        return [brentq(lambda t: motion(t)[index + 2], grid[j], grid[j + 1], xtol=1e-15) for j in range(400)
                if rates[j] * rates[j + 1] < 0]

    spans = [(corners[j], min(corners[j + 1], 0.3)) for j in range(4) if corners[j] < 0.3]
    roots, shapes = np.linalg.eig(A)
    back = np.linalg.inv(shapes)
    duhamel = sum(quad_vec(lambda s: (shapes * np.exp(roots * (0.3 - s)) @ back @ load(s)).real,
                           s + 1e-14, e - 1e-14, epsabs=1e-11)[0]
                  for s, e in spans)
    assert np.allclose(duhamel, motion(0.3), rtol=1e-8, atol=1e-11)
    squares = np.sort(np.linalg.eigvals(np.linalg.solve(M, K)))
    roots = sorted((root for root in np.linalg.eigvals(A) if root.imag > 0), key=abs)
    rise = max(extremes(0), key=lambda t: motion(t)[0])
    pitch = sorted(extremes(1), key=lambda t: motion(t)[1])
    return {
        "K[y,phi]": K[0, 1],
        "omega[1]": squares[0] ** 0.5,
        "omega[2]": squares[1] ** 0.5,
        "zeta[1]": -roots[0].real / abs(roots[0]),
        "zeta[2]": -roots[1].real / abs(roots[1]),
        "max(y)": motion(rise)[0],
        "argmax(y)": rise,
        "max(phi)": motion(pitch[-1])[1],
        "argmax(phi)": pitch[-1],
        "min(phi)": motion(pitch[0])[1],
        "argmin(phi)": pitch[0],
        "y(0.3 s)": motion(0.3)[0],
        "phi(0.3 s)": motion(0.3)[1],
        "y'(t2)": motion(later)[2],
    }
