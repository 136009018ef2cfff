"""∫ f dt by Gauss's rule on panels that are halved until the halves tell no more than the whole."""

from collections.abc import Callable, Sequence

import numpy as np

POINTS, LEVELS = 16, 60
ROUNDING = 1e-15        # of the integral of |f| per length
MOST = 20_000           # panels at once


def integral(function: "Callable[[np.ndarray], np.ndarray]", edges: Sequence[float],
             off: float = 0.0) -> float | None:
    """Of an array function over the panels between ascending edges; corners and jumps of it are narrowed down to
    rounding, and to how far its values may be off. None where it does not settle."""
    at, weights = np.polynomial.legendre.leggauss(POINTS)

    def panels(early: np.ndarray, late: np.ndarray) -> "tuple[np.ndarray, np.ndarray]":
        half = 0.5 * (late - early)
        values = function((0.5 * (early + late)[:, None] + half[:, None] * at).ravel()).reshape(len(half), POINTS)
        return half * (values @ weights), half * (np.abs(values) @ weights)

    early, late = np.asarray(edges[:-1], float), np.asarray(edges[1:], float)
    whole, size = panels(early, late)
    total, length, scale = 0.0, late[-1] - early[0], size.sum()
    for _ in range(LEVELS):
        middle = 0.5 * (early + late)
        (first, one), (second, two) = panels(early, middle), panels(middle, late)
        scale = max(scale, one.sum() + two.sum())
        rough = np.abs(first + second - whole) > ROUNDING * (scale * (late - early) / length + one + two) + (
            off * (late - early))
        total += (first + second)[~rough].sum()
        if not rough.any():
            return float(total)
        early, late = np.concatenate([early[rough], middle[rough]]), np.concatenate([middle[rough], late[rough]])
        whole = np.concatenate([first[rough], second[rough]])
        if len(early) > MOST:
            return None
    return float(total + whole.sum()) if np.abs(whole).sum() <= ROUNDING * LEVELS * scale else None
