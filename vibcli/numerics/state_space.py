"""The first-order form of q̈ + C q̇ + K q = 0."""

import numpy as np


def first_order(K: np.ndarray, C: np.ndarray, rate: float = 1.0) -> np.ndarray:
    """A of ẏ = A y, y = (rate q, q̇)."""
    n = len(K)
    return np.block([[np.zeros((n, n)), rate * np.eye(n)], [-K / rate, -C]])
