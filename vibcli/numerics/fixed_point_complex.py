"""Complex matrices in fixed point, far finer than floats: real and imaginary parts side by side, [Re | Im]."""

from typing import Any

import numpy as np

from vibcli.numerics import fixed_point as fx

BITS = 320


def wide(a: np.ndarray) -> np.ndarray:
    """A matrix of floats in fixed point."""
    found: np.ndarray = fx.fixed(np.concatenate([a.real, a.imag], axis=1), BITS)
    return found


def parts(a: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Re and Im."""
    middle = a.shape[1] // 2
    return a[:, :middle], a[:, middle:]


def narrow(a: np.ndarray) -> np.ndarray:
    """The nearest floats."""
    re, im = parts(fx.floats(a, BITS))
    return re + 1j * im


def times(a: np.ndarray, b: Any) -> np.ndarray:
    """a b."""
    re, im = parts(b)
    left, right = parts(a)
    found: np.ndarray = fx.product(left, b, BITS) + fx.product(right, np.concatenate([-im, re], axis=1), BITS)
    return found
