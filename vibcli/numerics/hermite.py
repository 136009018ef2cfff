"""The polynomials of fifth degree through values, slopes and curvatures at both ends of steps."""

from collections.abc import Callable

import numpy as np


def quintic(times: np.ndarray, q: np.ndarray, v: np.ndarray,
            a: np.ndarray) -> Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]:
    """(q, q̇) of shape (rows, n, columns) as a function of instants (rows, columns), from q, q̇, q̈ at the `times` between
    the steps, of shape (steps + 1, n).

    With x = (t − t₀)/h of a step and d₀, d₁, d₂, by which q, h q̇, h² q̈ at its end differ from those of q₀ + x h q̇₀ +
    x² h² q̈₀/2: … + x³ (10 d₀ − 4 d₁ + d₂/2) − x⁴ (15 d₀ − 7 d₁ + d₂) + x⁵ (6 d₀ − 3 d₁ + d₂/2).
    """
    h = np.diff(times)[:, None]
    v0, v1, a0, a1 = h * v[:-1], h * v[1:], h * h * a[:-1], h * h * a[1:]
    d0, d1, d2 = q[1:] - q[:-1] - v0 - a0 / 2, v1 - v0 - a0, a1 - a0
    powers = (6 * d0 - 3 * d1 + d2 / 2, 7 * d1 - 15 * d0 - d2, 10 * d0 - 4 * d1 + d2 / 2, a0 / 2, v0, q[:-1])

    def at(t: np.ndarray) -> "tuple[np.ndarray, np.ndarray]":
        step = np.clip(np.searchsorted(times, t, side="right") - 1, 0, len(times) - 2)
        x = ((t - times[step]) / h[step, 0])[..., None]
        place, speed = powers[0][step], 0.0
        for row in powers[1:]:
            speed = speed * x + place
            place = place * x + row[step]
        return place.swapaxes(1, 2), (speed / h[step]).swapaxes(1, 2)

    return at
