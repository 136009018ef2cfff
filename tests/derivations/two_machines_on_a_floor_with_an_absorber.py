"""The harmonic balance of sines and cosines at each speed, real unknowns; means over the angles of the two machines,
which take all pairs of values alike in the long run: by equal steps in both, exact of trigonometric polynomials."""
from math import sqrt

import numpy as np

STEPS = 16


def balance(M, C, K, W, sine, cosine):
    """(a, b) of q = a sin + b cos."""
    D = K - W * W * M
    found = np.linalg.solve(np.block([[D, -W * C], [W * C, D]]), np.concatenate([sine, cosine]))
    return found[:2], found[2:]


def answers(p):
    m1, m2, k1, k2, c1, c2, F1, F2, W1, W2 = (p[n] for n in ("m1", "m2", "k1", "k2", "c1", "c2", "F1", "F2", "Omega1",
                                                             "Omega2"))
    M, nothing = np.diag([m1, m2]), np.zeros(2)
    C, K = (np.array([[a + b, -b], [-b, b]]) for a, b in ((c1, c2), (k1, k2)))
    (a, b), (c, d) = (balance(M, C, K, W1, np.array([F1, 0]), nothing),
                      balance(M, C, K, W2, nothing, np.array([F2, 0])))
    one, two = (grid.ravel() for grid in np.meshgrid(*[2 * np.pi * np.arange(STEPS) / STEPS] * 2))

    def state(order):
        """q, q' or q'' at all pairs of angles."""
        return sum(W**order * (np.outer(part, np.sin(angle + order * np.pi / 2))
                               + np.outer(other, np.cos(angle + order * np.pi / 2)))
                   for W, part, other, angle in ((W1, a, b, one), (W2, c, d, two)))
    (x, y), (v, w), (acceleration, _) = (state(order) for order in range(3))
    return {
        "mean(first.power)": np.mean(F1 * np.sin(one) * v),
        "mean(second.power)": np.mean(F2 * np.cos(two) * v),
        "mean(d1.power)": np.mean(c1 * v**2),
        "mean(d2.power)": np.mean(c2 * (w - v) ** 2),
        "mean(first.power + second.power - d1.power - d2.power)": 0.0,
        "rms(x'')": sqrt(np.mean(acceleration**2)),
        "rms(s2.stretch)": sqrt(np.mean((y - x) ** 2)),
        "mean(s2.stretch^4)": np.mean((y - x) ** 4),
    }
