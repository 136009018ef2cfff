"""Residues of Laplace images of members in time at their poles: of the first to the working precision, of those that
follow in NumPy's longest floats, as few digits of their small residues count."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np

from vibcli.evidence.reference.member_images import MemberImages
from vibcli.evidence.reference.member_poles import PoleSearch, in_floats
from vibcli.evidence.reference.member_starts import StartedMembers

if TYPE_CHECKING:
    from vibcli.evidence.reference.exponential_polynomials import ExponentialPolynomial

LARGE, MANY = 1e-24, 150    # rounding, of the largest residue, with which these need all digits, and how many may
FEWEST, WORK = 8, 2e5       # of them in any case, and products that eliminations may take
SECANTS = 8
CLOSE = 1e-25           # distance of places at which residues are read, relative


class PoleResidues:
    """Those of images of a signal; sources: of MemberImages, [(right side, fields)] of each of them."""

    def __init__(self, members: StartedMembers, search: PoleSearch,
                 sources: "Callable[..., list[tuple[list[Any], list[ExponentialPolynomial]]]]") -> None:
        self.members, self._search, self._sources, self._floats = members, search, sources, in_floats(members)
        p, c, rounding = self.block(0)
        large = np.flatnonzero((rounding > LARGE * np.abs(c).max(axis=1, keepdims=True)).any(axis=0))
        size = MemberImages(members, mpmath.mpc(1)).size
        first = min(int(large[-1]) + 1 if len(large) else 1, MANY, max(FEWEST, int(WORK / size**3)))
        self.few = [self.exact(exactly(x.real) + 1j * exactly(x.imag)) for x in p[:first]]
        self.rest = p[first:], c[:, first:], rounding[:, first:].sum(axis=0)

    def block(self, number: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(p, residues, what rounding may leave of these) of a block of poles in longer floats."""
        return self._search.with_residues(number, self._floats, self._sources)

    def images(self, s: Any) -> list[mpmath.mpc]:
        """The images at s."""
        images = MemberImages(self.members, s)
        every = self._sources(images)
        found = _solved(images, [right for right, _ in every])
        return [images.signal(x, fields) for x, (_, fields) in zip(found, every, strict=True)]

    def exact(self, near: Any) -> tuple[mpmath.mpc, list[mpmath.mpc]]:
        """(p, [the residue of each image]) of the pole next to a place."""
        p = self._pole(near)
        h = mpmath.mpf(CLOSE) * abs(p)
        return p, [h * (x - y) / 2 for x, y in zip(self.images(p + h), self.images(p - h), strict=True)]

    def _pole(self, near: mpmath.mpc) -> mpmath.mpc:
        """By secants of 1/(bᵀ A⁻¹ b)."""
        def size(s: mpmath.mpc) -> mpmath.mpc:
            images = MemberImages(self.members, s)
            probe = [mpmath.mpf(k % 3 + 1) for k in range(images.size)]
            x, = _solved(images, [probe])
            return 1 / mpmath.fsum(a * b for a, b in zip(probe, x, strict=True))

        one, two = near * (1 + mpmath.mpf(2) ** -50), near
        at_one, at_two = size(one), size(two)
        for _ in range(SECANTS):
            if at_one == at_two:
                break
            one, two, at_one = two, two - at_two * (two - one) / (at_two - at_one), at_two
            if abs(two - one) <= mpmath.mpf(10) ** -(mpmath.mp.dps * 6 // 10) * abs(two):
                break
            at_two = size(two)
        return two


def exactly(x: Any) -> Any:
    """A long float as a number of mpmath."""
    high = float(x)
    return mpmath.mpf(high) + mpmath.mpf(float(x - np.longdouble(high)))


def _solved(images: MemberImages, rights: Sequence[list[int | mpmath.mpc | mpmath.mpf]]) -> list[list[mpmath.mpc]]:
    """The solutions of the whole equations, by elimination with pivots."""
    n = images.size
    A = [[mpmath.mpc(0)] * n + [mpmath.mpc(right[i]) for right in rights] for i in range(n)]
    for (i, j), x in images.whole().items():
        A[i][j] = mpmath.mpc(x)
    for i in range(n):
        biggest = max(map(abs, A[i][:n]))
        A[i] = [x / biggest for x in A[i]]
    for i in range(n):
        best = max(range(i, n), key=lambda k: abs(A[k][i]))
        A[i], A[best] = A[best], A[i]
        for row in A[i + 1:]:
            if row[i]:
                factor = row[i] / A[i][i]
                for k in range(i + 1, len(row)):
                    if A[i][k]:
                        row[k] -= factor * A[i][k]
    found = []
    for k in range(n, n + len(rights)):
        x = [mpmath.mpc(0)] * n
        for i in reversed(range(n)):
            x[i] = (A[i][k] - mpmath.fsum(a * b for a, b in zip(A[i][i + 1:n], x[i + 1:], strict=True))) / A[i][i]
        found.append(x)
    return found
