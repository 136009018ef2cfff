"""Linear recurrences cₙ = zₙ cₙ₋₁ + aₙ by arrays, whether the z are all one or not.

The n are cut into rows of equal length. All rows start from zero at once; from the end of one row to that of the next
leads the product of its z, row by row; what a row really started from then reaches each of its c by the products up to
there. Before a row started all is as if done step by step; within it what is rounded is no larger than the largest |c|
of the row and of its start, twice.
"""

import numpy as np

ROW = 64


def recurrence(z: np.ndarray, a: np.ndarray, start: np.ndarray) -> np.ndarray:
    """c₁ … c_N (M, N) of M recurrences of numbers: z (M, N), or (M, 1) of those that are all one, a (M, N), start (M,)
    that is c₀."""
    rows, alike = a.shape[1] // ROW, z.shape[1] == 1
    at, found = rows * ROW, np.empty_like(a)
    if rows:
        reach = np.repeat(z[None], ROW, axis=0) if alike else _across(z[:, :at], rows)
        own = _across(a[:, :at], rows)
        for k in range(1, ROW):
            own[k] += reach[k] * own[k - 1]
            np.multiply(reach[k], reach[k - 1], out=reach[k])
        starts = _one_by_one(reach[-1], own[-1], start)
        own += reach * np.concatenate([start[:, None], starts[:, :-1]], axis=1)
        found[:, :at].reshape(len(a), rows, ROW)[:] = own.transpose(1, 2, 0)
        start = starts[:, -1]
    found[:, at:] = _one_by_one(z if alike else z[:, at:], a[:, at:], start)
    return found


def recurrence_of_matrices(z: np.ndarray, a: np.ndarray, start: np.ndarray) -> np.ndarray:
    """c₁ … c_N (N, p) of z (N, p, p), a (N, p), start (p,) that is c₀."""
    rows = len(a) // ROW
    at, found = rows * ROW, np.empty_like(a)
    if rows:
        reach, own = (np.moveaxis(part[:at].reshape(rows, ROW, *part.shape[1:]), 1, 0).copy() for part in (z, a))
        for k in range(1, ROW):
            own[k] += _on(reach[k], own[k - 1])
            reach[k] = reach[k] @ reach[k - 1]
        starts = _step_by_step(reach[-1], own[-1], start)
        own += _on(reach, np.concatenate([start[None], starts[:-1]]))
        found[:at] = np.moveaxis(own, 0, 1).reshape(at, -1)
        start = starts[-1]
    found[at:] = _step_by_step(z[at:], a[at:], start)
    return found


def row_maxima(sizes: np.ndarray) -> np.ndarray:
    """The largest of c₀ … c_N (…, N + 1) in each row and at its start, the last row perhaps a shorter one."""
    inner = np.maximum.reduceat(sizes[..., 1:], np.arange(0, sizes.shape[-1] - 1, ROW), axis=-1)
    found: np.ndarray = np.maximum(inner, sizes[..., :-1:ROW])
    return found


def _across(a: np.ndarray, rows: int) -> np.ndarray:
    """The first of all rows, the second of all, …: (ROW, M, rows), as a copy."""
    return a.reshape(len(a), rows, ROW).transpose(2, 0, 1).copy()


def _one_by_one(z: np.ndarray, a: np.ndarray, start: np.ndarray) -> np.ndarray:
    found = np.empty_like(a)
    for row, factors, more, c in zip(found, np.broadcast_to(z, a.shape), a, start.tolist(), strict=True):
        ends = []
        for factor, x in zip(factors.tolist(), more.tolist(), strict=True):
            c = factor * c + x
            ends.append(c)
        row[:] = ends
    return found


def _on(matrices: np.ndarray, columns: np.ndarray) -> np.ndarray:
    found: np.ndarray = (matrices @ columns[..., None])[..., 0]
    return found


def _step_by_step(z: np.ndarray, a: np.ndarray, start: np.ndarray) -> np.ndarray:
    found = a.copy()
    for k in range(len(a)):
        start = found[k] = found[k] + z[k] @ start
    return found
