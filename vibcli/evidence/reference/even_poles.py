"""Poles of members and their residues that are, from some number n on, smooth functions of 1/n, or those of every other
one are: of a beam without places between its ends

    p = i ω₀ n² (1 + a₁/n + a₂/n² + …),       Res = n⁻ʳ (b₀ + b₁/n + …)

so that few of them, known to many digits, give all others (Lagrange's polynomials in 1/n, of p/n² and of residues).
"""

from bisect import bisect_left
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.evidence.reference.member_residues import PoleResidues

LOWEST = 36             # number of the first pole that is taken
NEAR, FAR = 1.08, 1.4           # times that of the next one to each, of those at hand and beyond
FAMILIES = 1, 2, 4              # every how many-th poles may be alike
THROUGH, SPARED = 12, 2         # poles that a polynomial passes through; of these at either end, where few digits count
EVEN = 1e-18                    # of a pole, and of the largest residue of its family: the distance to the polynomial


class KnownPole(NamedTuple):
    """number; values: [p/n², residues …]."""

    number: int
    values: list[Any]


class EvenPoles:
    """Those of a signal."""

    def __init__(self, residues: "PoleResidues", every: int) -> None:
        self._residues, self._every = residues, every
        self._families = [self._known(offset) for offset in range(every)]

    def _known(self, offset: int) -> list[KnownPole]:
        """Of a family, as far as all are at hand."""
        found, number, few = [], LOWEST + offset, self._residues.few
        while number <= len(few):
            p, values = few[number - 1]
            found.append(KnownPole(number, [p / number**2, *values]))
            number = self._next(number)
        return found

    def _next(self, number: int) -> int:
        growth = NEAR if number < len(self._residues.few) else FAR
        return number + self._every * max(1, round((growth - 1) * number / self._every))

    @property
    def are_even(self) -> bool:
        """Does a polynomial through others tell the last of those at hand?"""
        return all(len(known) > THROUGH and self._told(known) for known in self._families)

    def _told(self, known: list[KnownPole]) -> bool:
        *before, last = known
        found = _at(before[-THROUGH:], last.number)
        sizes = [max(abs(one.values[k]) for one in known) for k in range(len(last.values))]
        return all(abs(x - y) <= EVEN * size for x, y, size in zip(found, last.values, sizes, strict=True))

    def exactly(self, first: int, last: int) -> list[tuple[mpmath.mpc, list[mpmath.mpc]]]:
        """[(p, residues)] of the poles of these numbers, at the working precision."""
        found = []
        for number in range(first, last + 1):
            p, *values = _at(self._about(number), number)
            found.append((p * number**2, values))
        return found

    def _about(self, number: int) -> list[KnownPole]:
        """The known ones of its family through which its polynomial passes."""
        known = next(one for one in self._families if (number - one[0].number) % self._every == 0)
        while known[-1 - SPARED].number < number:
            self._extend(known)
        place = bisect_left([one.number for one in known], number)
        start = min(max(place - THROUGH // 2, 0), len(known) - THROUGH)
        return known[start:start + THROUGH]

    def between(self, first: int, last: int) -> tuple[np.ndarray, np.ndarray]:
        """(p, residues, each source a row) of the poles of these numbers, in longer floats."""
        found = np.empty((len(self._families[0][0].values), last - first + 1), np.clongdouble)
        for offset in range(self._every):
            numbers = np.arange(first + offset, last + 1, self._every)
            while len(numbers):
                known = self._about(int(numbers[0]))[SPARED:-SPARED]
                beyond = next(one.number for one in known if one.number >= numbers[0])
                here, numbers = numbers[numbers <= beyond], numbers[numbers > beyond]
                found[:, here - first] = _in_longer_floats(known, here)
        return found[0], found[1:]

    def _extend(self, known: list[KnownPole]) -> None:
        number = self._next(known[-1].number)
        near = _at(known[-THROUGH:], number)[0] * number**2
        p, values = self._residues.exact(near)
        known.append(KnownPole(number, [p / number**2, *values]))


def even_poles(residues: "PoleResidues") -> EvenPoles | None:
    """Those of a signal, where they are even."""
    found = (EvenPoles(residues, every) for every in FAMILIES)
    return next((one for one in found if one.are_even), None)


def _at(known: list[KnownPole], number: int) -> list[mpmath.mpc]:
    """What polynomials through these give of another one."""
    weights = [mpmath.fprod((mpmath.mpf(1) / number - mpmath.mpf(1) / other.number)
                            / (mpmath.mpf(1) / one.number - mpmath.mpf(1) / other.number)
                            for other in known if other is not one) for one in known]
    return [mpmath.fsum(w * x for w, x in zip(weights, part, strict=True))
            for part in zip(*(one.values for one in known), strict=True)]


def _in_longer_floats(known: list[KnownPole], numbers: np.ndarray) -> np.ndarray:
    """The same of many, [p, residues …] a row each."""
    n = numbers.astype(np.longdouble)
    total = np.zeros((len(known[0].values), len(n)), np.clongdouble)
    for one in known:
        weight = np.ones(len(n), np.longdouble)
        for other in known:
            if other is not one:        # (1/n − 1/m)/(1/k − 1/m)
                weight *= (other.number - n) * one.number / ((other.number - one.number) * n)
        total += np.multiply.outer(np.array([_long(x) for x in one.values]), weight)
    total[0] *= n * n
    return total


def _long(x: Any) -> Any:
    return np.clongdouble(np.longdouble(mpmath.nstr(mpmath.re(x), 25))
                          + 1j * np.longdouble(mpmath.nstr(mpmath.im(x), 25)))
