"""Sums and products of arrays in twice the digits of floats: each number is a pair hi + lo, |lo| <= ulp(hi)/2.

Errors of sums by Knuth (1969), of products by Dekker (1971). What is rounded is below 2^-102 of the magnitudes added.
"""

from typing import Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.error_free import whole_product, whole_sum

UNIT = 2.0**-102


class DoubleDouble(NamedTuple):
    """hi + lo, arrays of one shape."""

    hi: np.ndarray
    lo: np.ndarray


def added(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble:
    """a + b."""
    total, left = whole_sum(a.hi, b.hi)
    return _renewed(total, left + (a.lo + b.lo))


def scaled(a: DoubleDouble, factor: np.ndarray | float) -> DoubleDouble:
    """a times floats, with the rules of broadcasting."""
    product, left = whole_product(a.hi, factor)
    return _renewed(product, left + a.lo * factor)


def times(matrix: Any, a: DoubleDouble) -> DoubleDouble:
    """A sparse matrix, as rows (csr), times the pairs in columns: the first entries of all rows, then the second …"""
    counts = np.diff(matrix.indptr)
    order = np.argsort(-counts, kind="stable")
    starts, counts = matrix.indptr[:-1][order], counts[order]
    found = DoubleDouble(*(np.zeros((len(order), a.hi.shape[1])) for _ in range(2)))
    for k in range(counts[0] if len(counts) else 0):
        reach = int(np.searchsorted(-counts, -k))
        at = starts[:reach] + k
        place = matrix.indices[at]
        term = scaled(DoubleDouble(a.hi[place], a.lo[place]), matrix.data[at][:, None])
        found.hi[:reach], found.lo[:reach] = added(DoubleDouble(found.hi[:reach], found.lo[:reach]), term)
    back = np.empty_like(order)
    back[order] = np.arange(len(order))
    return DoubleDouble(found.hi[back], found.lo[back])


def _renewed(high: np.ndarray, low: np.ndarray) -> DoubleDouble:
    total = high + low
    return DoubleDouble(total, low - (total - high))
