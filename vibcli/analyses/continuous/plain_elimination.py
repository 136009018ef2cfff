"""Elimination without exchanges of many symmetric matrices at a time, complex ones too, and how well it went."""

from typing import TYPE_CHECKING, cast

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.numerics.sparse_elimination import Pattern

WELL = 4 * 2.0**-52        # largest part of |D| |x| + |b| that D x − b may be, by which exchanges are not missed


def eliminated(pattern: "Pattern", D: np.ndarray, loads: np.ndarray) -> np.ndarray:
    """x of D x = load, (n, loads, N); D: (n, n, N), of which entries outside the pattern are zero. Not finite where a
    pivot is zero."""
    work, x, factors = {}, loads.copy(), []
    for i, j in pattern.places:
        work[i, j] = D[i, j]
    for step in pattern.steps:
        pivot, after = step.pivot, step.after
        column = [work[min(pivot, j), max(pivot, j)] for j in after]
        inverse = 1 / work[pivot, pivot]
        rows = [one * inverse for one in column]
        for a, i in enumerate(after):
            x[i] -= rows[a] * x[pivot]
            for b, j in enumerate(after[a:], a):
                work[i, j] = work[i, j] - rows[a] * column[b]
        factors.append((inverse, rows))
    for step, (inverse, rows) in zip(reversed(pattern.steps), reversed(factors), strict=True):
        x[step.pivot] *= inverse
        for row, j in zip(rows, step.after, strict=True):
            x[step.pivot] -= row * x[j]
    return x


def well_solved(D: np.ndarray, entries: "Sequence[tuple[int, int]]", x: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Whether x, (n, N), solves matrices close to D, at each of them; entries: the places (i, j) of D, i ≤ j."""
    rest, size = -b, np.abs(b)
    large = np.abs(x)
    for i, j in entries:
        rest[i] += D[i, j] * x[j]
        magnitude = np.abs(D[i, j])
        size[i] += magnitude * large[j]
        if i != j:
            rest[j] += D[i, j] * x[i]
            size[j] += magnitude * large[i]
    return cast("np.ndarray", (np.abs(rest) <= WELL * size).all(axis=0))
