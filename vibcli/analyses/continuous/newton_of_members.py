"""Damped modes of members from many places at once: Newton's steps for the whole matrix, (D + δ D′) x = 0.

As D is symmetric its vectors are those of both sides: x is divided by √(xᵀD′x), so that D⁻¹ = Σ x xᵀ/(s − λ).
"""

from types import MappingProxyType
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.argument_count import sizes
from vibcli.analyses.continuous.counting import GUARD, SLACK
from vibcli.analyses.continuous.damped_roots import GIVEN
from vibcli.analyses.continuous.dynamic_matrix import SHARES
from vibcli.analyses.continuous.short_pieces import bends
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.fixed_point import count_floats

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix
    from vibcli.mechanics.factored_system import PlacedPiece

STEPS, SETTLED, SLOW = 14, 1e-11, 1e-3
UNIT = 2.0**-53
ALIKE, SAME = 1e-9, 1e-12       # relative distance of roots that are looked at together, and of those that are one
WHOLE = 4.0         # times their natural size up to which pieces stay whole: rounding grows as they do
ENTRIES = 2**19         # of matrices that are held at once


class ShapesOf(NamedTuple):
    """Roots of which the same pieces move: their numbers, and x over the coordinates of the rows of these, (roots, n);
    bends: u₀, θ₀, F, P of short ones, {place among the pieces: (roots, 4)}."""

    pieces: "Sequence[PlacedPiece]"
    numbers: np.ndarray
    shapes: np.ndarray
    bends: "Mapping[int, np.ndarray]" = MappingProxyType({})

    def among(self, numbers: np.ndarray, count: int) -> "ShapesOf":
        """Those of the first `count` roots, which are numbered anew."""
        kept = numbers < count
        bends = {place: own[kept] for place, own in self.bends.items()}
        return ShapesOf(self.pieces, numbers[kept], self.shapes[kept], bends)


