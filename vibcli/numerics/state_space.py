"""The first-order form of q̈ + C q̇ + K q = 0."""

import numpy as np


def first_order(K: np.ndarray, C: np.ndarray, rate: float = 1.0) -> np.ndarray:
    """A of ẏ = A y, y = (rate q, q̇)."""
    n = len(K)
    A = np.zeros((2 * n, 2 * n), dtype=np.result_type(K, C, float))
    A[range(n), range(n, 2 * n)] = rate
    A[n:, :n], A[n:, n:] = -K / rate, -C
    return A
