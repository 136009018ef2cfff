"""Upper bounds of |E[nodes](t)| for many sets of nodes at once: of divided differences of the exponential.

    |E[λ₁…λₘ]| <= e^{max Re λ · t} t^{m−1} / (m−1)!      |E[λ₁…λₘ]| <= (|E[λ₁…λₘ₋₁]| + |E[λ₂…λₘ]|) / |λ₁ − λₘ|
"""

import math
from functools import lru_cache
from itertools import combinations

import numpy as np


def largest_differences(nodes: np.ndarray, early: np.ndarray, late: np.ndarray) -> np.ndarray:
    """Bounds on the intervals early <= t <= late (U,) for the rows of nodes (N, m): (N, U)."""
    count = nodes.shape[1]
    top = nodes.real.max(axis=1)[:, None]
    found: np.ndarray = np.exp(np.maximum(top * early, top * late)) * (late ** (count - 1) / math.factorial(count - 1))
    if count == 1:
        return found
    one, other, left = _pairs(count)
    gaps = np.abs(nodes[:, one] - nodes[:, other])
    widest, rows = gaps.argmax(axis=1), np.arange(len(nodes))
    apart = sum(largest_differences(nodes[rows[:, None], places[widest]], early, late) for places in left)
    gap = gaps[rows, widest][:, None]
    result: np.ndarray = np.where(gap > 0, np.minimum(found, apart / np.where(gap > 0, gap, 1.0)), found)
    return result


@lru_cache
def _pairs(count: int) -> tuple[np.ndarray, np.ndarray, list[np.ndarray]]:
    """The places of the one and of the other of each two of so many; those that are left without either, two arrays."""
    pairs = np.array(list(combinations(range(count), 2)))
    left = [np.array([[k for k in range(count) if k != pair[side]] for pair in pairs]) for side in (0, 1)]
    return pairs[:, 0], pairs[:, 1], left
