"""Products of matrices in twice the digits of floats, from products of floats that are exact.

Rows of the left factor and columns of the right one are cut into slices of so few bits that no product of two slices
rounds, in whatever order it is summed (Ozaki, Ogita, Oishi & Rump 2012).
"""

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics import double_double as dd
from vibcli.numerics.double_double import DoubleDouble

SLICES = 4


class BoundedProduct(NamedTuple):
    """value: the product; error: a bound of what each of its entries is off by."""

    value: DoubleDouble
    error: np.ndarray


def product(a: DoubleDouble, b: DoubleDouble) -> BoundedProduct:
    """The matrix product a b."""
    bits = (53 - max(1, a.hi.shape[1]).bit_length()) // 2
    left, right = _slices(a, 1, bits), _slices(b, 0, bits)
    terms = [one @ other for reach in range(SLICES - 1, -1, -1) for i, one in enumerate(left)
             for j, other in enumerate(right) if i + j == reach]
    shape = (len(a.hi), b.hi.shape[1])
    total = DoubleDouble(np.zeros(shape), np.zeros(shape))
    for term in terms:
        total = dd.added(total, DoubleDouble(term, np.zeros(shape)))
    size = abs(a.hi).max(axis=1, initial=0.0)[:, None] * abs(b.hi).max(axis=0, initial=0.0)
    return BoundedProduct(total, a.hi.shape[1] * (SLICES + 2) * 2.0 ** (2 - SLICES * bits) * size)


def exactly(a: np.ndarray) -> DoubleDouble:
    """Floats as pairs."""
    return DoubleDouble(a, np.zeros_like(a))


def _slices(a: DoubleDouble, axis: int, bits: int) -> list[np.ndarray]:
    """Parts of so many bits each, of rows (axis 1) or columns (axis 0), whose sum is a but for what is below them."""
    rest, found = a.hi, []
    for number in range(SLICES):
        top = np.frexp(abs(rest).max(axis=axis, keepdims=True, initial=0.0))[1]
        much = np.ldexp(1.5, top - bits + 52)
        part = (rest + much) - much
        if not part.any():
            break
        found.append(part)
        rest = rest - part
        if number == 1:         # what is left has room for the lower halves
            rest = rest + a.lo
    return found
