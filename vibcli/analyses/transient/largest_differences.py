"""Upper bounds of |E[nodes](t)| for many sets of nodes at once: of divided differences of the exponential.

    |E[λ₁…λₘ]| <= e^{max Re λ · t} t^{m−1} / (m−1)!      |E[λ₁…λₘ]| <= (|E[λ₁…λₘ₋₁]| + |E[λ₂…λₘ]|) / |λ₁ − λₘ|
"""

import math
from itertools import combinations

import numpy as np


def largest_differences(nodes: np.ndarray, early: np.ndarray, late: np.ndarray) -> np.ndarray:
    """Bounds on the intervals early <= t <= late (U,) for the rows of nodes (N, m): (N, U)."""
    count = nodes.shape[1]
    top = nodes.real.max(axis=1)[:, None]
    found = np.exp(np.maximum(top * early, top * late)) * (late ** (count - 1) / math.factorial(count - 1))
    if count == 1:
        return found
    pairs = list(combinations(range(count), 2))
    gaps = np.abs(np.stack([nodes[:, i] - nodes[:, j] for i, j in pairs]))
    widest, rows = gaps.argmax(axis=0), np.arange(len(nodes))
    kept = [np.array([[k for k in range(count) if k != pair[side]] for pair in pairs])[widest] for side in (0, 1)]
    apart = sum(largest_differences(nodes[rows[:, None], places], early, late) for places in kept)
    gap = gaps[widest, rows][:, None]
    return np.where(gap > 0, np.minimum(found, apart / np.where(gap > 0, gap, 1.0)), found)
