"""Sparse symmetric matrices Σ w s sᵀ + E, whose terms are kept apart from their sum."""

from typing import Any

import numpy as np

from vibcli.numerics import double_double as dd
from vibcli.numerics.double_double import DoubleDouble

UNIT = 2.0**-53
LEAF = 8            # products that are added in a row


class SparseForm:
    """weights: w (m); rows: the s, sparse (m, n); entries: E, sparse (n, n), None where there are none; size: of each
    entry the magnitudes it was added from, like E."""

    __slots__ = ("entries", "rows", "size", "transposed", "weights")

    def __init__(self, weights: np.ndarray, rows: Any, entries: Any = None, size: Any = None) -> None:
        self.weights, self.rows, self.transposed = weights, rows.tocsr(), rows.T.tocsr()
        self.entries = None if entries is None else entries.tocsr()
        self.size = abs(self.entries) if size is None and entries is not None else size

    @property
    def n(self) -> int:
        found: int = self.rows.shape[1]
        return found

    @property
    def is_diagonal(self) -> bool:
        """Has it no entries beside the diagonal by structure?"""
        return self.entries is None and bool((np.diff(self.rows.indptr) <= 1).all())

    def assembled(self) -> Any:
        """The matrix in floats, sparse."""
        found = self.transposed @ self.rows.multiply(self.weights[:, None]).tocsr()
        return found if self.entries is None else found + self.entries

    def magnitudes(self) -> np.ndarray:
        """The sums over rows of the magnitudes that the entries are added from (n)."""
        found = abs(self.transposed) @ (abs(self.weights) * np.asarray(abs(self.rows).sum(axis=1)).ravel())
        result: np.ndarray = found if self.entries is None else found + np.asarray(self.size.sum(axis=1)).ravel()
        return result

    @property
    def terms(self) -> int:
        """The most terms that an entry is added from."""
        return int(np.diff(self.transposed.indptr).max(initial=0)) + 1

    def times(self, x: DoubleDouble) -> DoubleDouble:
        """The matrix times columns, in twice the digits."""
        found = dd.times(self.transposed, dd.scaled(dd.times(self.rows, x), self.weights[:, None]))
        return found if self.entries is None else dd.added(found, dd.times(self.entries, x))

    def product(self, x: np.ndarray) -> np.ndarray:
        """The same in floats, by way of the rows."""
        found = self.transposed @ ((self.rows @ x).T * self.weights).T
        result: np.ndarray = found if self.entries is None else found + self.entries @ x
        return result

    def between(self, x: DoubleDouble) -> tuple[np.ndarray, np.ndarray]:
        """Xᵀ A X, and the magnitudes that its diagonal is added from, relative to which it is rounded by
        UNIT · (LEAF + log₂ of the number of terms + 4)."""
        s = dd.times(self.rows, x).hi
        root = np.sqrt(abs(self.weights))[:, None] * s
        found, size = _gram(root * np.sign(self.weights)[:, None], root), (root * root).sum(axis=0)
        if self.entries is not None:
            found = found + _gram(x.hi, dd.times(self.entries, x).hi)
            most = np.asarray(self.size.sum(axis=1)).ravel()
            size = size + (most[:, None] * x.hi * x.hi).sum(axis=0)
        return (found + found.T) / 2, size

    def data_error(self, x: np.ndarray) -> np.ndarray:
        """By how much xᵀ A x of each column changes to first order where every weight, component of a row and term of
        an entry changes by one unit relative to it (p)."""
        s, wide = self.rows @ x, abs(self.rows) @ abs(x)
        found = (abs(self.weights)[:, None] * (s * s + 2 * abs(s) * wide * self._rounded[:, None])).sum(axis=0)
        return np.asarray(found if self.entries is None else found + (abs(x) * (self.size @ abs(x))).sum(axis=0))

    @property
    def _rounded(self) -> np.ndarray:
        """Of each row 1 where a component may be rounded, 0 where all are whole multiples of a power of two."""
        short = np.ldexp(np.frexp(self.rows.data)[0], 26) % 1 == 0
        counted = np.bincount(np.repeat(np.arange(self.rows.shape[0]), np.diff(self.rows.indptr)), weights=~short,
                              minlength=self.rows.shape[0])
        return (counted > 0).astype(float)


def _gram(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """aᵀ b, the products added in leaves and these pairwise."""
    short = -len(a) % LEAF
    leaves = [np.pad(x, ((0, short), (0, 0))).reshape(-1, LEAF, x.shape[1]) for x in (a, b)]
    found = leaves[0].transpose(0, 2, 1) @ leaves[1]
    while len(found) > 1:
        half = len(found) // 2
        found = np.concatenate([found[:half] + found[half:2 * half], found[2 * half:]])
    result: np.ndarray = found[0]
    return result