def settled_from(divisions: "Divisions", starts: np.ndarray, inner: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Where Newton's steps lead from places, and from ones near frequencies of held pieces; and where these only come
    ever nearer."""
    found = _followed(divisions, starts), _followed(divisions.inner, inner)
    settled, slow = (np.concatenate(part) for part in zip(*found, strict=True))
    return settled, slow


class Divisions:
    """A matrix, and the same with nodes within its pieces for those s at which these vibrate with their ends held."""

    def __init__(self, matrix: "DynamicMatrix", whole: bool = True) -> None:
        self.matrix, self._whole = matrix, whole and matrix.n > 0
        self._matrices = [matrix] * self._whole + [matrix.divided(share) for share in SHARES]

    @property
    def inner(self) -> "Divisions":
        """The same with nodes within pieces for all s."""
        return Divisions(self.matrix, False)

    def parts(self, s: np.ndarray) -> "Iterator[tuple[Any, ...]]":
        """(matrix, numbers of s, D, D′, units, √ of the dampers in these): D and D′ (numbers, n, n) with units in which
        the diagonal is 1."""
        block = max(1, ENTRIES // max(one.n for one in self._matrices) ** 2)
        for first in range(0, len(s), block):
            for matrix, at, *rest in self._block(s[first:first + block]):
                yield matrix, at + first, *rest

    def _block(self, s: np.ndarray) -> "Iterator[tuple[Any, ...]]":
        left, found = np.arange(len(s)), []
        with np.errstate(all="ignore"):
            for matrix in self._matrices:
                if not len(left):
                    break
                count_floats(matrix.n, len(left))
                one = matrix.at(s[left], steep=True)
                found.append((matrix, left, one))
                if len(found) == 1 and self._whole:
                    left = left[~(one.excess <= WHOLE)]
            size = np.full((len(found), len(s)), np.inf)
            for row, (_, at, one) in zip(size, found, strict=True):
                row[at] = np.nan_to_num(one.excess, nan=np.inf)
            best = np.argmin(size, axis=0)
            for number, (matrix, at, one) in enumerate(found):
                here = best[at] == number
                if here.any():
                    units = 1 / np.sqrt(np.maximum(sizes(one, s[at]).T[here], 1e-300))
                    D, slope = (np.moveaxis(part, -1, 0)[here].astype(complex) * units[:, :, None] * units[:, None, :]
                                for part in (one.D, one.slope))
                    yield matrix, at[here], D, slope, units, units * np.sqrt(one.given.T[here])


def approached(divisions: Divisions, s: np.ndarray) -> np.ndarray:
    """Where Newton's steps settle."""
    return _followed(divisions, s)[0]


def _followed(divisions: Divisions, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(where Newton's steps settle, where they are still on their way to, as where roots coincide)."""
    s, settled, moving = s.astype(complex), np.zeros(len(s), bool), np.arange(len(s))
    for _ in range(STEPS):
        if not len(moving):
            break
        step = _steps(divisions, s[moving])
        s[moving] += step
        done = abs(step) <= SETTLED * abs(s[moving])
        settled[moving[done]] = True
        kept = ~done & np.isfinite(step)
        moving, step = moving[kept], step[kept]
    slow = moving[abs(step) <= SLOW * abs(s[moving])] if len(moving) else moving
    held, late = (np.where(found.imag < 0, found.conj(), found) for found in (s[settled], s[slow]))
    return held, late


def _steps(divisions: Divisions, s: np.ndarray) -> np.ndarray:
    """The smallest δ with det(D + δ D′) = 0 at each s, NaN where D is not finite."""
    found = np.full(len(s), np.nan, complex)
    for _, at, D, slope, *_ in divisions.parts(s):
        usable = np.isfinite(D).all(axis=(1, 2)) & np.isfinite(slope).all(axis=(1, 2))
        nu = _eigenvalues(_solved(D[usable], slope[usable]))
        largest = np.take_along_axis(nu, np.argmax(abs(nu), axis=1)[:, None], axis=1)[:, 0]
        found[at[usable]] = -1 / np.where(largest == 0, np.nan, largest)
    return found


def _multiplicities(divisions: Divisions, s: np.ndarray) -> np.ndarray:
    """How many λ there are at each s, which is one."""
    found = np.ones(len(s), int)
    away = ALIKE / 3 * s
    for _, at, D, slope, *_ in divisions.parts(s + away):
        nu = _eigenvalues(_solved(D, slope))
        step = away[at][:, None] - 1 / np.where(nu == 0, 1e-300, nu)
        found[at] = np.maximum((abs(step) <= ALIKE * abs(s[at])[:, None]).sum(axis=1), 1)
    return found


def _eigenvalues(matrices: np.ndarray) -> np.ndarray:
    """Of a stack of matrices; NaN of those whose are not found."""
    if matrices.shape[1] == 2:
        return _of_two(matrices)
    try:
        return np.linalg.eigvals(matrices)
    except np.linalg.LinAlgError:
        if len(matrices) > 1:
            return np.concatenate([_eigenvalues(matrix[None]) for matrix in matrices])
        return np.full(matrices.shape[:2], np.nan, complex)


def _of_two(matrices: np.ndarray) -> np.ndarray:
    """Of a stack of 2 × 2 matrices whose diagonals are m ± d: λ = m ± √(d² + bc)."""
    (a, b), (c, d) = np.moveaxis(matrices.astype(complex), 0, -1)
    with np.errstate(all="ignore"):
        middle, root = (a + d) / 2, np.sqrt(((a - d) / 2)**2 + b * c)
    return np.stack([middle + root, middle - root], axis=1)


def _solved(D: np.ndarray, slope: np.ndarray) -> np.ndarray:
    """D⁻¹ D′; where D is singular in floats next to it."""
    try:
        return np.linalg.solve(D, slope)
    except np.linalg.LinAlgError:
        n = D.shape[-1]
        beside = D + UNIT * np.diag(np.arange(1.0, n + 1))
    try:
        return np.linalg.solve(beside, slope)
    except np.linalg.LinAlgError:
        return cast("np.ndarray", np.linalg.pinv(beside) @ slope)


def distinct(roots: np.ndarray) -> np.ndarray:
    """Without those found twice, by |λ|."""
    roots = roots[np.argsort(abs(roots), kind="stable")]
    size, keep = abs(roots), np.ones(len(roots), bool)
    for away in range(1, len(roots)):
        if (size[away:] - size[:-away] > 2 * ALIKE * size[away:]).all():
            break
        same = abs(roots[away:] - roots[:-away]) <= ALIKE * size[away:]
        keep[away:] &= ~(same & keep[:-away])
    return roots[keep]


def polished(divisions: Divisions, s: np.ndarray) -> tuple[np.ndarray, np.ndarray, list[ShapesOf]]:
    """λ to rounding by |λ|, each as often as it is one, their relative bounds, and the ShapesOf."""
    several = _multiplicities(divisions, s)
    first = np.cumsum(several) - several        # the number of each of these
    values, errors, groups = np.repeat(s, several).astype(complex), np.full(several.sum(), np.inf), []
    for matrix, at, D, slope, units, given in divisions.parts(s):
        vectors = np.linalg.svd(D)[2].conj()
        own, x, numbers = [np.arange(len(at))], [vectors[:, -1, :]], [first[at]]
        for k in np.flatnonzero(several[at] > 1):
            m = several[at[k]]
            together = _apart(vectors[k, -m:], D[k], slope[k], abs(s[at[k]]))
            x[0][k] = together[0]
            x.append(together[1:])
            own.append(np.full(m - 1, k))
            numbers.append(first[at[k]] + np.arange(1, m))
        at_own, found, place = (np.concatenate(part) for part in (own, x, numbers))
        residue, steep = (np.einsum("ki,kij,kj->k", found, part[at_own], found) for part in (D, slope))
        steep = np.where(steep == 0, 1e-300, steep)
        values[place] -= residue / steep
        spread = abs(found).sum(axis=1) ** 2
        felt = (abs(found) * given[at_own]).sum(axis=1) ** 2
        errors[place] = UNIT * ((SLACK * GUARD * spread + GIVEN * felt) / abs(steep) / abs(values[place]) + 4)
        p = units[at_own] * found / np.sqrt(steep)[:, None]
        groups.append(placed_shapes(matrix, place, p, s[at][at_own]))
    values = np.where(abs(values.imag) <= 2 * errors * abs(values), values.real, values)
    order = np.argsort(abs(values), kind="stable")
    place = np.argsort(order)
    return values[order], errors[order], [one._replace(numbers=place[one.numbers]) for one in groups]


def placed_shapes(matrix: "DynamicMatrix", numbers: np.ndarray, p: np.ndarray, s: np.ndarray,
                  loads: np.ndarray | float = 0.0) -> ShapesOf:
    """Those of x over the coordinates of a matrix, D(s) x = loads."""
    pieces, shapes = matrix.in_scene(p)
    return ShapesOf(pieces, numbers, shapes, bends(matrix, p, s, loads))


def _apart(x: np.ndarray, D: np.ndarray, slope: np.ndarray, size: float) -> np.ndarray:
    """Vectors of a λ that is several, rows x, so that xᵢᵀ D′ xⱼ = 0: of those that differ a little each its own."""
    steep, residue = x @ slope @ x.T, x @ D @ x.T
    away, turn = np.linalg.eig(np.linalg.solve(steep, -residue))
    if abs(away - away.mean()).max() > SAME * size:
        return cast("np.ndarray", turn.T @ x)
    found: list[np.ndarray] = []
    for _ in range(len(x)):
        candidates = np.concatenate([x, *(x[i:i + 1] + x[i + 1:] for i in range(len(x) - 1))])
        best = candidates[np.argmax(abs(np.einsum("ki,ij,kj->k", candidates, slope, candidates)))]
        best = best / np.linalg.norm(best)
        found.append(best)
        x = x - np.outer(x @ slope @ best / (best @ slope @ best), best)
    return np.array(found)
