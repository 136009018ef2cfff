"""Undamped modes of floats, certified and bettered by their residuals in twice the digits.

With approximate modes X and R = K̂X − M̂XΘ, the eigenvalues are those of Θ + (XᵀM̂X)⁻¹XᵀR, as that is similar to
M̂⁻¹K̂; Gershgorin's discs bound what stands beside its diagonal (Miyajima 2012; Ogita & Aishima 2018). R alone needs more
digits than floats have.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.undamped_certified import sensitivity
from vibcli.analyses.modal.undamped_large import UNIT, Approximate
from vibcli.numerics import double_double as dd
from vibcli.numerics.double_double import DoubleDouble
from vibcli.numerics.split_products import BoundedProduct, exactly, product
from vibcli.numerics.symmetric_eigenvalues import radii

if TYPE_CHECKING:
    from vibcli.analyses.modal.scaling import Scaling

CLOSE = 2.0**-20        # relative: gap of modes that are told apart no better
SKEW = 1e-3             # how far from orthonormal the modes may be


def bettered(elements: Any, scale: "Scaling", zeros: int | None, start: Approximate,
             unit: float) -> Approximate | None:
    """The modes, `zeros` of them rigid by structure (None: K has to tell), with the errors that their residuals leave,
    and that data rounded by `unit` and the sums in K give; zero with error 1 where floats do not tell the sign. None
    where coordinates without inertia are condensed, or floats are too far from modes."""
    n, p, x, theta = elements.n, scale.coordinates, start.shapes, start.values
    if elements.massless or x.shape != (n, n):
        return None
    K = matrix_of(n, elements.springs, elements.K, p, scale.stiffness)
    M = matrix_of(n, elements.inertias, elements.M, p, scale.mass)
    (kx, off_k), (mx, off_m) = (times(matrix, x) for matrix in (K, M))
    residual = dd.added(kx, dd.scaled(mx, -theta)).hi
    unsure = off_k + off_m * abs(theta) + 8 * dd.UNIT * (abs(kx.hi) + abs(mx.hi * theta))
    skew = x.T @ mx.hi - np.eye(n)
    loose = float(abs(skew).sum(axis=1).max()) + n * n * UNIT * float((abs(x).T @ abs(mx.hi)).max())
    if not loose < SKEW:
        return None
    e = x.T @ residual
    wide = abs(x).T @ (n * UNIT * abs(residual) + unsure)
    wide += loose / (1 - loose) * (abs(e) + wide).max(axis=0)
    zero = np.zeros(n, bool)
    zero[np.argsort(abs(theta), kind="stable")[:zeros or 0]] = True
    nearest = dd.added(exactly(theta), exactly(e.diagonal()))
    values = np.where(zero, 0.0, nearest.hi)
    off, own = abs(e) + wide, wide.diagonal() + abs(nearest.lo)
    np.fill_diagonal(off, np.where(zero, off.diagonal(), own))
    gap = abs(values[:, None] - values[None, :])
    error = radii(values, gap, off * _ratios(values, zero))
    shapes = x + x @ _turn(e, skew, values, gap)
    rows, sums = sensitivity(elements, scale, shapes, abs(values))
    error = error + unit * rows + max(unit, UNIT) * sums
    lost = ~zero & (abs(values) <= 2 * error)
    relative = error / np.where(zero | lost, 1.0, abs(values))
    errors = np.where(zero, 0.0, np.where(lost, 1.0, relative / 2 * (1 + relative) + UNIT))
    return Approximate(np.where(lost, 0.0, values), shapes, errors)


def _ratios(values: np.ndarray, zero: np.ndarray) -> np.ndarray:
    """√(αᵢ/αⱼ), zeros counted as the smallest of the others."""
    size = abs(values)
    least = size[~zero & (size > 0)].min(initial=np.inf)
    root = np.sqrt(np.maximum(size, least if np.isfinite(least) else 1.0))
    return np.asarray(root[:, None] / root[None, :])


def _turn(e: np.ndarray, skew: np.ndarray, values: np.ndarray, gap: np.ndarray) -> np.ndarray:
    """What takes the modes to better ones, to first order."""
    near = gap <= CLOSE * np.maximum(abs(values)[:, None], abs(values)[None, :])
    turn = np.where(near, -skew / 2, e / np.where(near, 1.0, values[None, :] - values[:, None]))
    np.fill_diagonal(turn, -skew.diagonal() / 2)
    return turn


def times(matrix: BoundedProduct, x: np.ndarray) -> tuple[DoubleDouble, np.ndarray]:
    """A matrix times columns, and what that may be off by."""
    found = product(matrix.value, exactly(x))
    return found.value, found.error + matrix.error @ abs(x)


def matrix_of(n: int, terms: "Sequence[tuple[float, dict[int, float]]]", entries: Any, powers: Sequence[int],
              scale: int) -> BoundedProduct:
    """2^-scale D (Σ w s sᵀ + entries) D in twice the digits."""
    rows, weights = np.zeros((len(terms), n)), np.zeros(len(terms))
    for place, (weight, row) in enumerate(terms):
        weights[place] = np.ldexp(float(weight), -scale)
        for i, x in row.items():
            rows[place, i] = np.ldexp(float(x), powers[i])
    total, error = product(exactly(rows.T.copy()), dd.scaled(exactly(rows), weights[:, None]))
    more = np.zeros((n, n))
    for (i, j), x in entries.items():
        more[i, j] = np.ldexp(float(x), powers[i] + powers[j] - scale)
    found = dd.added(total, exactly(more))
    return BoundedProduct(found, error + dd.UNIT * 4 * abs(found.hi))
