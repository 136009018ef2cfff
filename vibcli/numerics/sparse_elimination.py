"""Elimination without exchanges, A = L diag(d) Lᴴ, of many symmetric or Hermitian matrices of one pattern at a time.

As many of the d are negative as of the eigenvalues of A (Sylvester). What rounds is told entry by entry: the sum of the
magnitudes of what an entry was added from.
"""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple

MAY_TURN = "cO"     # kinds of arrays: complex floats, and numbers of more digits, which may be complex


class EliminationStep(NamedTuple):
    """One coordinate to eliminate: its later neighbours, ascending; the places of its column, and which of these hold
    the conjugate; the places that change, entry (a, b) by column[first] · conj(column[second])."""

    pivot: int
    after: list[int]
    column: np.ndarray
    conjugate: np.ndarray
    changed: np.ndarray
    first: np.ndarray
    second: np.ndarray


class Pattern:
    """The entries that a matrix of n rows has, or gains: that with fewest neighbours is eliminated first.

    places: {(i, j): place}, i <= j, the diagonal at places 0 … n − 1; size: how many; steps: in order; above: the
    arrays i, j of the places beyond the diagonal.
    """

    __slots__ = ("above", "n", "places", "steps")

    def __init__(self, n: int, pairs: Iterable[tuple[int, int]]) -> None:
        near: list[set[int]] = [set() for _ in range(n)]
        self.n, self.places, self.steps = n, {(i, i): i for i in range(n)}, []
        for i, j in pairs:
            self._tie(near, i, j)
        left = set(range(n))
        while left:
            pivot = min(left, key=lambda k: (len(near[k]), k))
            left.remove(pivot)
            after = sorted(near[pivot])
            for j in after:
                near[j].discard(pivot)
                for k in after:
                    self._tie(near, j, k)
            self.steps.append(self._step(pivot, after))
        pairs = np.array(list(self.places), int).reshape(-1, 2)[n:]
        self.above = pairs[:, 0], pairs[:, 1]

    @property
    def tree(self) -> bool:
        """Has each coordinate at most one later neighbour? Then rounding is that of the entries, whatever grows, as
        with Sturm sequences."""
        return all(len(step.after) < 2 for step in self.steps)

    @property
    def parts(self) -> list[list[int]]:
        """The rows that entries tie to one another, directly or by others, in the order of their first."""
        homes: dict[int, int] = {}
        for step in reversed(self.steps):
            homes[step.pivot] = homes[step.after[0]] if step.after else step.pivot
        found: dict[int, list[int]] = {}
        for row in range(self.n):
            found.setdefault(homes[row], []).append(row)
        return list(found.values())

    @property
    def size(self) -> int:
        """How many entries are kept."""
        return len(self.places)

    def _tie(self, near: Sequence[set[int]], i: int, j: int) -> None:
        if i != j:
            near[i].add(j)
            near[j].add(i)
            self.places.setdefault((min(i, j), max(i, j)), len(self.places))

    def _step(self, pivot: int, after: list[int]) -> EliminationStep:
        pairs = [(a, b) for a in range(len(after)) for b in range(a, len(after))]
        column = [self.places[min(pivot, j), max(pivot, j)] for j in after]
        changed = [self.places[after[a], after[b]] for a, b in pairs]
        first, second = zip(*pairs, strict=True) if pairs else ((), ())
        turned = np.array([j > pivot for j in after], bool)[:, None]
        return EliminationStep(pivot, after, np.array(column, int), turned, np.array(changed, int),
                               np.array(first, int), np.array(second, int))


class Elimination:
    """The factors of matrices whose entries are the columns of an array (size of the pattern, matrices).

    pivots: d, (n, matrices), real.
    """

    __slots__ = ("columns", "pattern", "pivots")

    def __init__(self, pattern: Pattern, entries: np.ndarray, tiny: np.ndarray) -> None:
        """tiny: what takes the place of a pivot that is exactly zero, (n, 1) or (n, matrices)."""
        work, n = entries.copy(), pattern.n
        self.pattern, self.columns, turning = pattern, [], work.dtype.kind in MAY_TURN
        self.pivots = _real(work[:n]).copy() if turning else work[:n].copy()
        tiny = np.broadcast_to(tiny, self.pivots.shape)
        for step in pattern.steps:
            pivot = _real(work[step.pivot]) if turning else work[step.pivot]
            pivot = np.where(pivot == 0, tiny[step.pivot], pivot)
            self.pivots[step.pivot] = pivot
            column = work[step.column]
            if turning:
                column = np.where(step.conjugate, column.conj(), column)
            factor = column / pivot
            self.columns.append(factor)
            work[step.changed] -= factor[step.first] * (column[step.second].conj() if turning else column[step.second])

    @property
    def products(self) -> np.ndarray:
        """What rounds: the magnitudes of all that was subtracted from each entry."""
        found = np.zeros((self.pattern.size, self.pivots.shape[1]), self.pivots.dtype)
        for step, factor in zip(self.pattern.steps, self.columns, strict=True):
            column = factor[step.second] * self.pivots[step.pivot]
            found[step.changed] += abs(factor[step.first] * column)
        return found

    def negative(self) -> np.ndarray:
        """How many eigenvalues of each matrix are negative."""
        found: np.ndarray = (self.pivots < 0).sum(axis=0)
        return found

    def solved(self, loads: np.ndarray) -> np.ndarray:
        """x of A x = load, both (n, matrices)."""
        x = loads.copy()
        for step, factor in zip(self.pattern.steps, self.columns, strict=True):
            x[step.after] -= factor * x[step.pivot]
        x /= self.pivots
        for step, factor in zip(reversed(self.pattern.steps), reversed(self.columns), strict=True):
            if step.after:
                x[step.pivot] -= (np.conj(factor) * x[step.after]).sum(axis=0)
        return x


def _real(entries: np.ndarray) -> np.ndarray:
    """The real parts, which NumPy does not take of objects."""
    return entries.real if entries.dtype.kind != "O" else np.array(
        [x.real for x in entries.flat], object).reshape(entries.shape)


def quadratic(pattern: Pattern, entries: np.ndarray, x: np.ndarray, y: Any = None) -> np.ndarray:
    """xᴴ A y of each matrix, y = x where not given, of which it is real; x, y are (n, matrices)."""
    of, (i, j), a = x if y is None else y, pattern.above, entries[pattern.n:]
    found = ((np.conj(x) * entries[:pattern.n] * of).sum(axis=0)
             + (np.conj(x[i]) * a * of[j] + np.conj(x[j]) * np.conj(a) * of[i]).sum(axis=0))
    return _real(found) if y is None else found


def product(pattern: Pattern, entries: np.ndarray, x: np.ndarray) -> np.ndarray:
    """A x of each matrix, x and the answer (n, matrices)."""
    i, j = pattern.above
    found, a = entries[:pattern.n] * x, entries[pattern.n:]
    np.add.at(found, i, a * x[j])
    np.add.at(found, j, np.conj(a) * x[i])
    result: np.ndarray = found
    return result
