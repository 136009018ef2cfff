"""M q̈ + C q̇ + K q = f of any number of digits as a system of first order, some coordinates being without inertia."""

import numpy as np

from vibcli.analyses.transient.static_condensation import condensed
from vibcli.base.errors import PhysicsError


class Descriptor:
    """ẏ = A y + B f, q = Q y + F f with y = (a, z, ȧ): of the coordinates with inertia, of those without that a damper
    resists; others follow the forces at once (condensed.py)."""

    def __init__(self, M, C, K):
        from mpmath import mp

        n = len(M)
        _require_held(M, C, K)
        M, C, K = (mp.matrix([[real(x) for x in row] for row in matrix]) for matrix in (M, C, K))
        heavy = [i for i in range(n) if M[i, i]]
        held = [i for i in range(n) if not M[i, i] and any(C[i, j] for j in range(n))]
        still = [i for i in range(n) if i not in heavy and i not in held]
        kept, h = heavy + held, len(heavy)
        self.places, self.heavy, r = kept, heavy, len(kept)
        self.A, self.B, self.Q, self.F = mp.zeros(r + h), mp.zeros(r + h, n), mp.zeros(n, r + h), mp.zeros(n)
        for column, i in enumerate(kept):
            self.Q[i, column] = mp.one
        if still:
            self._follow(_part(K, still, still)**-1, still, K, kept)
        lead, pushed = mp.matrix(r, r), mp.zeros(r, n)
        for row, i in enumerate(kept):
            for column in range(r):
                lead[row, column] = C[i, kept[h + column]] if column < r - h else M[i, kept[column - r + h]]
            for j in range(n):
                pushed[row, j] = (i == j) - sum(K[i, s] * self.F[s, j] for s in still)
        rates = _part(K, kept, range(n)) * self.Q
        for row, i in enumerate(kept):
            for column in range(h):
                rates[row, r + column] += C[i, kept[column]]
        for i in range(h):
            self.A[i, r + i] = mp.one
        inverse = lead**-1
        rates, pushed = inverse * rates, inverse * pushed
        for row in range(r):
            for column in range(r + h):
                self.A[h + row, column] = -rates[row, column]
            for column in range(n):
                self.B[h + row, column] = pushed[row, column]

    def _follow(self, inverse, still, K, kept):
        drag = inverse * _part(K, still, kept) if kept else None
        for row, i in enumerate(still):
            for column, j in enumerate(still):
                self.F[i, j] = inverse[row, column]
            for column in range(len(kept)):
                self.Q[i, column] = -drag[row, column]


def _part(matrix, rows, columns):
    from mpmath import mp

    out = mp.matrix(len(rows), len(columns))
    for row, i in enumerate(rows):
        for column, j in enumerate(columns):
            out[row, column] = matrix[i, j]
    return out


def _require_held(M, C, K):
    """Refuses dampers that resist only some motions of the coordinates without inertia which they touch."""
    M, C, K = (np.array([[float(x) for x in row] for row in matrix]) for matrix in (M, C, K))
    found = condensed(M, C, K)
    touched = np.flatnonzero((M.diagonal() == 0) & C.any(axis=1))
    if found is not None and len(found.M) != np.count_nonzero(M.diagonal()) + len(touched):
        raise PhysicsError("more digits are not found where dampers resist only some motions of what has no inertia",
                           "leave --digits out")


def real(x):
    from mpmath import mp, mpf

    return mpf(x.numerator) / x.denominator if hasattr(x, "numerator") and not isinstance(x, float) else mp.mpf(x)
