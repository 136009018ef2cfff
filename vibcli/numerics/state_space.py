"""The first-order form of q̈ + C q̇ + K q = 0."""

import numpy as np


def first_order(K, C, rate=1.0):
    """A of ẏ = A y, y = (rate q, q̇)."""
    n = len(K)
    return np.block([[np.zeros((n, n)), rate * np.eye(n)], [-K / rate, -C]])
