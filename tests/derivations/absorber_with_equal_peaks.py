"""Amplitude of the slab in Den Hartog's real form (squares of the parts with and without the damper); the two peaks by
searches between its fixed points' neighbourhoods, their difference closed by bisection over the spring."""
import numpy as np
from scipy.optimize import brentq, minimize_scalar


def answers(p):
    m1, k1, m2, c2, F0, Omega = (p[n] for n in ("m1", "k1", "m2", "c2", "F0", "Omega"))

    def receptance(W, k2):
        s, w = W * W, c2 * W
        top = (k2 - m2 * s) ** 2 + w * w
        bottom = ((k1 - m1 * s) * (k2 - m2 * s) - k2 * m2 * s) ** 2 + w * w * (k1 - (m1 + m2) * s) ** 2
        return np.sqrt(top / bottom)

    def peaks(k2):
        grid = np.linspace(15, 45, 3001)
        values = receptance(grid, k2)
        tops = [grid[i] for i in range(1, 3000) if values[i] > values[i - 1] and values[i] >= values[i + 1]]
        assert len(tops) == 2
        return [brentq(slope, x - 0.02, x + 0.02, args=(k2,), xtol=1e-12) for x in tops]

    def slope(W, k2, h=1e-3):
        """Derivative of the logarithm, fourth order."""
        ends = [np.log(receptance(W + i * h, k2)) for i in (-2, -1, 1, 2)]
        return np.dot([1, -8, 8, -1], ends)

    def difference(k2):
        low, high = peaks(k2)
        return np.log(receptance(low, k2) / receptance(high, k2))

    k2 = brentq(difference, 44e3, 51e3, xtol=1e-7, rtol=1e-13)
    low, high = peaks(k2)
    best = minimize_scalar(lambda W: -receptance(W, k2), bounds=(low - 0.5, low + 0.5), method="bounded")
    assert abs(-best.fun / receptance(high, k2) - 1) < 1e-8
    M, K = np.diag([m1, m2]), np.array([[k1 + k2, -k2], [-k2, k2]])
    C = c2 * np.array([[1, -1], [-1, 1]])
    A = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    roots = sorted((root for root in np.linalg.eigvals(A) if root.imag > 0), key=abs)
    x1, x2 = np.linalg.solve(K - Omega**2 * M + 1j * Omega * C, [F0, 0])
    return {
        "k2": k2,
        "peak[1](frf[x1, drive]).Omega": low,
        "peak[2](frf[x1, drive]).Omega": high,
        "peak[1](frf[x1, drive]).value": receptance(low, k2),
        "zeta[1]": -roots[0].real / abs(roots[0]),
        "zeta[2]": -roots[1].real / abs(roots[1]),
        "amplitude(x1)": abs(x1),
        "amplitude(tuned.stretch)": abs(x2 - x1),
    }
