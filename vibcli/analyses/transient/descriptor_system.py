"""M q̈ + C q̇ + K q = f of any number of digits as a system of first order, some coordinates being without inertia."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from mpmath import mp, mpf

from vibcli.analyses.transient.static_condensation import condensed
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    import mpmath


class Descriptor:
    """ẏ = A y + B f, q = Q y + F f with y = (a, z, ȧ): of the coordinates with inertia, of those without that a damper
    resists; others follow the forces at once (condensed.py)."""

    def __init__(self, M: "Sequence[list[float | mpmath.mpf]]", C: "Sequence[list[float | mpmath.mpf]]",
                 K: "Sequence[list[float | mpmath.mpf]]") -> None:
        n = len(M)
        _require_held(M, C, K)
        M, C, K = (np.array([[real(x) for x in row] for row in matrix], object) for matrix in (M, C, K))
        heavy = [i for i in range(n) if M[i, i]]
        held = [i for i in range(n) if not M[i, i] and C[i].any()]
        still = [i for i in range(n) if i not in heavy and i not in held]
        kept, h = heavy + held, len(heavy)
        self.places, self.heavy, r = kept, heavy, len(kept)
        self.Q, self.F = np.zeros((n, r + h), object), np.zeros((n, n), object)
        self.Q[kept, range(r)] = 1
        if still:
            follow = _inverse(K[np.ix_(still, still)])
            self.F[np.ix_(still, still)] = follow
            self.Q[still, :r] = -_product(follow, K[np.ix_(still, kept)])
        rates, pushed = _product(K[kept], self.Q), np.eye(n, dtype=object)[kept] - _product(K[kept], self.F)
        rates[:, r:] += C[np.ix_(kept, heavy)]
        inverse = _inverse(np.concatenate([C[np.ix_(kept, held)], M[np.ix_(kept, heavy)]], axis=1))
        self.A = np.concatenate([np.eye(h, r + h, r, dtype=object), -_product(inverse, rates)])
        self.B = np.concatenate([np.zeros((h, n), object), _product(inverse, pushed)])


class SummingSystem:
    """A Descriptor with states ∫ r q dt at its end, r rows over the coordinates that need not follow the forces."""

    def __init__(self, system: Any, rows: "list[list[mpmath.mpf]]") -> None:
        self.places, self.heavy, self.F, count, n = system.places, system.heavy, system.F, len(rows), len(system.Q)
        A = np.concatenate([system.A, np.array(rows, object).reshape(count, n).dot(system.Q)])
        self.A, self.Q = (np.concatenate([part, np.zeros((len(part), count), object)], axis=1)
                          for part in (A, system.Q))
        self.B = np.concatenate([system.B, np.zeros((count, n), object)])


def _product(left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """The product of two matrices, the left of which is mostly zeros."""
    found = np.zeros((len(left), right.shape[1]), object)
    for row, sums in zip(left, found, strict=True):
        for k in np.flatnonzero(row):
            places = np.flatnonzero(right[k])
            sums[places] += row[k] * right[k, places]
    return found


def _inverse(matrix: np.ndarray) -> np.ndarray:
    diagonal = matrix.diagonal()
    if len(matrix) and not np.any(matrix - np.diag(diagonal)):
        return np.diag(mpf(1) / diagonal)
    inverse = mp.matrix(matrix.tolist())**-1 if len(matrix) else matrix
    return np.array(inverse.tolist(), object).reshape(matrix.shape)


def _require_held(M: "Sequence[list[float | mpmath.mpf]]", C: "Sequence[list[float | mpmath.mpf]]",
                  K: "Sequence[list[float | mpmath.mpf]]") -> None:
    """Refuses dampers that resist only some motions of the coordinates without inertia which they touch."""
    M, C, K = (np.array([[float(x) for x in row] for row in matrix]) for matrix in (M, C, K))
    found = condensed(M, C, K)
    touched = np.flatnonzero((M.diagonal() == 0) & C.any(axis=1))
    if found is not None and len(found.M) != np.count_nonzero(M.diagonal()) + len(touched):
        raise PhysicsError("more digits are not found where dampers resist only some motions of what has no inertia",
                           "leave --digits out")


def real(x: Any) -> "mpmath.mpf":
    return mpf(x.numerator) / x.denominator if hasattr(x, "numerator") and not isinstance(x, float) else mp.mpf(x)
