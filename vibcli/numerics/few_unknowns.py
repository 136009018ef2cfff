"""Linear systems of few unknowns, in plain floats: arrays of a few numbers take ten times as long."""

from collections.abc import Sequence

FEW, REGULAR = 8, 1e-6         # unknowns; least pivot beside the largest with which a system counts as regular


def shortest_solution(rows: Sequence[Sequence[float]], right: Sequence[float], rank: float) -> list[float]:
    """x of A x = b; where A is singular to `rank` the shortest of all that come nearest to it."""
    found = _eliminated(rows, right) if len(right) <= FEW else None
    if found is not None:
        return found
    import numpy as np

    result: list[float] = np.linalg.lstsq(rows, right, rcond=rank)[0].tolist()
    return result


def _eliminated(rows: Sequence[Sequence[float]], right: Sequence[float]) -> list[float] | None:
    """By Gaussian elimination, the largest entries of columns as pivots; None where A is nearly singular."""
    left, n = [[*row, b] for row, b in zip(rows, right, strict=True)], len(right)
    least, largest = float("inf"), 0.0
    for k in range(n):
        best = max(range(k, n), key=lambda i: abs(left[i][k]))
        left[k], left[best] = left[best], left[k]
        top = left[k]
        size = abs(top[k])
        least, largest = min(least, size), max(largest, size)
        if not least > REGULAR * largest:
            return None
        for row in left[k + 1:]:
            factor = row[k] / top[k]
            if factor:
                for j in range(k + 1, n + 1):
                    row[j] -= factor * top[j]
    found = [0.0] * n
    for k in reversed(range(n)):
        row = left[k]
        found[k] = (row[n] - sum(row[j] * found[j] for j in range(k + 1, n))) / row[k]
    return found
