"""The two weights as equal oscillators (m/2, k) coupled by the middle spring (a quarter of k0 on the sum of both); free
motion by the matrix exponential from one displaced weight."""
import numpy as np
from scipy.linalg import expm


def answers(p):
    m, a, k, k0, y0 = (p[n] for n in ("m", "a", "k", "k0", "y0"))
    stiffness = np.array([[k + k0 / 4, k0 / 4], [k0 / 4, k + k0 / 4]])
    squares = np.linalg.eigvalsh(2 / m * stiffness)
    w1, w2 = np.sqrt(squares)
    A = np.block([[np.zeros((2, 2)), np.eye(2)], [-2 / m * stiffness, np.zeros((2, 2))]])

    def weights(t):
        """Right and left one."""
        return (expm(A * t) @ [y0, 0, 0, 0])[:2]

    half = np.pi / (w2 - w1)
    right, left = weights(half)
    assert abs(right) < 1e-8 * y0
    return {
        "M[phi,phi]": 2 * m / 2 * a**2,
        "K[x,x]": np.array([1, 1]) @ stiffness @ [1, 1],
        "omega[1]": w1,
        "omega[2]": w2,
        "beat_period(right.y)": 2 * np.pi / (w2 - w1),
        "right.y(t1)": 0.0,
        "left.y(t1)": left,
        "right.y(2*t1)": weights(2 * half)[0],
        "phi(pi/w1)": (np.array([1, -1]) / (2 * a)) @ weights(np.pi / w1),
    }
