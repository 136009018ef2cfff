"""A fixed point x = g(x) in few unknowns, by Anderson's mixing of earlier steps."""

from collections.abc import Callable

import numpy as np

STEPS, KEPT, FINE, EQUAL, STALLED = 40, 8, 4e-15, 1e-11, 3


def fixed_by_mixing(function: Callable[[np.ndarray], np.ndarray], start: np.ndarray, size: float) -> np.ndarray | None:
    """The x at which function(x) is x but for rounding, against |x| and a `size` beside; None where 40 steps find
    none.

    The next x is x + f − (ΔX + ΔF) γ with f = g(x) − x and the γ that makes |f − ΔF γ| least (Anderson 1965): a secant
    method that begins as x ← g(x).
    """
    xs, fs, best, since = [], [], (np.inf, start), 0
    x = start
    for _ in range(STEPS):
        f = function(x) - x
        left = np.abs(f).max() / (size + np.abs(x).max())
        if not np.isfinite(left):
            return None
        best, since = ((left, x), 0) if left < best[0] else (best, since + 1)
        if left <= FINE or (best[0] <= EQUAL and since >= STALLED):
            return best[1]
        xs, fs = [*xs[-KEPT:], x], [*fs[-KEPT:], f]
        x = x + f
        if len(xs) > 1:
            dx, df = np.diff(xs, axis=0).T, np.diff(fs, axis=0).T
            x = x - (dx + df) @ np.linalg.lstsq(df, f, rcond=1e-13)[0]
    return best[1] if best[0] <= EQUAL else None
