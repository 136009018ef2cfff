"""H(s) of coordinates in a row, each coupled to its neighbours alone, by continued fractions, all frequencies at once.

With D = K + sC + s²M tridiagonal, pivots from the first coordinate on and from the last one back,

    δᵢ = Dᵢᵢ − Dᵢ,ᵢ₋₁ Dᵢ₋₁,ᵢ/δᵢ₋₁,    εᵢ = Dᵢᵢ − Dᵢ,ᵢ₊₁ Dᵢ₊₁,ᵢ/εᵢ₊₁,    γᵢ = δᵢ + εᵢ − Dᵢᵢ = 1/(D⁻¹)ᵢᵢ,

a unit at l makes xₗ = 1/γₗ, xᵢ = −Dᵢ,ᵢ₊₁ xᵢ₊₁/δᵢ below it and xᵢ = −Dᵢ,ᵢ₋₁ xᵢ₋₁/εᵢ above it (twisted factorisation:
Parlett & Dhillon 1997, Linear Algebra Appl. 267, 247). Nothing has to be exchanged: however small a pivot is, what
follows is that of a matrix whose entries are off by some rounding of their own size. So is H, but for the rounding of
its product, of which every factor adds less than Σ |yᵢ| |δDᵢⱼ| |xⱼ| does with a row on the way. Where a pivot is zero,
or D singular but for rounding, it is left to another method.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from vibcli.analyses.frequency_response.direct import SINGULAR, repaired
from vibcli.base.named_tuple import NamedTuple
from vibcli.base.work import counted
from vibcli.numerics.fixed_point import MILLION

BLOCK = 2.0**14         # frequencies times coordinates that are eliminated at once
PRODUCTS = 24           # for a frequency and a coordinate


def in_a_row(system: Any) -> tuple[int, int] | None:
    """(the coordinate that the input acts on, the one that is the output); None where the coordinates stand in no row,
    or input or output are more than the place of one."""
    parts, ends = (system.K, system.C, system.M), [np.flatnonzero(row[0]) for row in (system.b, system.c)]
    if any(len(places) != 1 for places in ends) or any(
            part.any() for part in (system.b[1:], system.c[1:], np.asarray(system.d))) or any(
            map(np.iscomplexobj, (*parts, system.b, system.c))):
        return None
    if any(np.triu(part, 2).any() or np.tril(part, -2).any() for part in parts):
        return None
    return int(ends[0][0]), int(ends[1][0])


class Row:
    """K, C and M by their diagonals: (3, n), and above and below it (3, n − 1)."""

    __slots__ = ("above", "below", "diagonal", "ends", "otherwise")

    def __init__(self, system: Any, ends: tuple[int, int], otherwise: Any) -> None:
        self.ends, self.otherwise = ends, otherwise
        self.diagonal, self.above, self.below = (
            np.stack([np.diagonal(part, k) for part in (system.K, system.C, system.M)]) for k in (0, 1, -1))
        if (self.above == self.below).all():
            self.below = self.above

    def __call__(self, system: Any, s: np.ndarray,
                 steep: bool = False) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
        """(H, dH/ds or None, whether there is a pole)."""
        values, slopes, lost = self._together(self._sloped if steep else self._valued, system, s)
        return repaired(system, s, values, slopes, np.flatnonzero(lost), self.otherwise)

    def fields(self, system: Any, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(D⁻¹b, D⁻ᵀc), (N, n) each."""
        x, y, lost = self._together(self._fields, system, s)
        x, y = x.T, y.T
        if lost.any():
            x[lost], y[lost] = self.otherwise.fields(system, s[lost])
        return x, y

    def _together(self, find: Callable[..., Any], system: Any, s: np.ndarray) -> list[Any]:
        many = max(1, int(BLOCK / system.n))
        parts = [find(system, s[k:k + many]) for k in range(0, max(len(s), 1), many)]
        return [None if part[0] is None else np.concatenate(part, axis=-1) for part in zip(*parts, strict=True)]

    def _valued(self, system: Any, s: np.ndarray) -> tuple[np.ndarray, None, np.ndarray]:
        pivots, lost = self._pivots(s)
        at, to = self.ends
        way = _factors(pivots, at)[min(at, to):max(at, to) + 1]
        return way.prod(axis=0) * (system.b[0, at] * system.c[0, to]), None, lost

    def _sloped(self, system: Any, s: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """dH/ds = −yᵀ D′ x."""
        x, y, lost = self._fields(system, s)
        turned = (y * x * _slopes(self.diagonal, s)).sum(axis=0)
        if self.above is self.below:
            turned += ((y[:-1] * x[1:] + y[1:] * x[:-1]) * _slopes(self.above, s)).sum(axis=0)
        else:
            turned += (y[:-1] * x[1:] * _slopes(self.above, s) + y[1:] * x[:-1] * _slopes(self.below, s)).sum(axis=0)
        to = self.ends[1]
        return x[to] * system.c[0, to], -turned, lost

    def _fields(self, system: Any, s: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        pivots, lost = self._pivots(s)
        at, to = self.ends
        turned = pivots._replace(above=pivots.below, below=pivots.above)
        return _field(pivots, at) * system.b[0, at], _field(turned, to) * system.c[0, to], lost

    def _pivots(self, s: np.ndarray) -> "tuple[Pivots, np.ndarray]":
        """(Pivots, whether D is singular but for rounding) at each s."""
        counted(len(s) * self.diagonal.shape[1] * PRODUCTS / MILLION)
        above = _entries(self.above, s)
        below = above if self.above is self.below else _entries(self.below, s)
        pivots = _eliminated(_entries(self.diagonal, s), above, below)
        near = np.abs(pivots.inverse) / _entries(np.abs(self.diagonal), np.abs(s))
        return pivots, ~(near.min(axis=0) > 64 * SINGULAR * len(near))


def _entries(parts: np.ndarray, s: np.ndarray) -> np.ndarray:
    """K + sC + s²M of so many entries, (m, N), or (m, 1) where they do not change."""
    K, C, M = parts[:, :, None]
    if M.any():
        found: np.ndarray = K + s * (C + s * M)
        return found
    result: np.ndarray = K + s * C if C.any() else K
    return result


def _slopes(parts: np.ndarray, s: np.ndarray) -> np.ndarray:
    """C + 2sM of so many entries, (m, N), or (m, 1) where they do not change."""
    _, C, M = parts[:, :, None]
    found: np.ndarray = C + 2 * s * M if M.any() else C
    return found


class Pivots(NamedTuple):
    """D above and below its diagonal, (n − 1, N) or (n − 1, 1), and δ, ε, γ, (n, N)."""

    above: np.ndarray
    below: np.ndarray
    ahead: np.ndarray
    back: np.ndarray
    inverse: np.ndarray


def _eliminated(diagonal: np.ndarray, above: np.ndarray, below: np.ndarray) -> Pivots:
    """The Pivots from D's diagonal, (n, N), and from what is above and below it; not finite beyond one that is zero."""
    both, between = (np.stack([part, part[::-1]], axis=1) for part in (diagonal, above * below))
    less = np.empty_like(both[1:])
    with np.errstate(all="ignore"):
        for product, pivot, rest, following in zip(between, both[:-1], less, both[1:], strict=True):
            np.divide(product, pivot, rest)
            np.subtract(following, rest, following)
    ahead, back = both[:, 0], both[::-1, 1]
    inverse = ahead.copy()
    inverse[:-1] -= less[::-1, 1]
    return Pivots(above, below, ahead, back, inverse)


def _factors(pivots: Pivots, at: int) -> np.ndarray:
    """xₗ of a unit at l, and what each other coordinate moves by over its neighbour on the side of l: (n, N)."""
    found = np.empty_like(pivots.ahead)
    with np.errstate(all="ignore"):
        found[at] = 1 / pivots.inverse[at]
        np.divide(-pivots.above[:at], pivots.ahead[:at], out=found[:at])
        np.divide(-pivots.below[at:], pivots.back[at + 1:], out=found[at + 1:])
    return found


def _field(pivots: Pivots, at: int) -> np.ndarray:
    """D⁻¹ of a unit at a coordinate, (n, N)."""
    found = _factors(pivots, at)
    with np.errstate(all="ignore"):
        np.multiply.accumulate(found[at:], axis=0, out=found[at:])
        np.multiply.accumulate(found[at::-1], axis=0, out=found[at::-1])
    return found
