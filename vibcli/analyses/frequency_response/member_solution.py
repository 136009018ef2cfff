"""D x = b at many frequencies: by elimination without exchanges where that is found to do well, else by LU."""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.plain_elimination import eliminated, well_solved
from vibcli.analyses.frequency_response.direct import SINGULAR, probe, solutions
from vibcli.numerics.sparse_elimination import Pattern

if TYPE_CHECKING:
    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix


def pattern_of(matrix: "DynamicMatrix", free: np.ndarray) -> Pattern | None:
    """The Pattern of D over the free coordinates; None where D is not symmetric."""
    polynomial = matrix.polynomial[:, free][:, :, free]
    if not (polynomial == polynomial.swapaxes(1, 2)).all():
        return None
    numbers = {int(i): k for k, i in enumerate(free)}
    pairs = [(int(i), int(j)) for i, j in zip(*np.nonzero(polynomial.any(axis=0)), strict=True)]
    for placed in matrix.pieces:
        touched = sorted({numbers[i] for row in placed.rows for i in row if i in numbers})
        pairs += [(i, j) for i in touched for j in touched]
    return Pattern(len(free), pairs)


def scales(size: np.ndarray) -> np.ndarray:
    """Powers of two that bring a diagonal, added from parts of that size, to 1."""
    return np.exp2(-np.round(np.log2(np.where(size > 0, size, 1.0)) / 2))


def scaled(D: np.ndarray, scale: np.ndarray) -> np.ndarray:
    """(N, n, n) of D (n, n, N), rows and columns scaled."""
    return np.moveaxis(D * scale[:, None] * scale[None, :], -1, 0)


def motions(D: np.ndarray, scale: np.ndarray, loads: "list[np.ndarray]",
            pattern: Pattern | None) -> tuple[list[np.ndarray], np.ndarray]:
    """(x of each load, whether D is nearly singular at each frequency); D: (n, n, N), scale and loads: (n, N)."""
    sides = np.stack([*loads, probe(len(D))[:, None] / scale], axis=1).astype(np.result_type(D, *loads), copy=False)
    if pattern is None:
        x, left = np.zeros_like(sides), np.arange(D.shape[-1])
    else:
        with np.errstate(all="ignore"):
            x = eliminated(pattern, D, sides)
            well = [well_solved(D, list(pattern.places), x[:, k], sides[:, k]) for k in range(len(loads))]
        left = np.flatnonzero(~np.all(well, axis=0))
    if len(left):
        found = solutions(scaled(D[:, :, left], scale[:, left]), np.moveaxis(sides[:, :, left] * scale[:, None, left],
                                                                             -1, 0))
        found = found if np.iscomplexobj(x) else found.real       # what is singular is complex
        x[:, :, left] = np.moveaxis(found, 0, -1) * scale[:, None, left]
    singular = ~(np.abs(x[:, -1] / scale).max(axis=0, initial=0.0) * SINGULAR * 64 < 1)
    return [np.where(singular, 0.0, x[:, k]) for k in range(len(loads))], singular
