"""Undamped modes of many coordinates in floats, with a bound of the rounding.

Where all stiffness is Σ k ∇s ∇sᵀ the frequencies are singular values of X = √k̂ ∇s L⁻ᵀ, M̂ = L Lᵀ: K̂ is not
assembled. Otherwise they are eigenvalues of L⁻¹ K̂ L⁻ᵀ, to 4 n ε of its assembled magnitudes.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.scaling import Scaling, mechanism, unmoved
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.factored_svd import mass_factor, singular_vectors

if TYPE_CHECKING:
    import mpmath

    from vibcli.mechanics.factored_system import FactoredSystem

UNIT = 2.0 ** -53


class Approximate(NamedTuple):
    """λ̂ = ω̂² (0 for rigid modes), M̂-normalised shapes in columns, relative bounds of √|λ̂|.

    The bound is 0 for a zero that follows from the structure, 1 for a value whose sign floats cannot tell.
    """

    values: np.ndarray
    shapes: np.ndarray
    errors: np.ndarray


def approximate(elements: Any, scale: Scaling, zeros: int | None) -> Approximate:
    """The undamped eigenvalues in floats."""
    if zeros is None or elements.massless:
        return _assembled(elements, scale, zeros)
    n = elements.n
    rows = scaled_rows(elements.springs, scale.coordinates, scale.stiffness, n)
    lower = mass_triangle(elements, scale, range(n))
    x = rows / lower if lower.ndim == 1 else _solved(lower, rows.T).T
    known = 1.0 if lower.ndim == 1 else 1.0 + _growth(lower)
    sigma, v, bound = singular_vectors(x, zeros, known)
    sigma[n - zeros:] = 0.0
    return Approximate(sigma ** 2, back_from(lower, v), bound + 2 * UNIT)


def scaled_rows(terms: "Sequence[tuple[float | mpmath.mpf, dict[int, float | mpmath.mpf]]]", powers: Sequence[int],
                scale: int, n: int) -> np.ndarray:
    """√(2^-scale w) s D as a dense array, a term to a row; powers of two enter exactly."""
    out = np.zeros((len(terms), n))
    for place, (weight, row) in enumerate(terms):
        m, e = np.frexp(float(weight))
        odd = int(e - scale) % 2
        root, half = np.sqrt(m * 2.0 if odd else m), (int(e) - scale - odd) // 2
        for i, x in row.items():
            out[place, i] = np.ldexp(root * float(x), half + powers[i])
    return out


def dense(terms: Sequence[tuple[float, dict[int, float]]], matrix: Any, powers: Sequence[int], scale: int,
          n: int) -> np.ndarray:
    """2^-scale D (Σ w s sᵀ + matrix) D in floats."""
    out = np.zeros((n, n))
    for weight, row in terms:
        m, e = np.frexp(float(weight))
        parts = [(i, float(x)) for i, x in row.items()]
        for i, x in parts:
            for j, y in parts:
                out[i, j] += np.ldexp(m * x * y, int(e) + powers[i] + powers[j] - scale)
    for (i, j), x in matrix.items():
        out[i, j] += np.ldexp(float(x), powers[i] + powers[j] - scale)
    return out


def stiffness(elements: Any, scale: Scaling) -> tuple[np.ndarray, np.ndarray]:
    """K̂ in floats, and the sum of the magnitudes of the terms of each entry."""
    n, p = elements.n, scale.coordinates
    springs = [(abs(w), {i: abs(x) for i, x in row.items()}) for w, row in elements.springs]
    sums = elements.K_size or {at: abs(x) for at, x in elements.K.items()}
    return (dense(elements.springs, elements.K, p, scale.stiffness, n),
            dense(springs, sums, p, scale.stiffness, n))


def mass_triangle(elements: Any, scale: Scaling, massive: Sequence[int] | range) -> np.ndarray:
    """Lower triangular L with M̂ = L Lᵀ over the massive coordinates, or its diagonal alone."""
    n, p, massive = elements.n, scale.coordinates, list(massive)
    if elements.M:
        m = dense(elements.inertias, elements.M, p, scale.mass, n)[np.ix_(massive, massive)]
        try:
            return np.linalg.cholesky(m)
        except np.linalg.LinAlgError:
            raise unmoved(massive[int(np.argmin(np.linalg.eigh(m)[1][:, 0]))]) from None
    rows = scaled_rows(elements.inertias, p, scale.mass, n)[:, massive]
    if (np.count_nonzero(rows, axis=1) <= 1).all():
        found: np.ndarray = np.linalg.norm(rows, axis=0)
        return found
    lower = mass_factor(rows) if len(rows) >= len(massive) else np.zeros((1, 1))
    weak = np.flatnonzero(lower.diagonal() <= 4 * len(massive) * UNIT)
    if len(weak):
        raise unmoved(massive[int(weak[0])])
    return lower


def _solved(triangle: np.ndarray, b: np.ndarray) -> np.ndarray:
    from scipy.linalg import solve_triangular

    found: np.ndarray = solve_triangular(triangle, b, lower=not np.any(np.triu(triangle, 1)))
    return found


def _growth(triangle: np.ndarray) -> float:
    """How much solving with a triangle may add to the rounding (Skeel 1979), free of the size of its rows."""
    inverse = _solved(triangle, np.eye(len(triangle)))
    return float(np.linalg.norm(np.abs(inverse) @ np.abs(triangle), 2))


def back_from(lower: np.ndarray, v: np.ndarray) -> np.ndarray:
    """L⁻ᵀ v for what mass_triangle gives."""
    return v / lower[:, None] if lower.ndim == 1 else _solved(lower.T, v)


def _assembled(elements: "FactoredSystem", scale: Scaling, zeros: int) -> Approximate:
    """The same from the assembled stiffness, massless coordinates condensed."""
    n = elements.n
    k, size = stiffness(elements, scale)
    bare = sorted(elements.massless)
    massive = [i for i in range(n) if i not in set(bare)]
    if bare:
        k, follow, size = _condensed(k, size, massive, bare)
    lower = mass_triangle(elements, scale, massive)
    back = back_from(lower, np.eye(len(massive)))
    a, size = back.T @ k @ back, np.abs(back.T) @ size @ np.abs(back)
    values, q = np.linalg.eigh((a + a.T) / 2)
    error = 4 * len(a) * UNIT * np.linalg.norm(size, 2)
    undecided = zero = np.abs(values) <= 2 * error
    if zeros is not None:
        zero = np.zeros(len(values), bool)
        zero[np.argsort(np.abs(values), kind="stable")[:zeros]] = True
        undecided = undecided & ~zero
    shapes = np.zeros((n, len(massive)))
    shapes[massive] = back @ q
    if bare:
        shapes[bare] = -follow @ shapes[massive]
    values[zero] = 0.0
    with np.errstate(divide="ignore", invalid="ignore"):
        relative = error / np.abs(values)
        errors = np.where(undecided, 1.0, np.where(zero, 0.0, relative / 2 * (1 + relative)))
    return Approximate(values, shapes, errors)


def _condensed(k: np.ndarray, size: np.ndarray, massive: Sequence[int],
               bare: Sequence[int]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Stiffness, following and magnitudes with the massless coordinates eliminated."""
    loose, held = np.ix_(massive, massive), np.ix_(massive, bare)
    if np.linalg.matrix_rank(k[np.ix_(bare, bare)]) < len(bare):
        raise mechanism(bare[int(np.argmax(np.abs(np.linalg.eigh(k[np.ix_(bare, bare)])[1][:, 0])))])
    inverse = np.linalg.inv(k[np.ix_(bare, bare)])
    follow = inverse @ k[held].T
    wide = np.abs(inverse) @ size[np.ix_(bare, bare)] @ np.abs(follow) + np.abs(inverse) @ size[held].T
    return k[loose] - k[held] @ follow, follow, size[loose] + size[held] @ wide
