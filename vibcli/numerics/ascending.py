"""Numbers in ascending order, and the one in the middle: np.unique and np.median without what these load (numpy.ma, a
tenth of all NumPy)."""

from typing import Any

import numpy as np


def ascending(values: Any) -> np.ndarray:
    """The different ones of real numbers, ascending: (N,)."""
    found = np.sort(np.asarray(values).ravel())
    return found[np.append(True, found[1:] != found[:-1])] if len(found) else found


def median(values: np.ndarray) -> float:
    """The mean of the two numbers in the middle, or the one: of (N,)."""
    found = np.sort(values)
    return float((found[(len(found) - 1) // 2] + found[len(found) // 2]) / 2)
