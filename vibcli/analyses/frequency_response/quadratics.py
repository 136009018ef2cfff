"""Quadratic polynomials in s, of numbers and of rows."""

import numpy as np


def polynomial(coefficients: np.ndarray, s: np.ndarray) -> np.ndarray:
    """Σ coefficientₖ sᵏ; s (N,) gives (N, …)."""
    s = np.asarray(s).reshape(-1, *[1] * (np.ndim(coefficients) - 1))
    found: np.ndarray = coefficients[0] + s * (coefficients[1] + s * coefficients[2])
    return found


def slope(coefficients: np.ndarray, s: np.ndarray) -> np.ndarray:
    """The derivative of the same polynomial."""
    s = np.asarray(s).reshape(-1, *[1] * (np.ndim(coefficients) - 1))
    found: np.ndarray = coefficients[1] + 2 * s * coefficients[2]
    return found
