"""Chebyshev series on [−1, 1]: from values at their points to coefficients, integrals, derivatives, values.

The points are the zeros of T_N, so that none lies at an end, where what is sampled may jump.
"""

import numpy as np

N = 24              # points
WIDTH = N + 2       # coefficients that are kept: of the second integral of what N points tell
ROUNDING = 2.0 ** -52
TOUCH = 1e-7        # distance of two places that are one where a series touches zero


def _integrated(count: int) -> np.ndarray:
    """(count, count + 1): the coefficients of ∫ from −1 of T_0 … T_{count−1}, as rows."""
    found = np.zeros((count, count + 1))
    found[0, :2] = 1.0
    if count > 1:
        found[1, :3] = -0.25, 0.0, 0.25
    for k in range(2, count):
        found[k, k + 1], found[k, k - 1] = 0.5 / (k + 1), -0.5 / (k - 1)
        found[k, 0] = (-1.0) ** (k + 1) / (k * k - 1.0)
    return found


def _differentiated(count: int) -> np.ndarray:
    """(count, count): the coefficients of T_k′, as rows."""
    found = np.zeros((count, count))
    for k in range(1, count):
        found[k, k - 1::-2] = 2.0 * k
        if k % 2:
            found[k, 0] = k
    return found


_ANGLES = (2 * np.arange(N)[::-1] + 1) * np.pi / (2 * N)
POINTS = np.cos(_ANGLES)
TO_SERIES = np.cos(np.outer(_ANGLES, np.arange(N))) * np.where(np.arange(N), 2.0 / N, 1.0 / N)
ONCE = TO_SERIES @ _integrated(N)                   # values to the coefficients of their integral from −1, as rows
TWICE = ONCE @ _integrated(N + 1)
AT_POINTS = np.cos(np.outer(np.arange(WIDTH), _ANGLES))
RATE = _differentiated(WIDTH)


def summed(series: np.ndarray, x: np.ndarray) -> np.ndarray:
    """The values of series, of shape (… , WIDTH), one for each place x in [−1, 1] along their last axis but one."""
    waves = np.cos(np.arccos(np.clip(x, -1.0, 1.0))[:, None] * np.arange(series.shape[-1]))
    found: np.ndarray = np.einsum("...k,...k->...", series, waves)
    return found


def turning_points(series: np.ndarray) -> list[float]:
    """The places in [−1, 1] where the slope of a series is zero."""
    return passages(series @ RATE)


def passages(series: np.ndarray) -> list[float]:
    """The places in [−1, 1] where a series passes or touches zero, ascending."""
    from numpy.polynomial.chebyshev import chebroots

    size = np.abs(series).sum()
    held = np.flatnonzero(np.abs(series) > ROUNDING * size)
    if not size or held[-1] == 0:
        return []
    found: list[float] = []
    roots = chebroots(series[:held[-1] + 1])
    for root in np.sort(roots.real[(np.abs(roots.imag) < TOUCH) & (np.abs(roots.real) <= 1 + TOUCH)]):
        x = float(np.clip(root, -1.0, 1.0))
        slope, bend = (float(summed(part, np.array([x]))[0]) for part in (series @ RATE, series @ RATE @ RATE))
        value = float(summed(series, np.array([x]))[0])
        if slope * slope > abs(2 * value * bend):
            x = float(np.clip(x - value / slope, -1.0, 1.0))
            value = float(summed(series, np.array([x]))[0])
        if abs(value) <= 64 * ROUNDING * size and (not found or x - found[-1] > TOUCH):
            found.append(x)
    return found
