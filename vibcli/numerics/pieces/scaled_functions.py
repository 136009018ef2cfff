"""The functions that uniform pieces are made of, without overflow and without loss of digits.

C(z) = cosh √z and S(z) = sinh √z / √z are entire; S′ is dS/dz. They are handed on times e^{−r}, r = Re √z ≥ 0.
"""

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.numerics.pieces.arithmetic import Arithmetic

SMALL = 1.0         # |z| up to which C, S and S′ are summed as power series
ALIKE = 4.0         # |A|, |B| up to which functions of two roots are


class Even(NamedTuple):
    """C, S and S′ at z, each times e^{−r}, arrays."""

    c: np.ndarray
    s: np.ndarray
    slope: np.ndarray
    r: np.ndarray


def even_functions(z: np.ndarray, numbers: "Arithmetic") -> Even:
    """C, S and S′ of an array."""
    near = np.abs(z) <= SMALL
    count = np.count_nonzero(near)
    if count == near.size:
        return _series(z, numbers)
    if not count:
        return _exponentials(z, numbers)
    series, closed = _series(z[near], numbers), _exponentials(z[~near], numbers)
    return Even(*(merged(near, one, other) for one, other in zip(series, closed, strict=True)))


def even_functions_of(z: "Sequence[np.ndarray]", numbers: "Arithmetic") -> list[Even]:
    """C, S and S′ of several flat arrays of equal length: of doubles of one type at once, which costs no more than
    one."""
    if numbers.number is not None or len({values.dtype for values in z}) > 1:
        return [even_functions(values, numbers) for values in z]
    found = even_functions(np.concatenate(z), numbers)
    return [Even(*parts) for parts in zip(*(values.reshape(len(z), *z[0].shape) for values in found), strict=True)]


def merged(chosen: np.ndarray, inside: np.ndarray, outside: np.ndarray) -> np.ndarray:
    """One array of two: where chosen the values of the first in their order, elsewhere those of the second."""
    found = np.empty(chosen.shape, np.result_type(inside, outside))
    found[chosen], found[~chosen] = inside, outside
    return found


def terms(size: float, numbers: "Arithmetic") -> int:
    """How many terms zᵏ/(2k)! a series needs for |z| ≤ size."""
    return _terms(size, numbers.eps)


@cache
def _terms(size: float, eps: float) -> int:
    term, k = 1.0, 0
    while term > eps / 64:
        k += 1
        term *= size / (2 * k * (2 * k - 1))
    return k + 1


def _series(z: np.ndarray, numbers: "Arithmetic") -> Even:
    """By Horner's rule from the last term, all at once: C = Σ zᵏ/(2k)!, S = Σ zᵏ/(2k+1)!, S′ = Σ k zᵏ⁻¹/(2k+1)!."""
    found = np.stack([z * 0 + 1] * 3)
    for divisors in _divisors(terms(SMALL, numbers), z.ndim):
        found = 1 + found * z / divisors
    c, s, slope = found
    return Even(c, s, slope / 6, np.abs(z) * 0)


@cache
def _divisors(count: int, dimensions: int) -> list[np.ndarray]:
    """What each term of C, S and S′ is divided by beside the one before, the last first, (3, 1, …)."""
    return [np.array([2 * k * (2 * k + more) for more in (-1, 1, 3)]).reshape(3, *[1] * dimensions)
            for k in range(count, 0, -1)]


def _exponentials(z: np.ndarray, numbers: "Arithmetic") -> Even:
    if numbers.number is None and numbers.is_real(z):
        return _of_reals(z)
    p = numbers.sqrt(z)
    r = numbers.real(p)
    forward, backward = numbers.exp(p - r), numbers.exp(-p - r)
    c, s = (forward + backward) / 2, (forward - backward) / (2 * p)
    if numbers.is_real(z):
        c, s = numbers.real(c), numbers.real(s)
    return Even(c, s, (c - s) / (2 * z), r)


def _of_reals(z: np.ndarray) -> Even:
    """Cosines and sines where z < 0; doubles."""
    p, waves = np.sqrt(np.abs(z)), z < 0
    count = np.count_nonzero(waves)
    if count == waves.size:
        c, s, r = np.cos(p), np.sin(p) / p, 0 * p
    else:
        fading = np.exp(-2 * p)
        c, s, r = (1 + fading) / 2, (1 - fading) / (2 * p), p
        if count:
            c, s, r = np.where(waves, np.cos(p), c), np.where(waves, np.sin(p) / p, s), np.where(waves, 0.0, r)
    return Even(c, s, (c - s) / (2 * z), r)
