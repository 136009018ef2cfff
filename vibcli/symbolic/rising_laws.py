"""Laws F(d) of parts in series to one side of rest, each up to where it ceases to rise."""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.branch_of_law import GRID, LEVEL

if TYPE_CHECKING:
    from collections.abc import Callable

    Laws = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]

PLACES = np.concatenate(([0.0], GRID))
HALVINGS = 80
SAME = 1e-9             # relative: tops of forces that are equal
FALLS = ("a part in series falls from rest: undeformed it is not stable",
         "parts in series need laws that rise from zero deflection")
LEVEL_TWICE = ("two parts in series are level over a stretch, or one is and another gives way: their inner equilibria "
               "are not found", "put a body between them, or give one of them some stiffness everywhere")
TOGETHER = ("two parts in series give way at one force: which of them goes first is open",
            "make one a little stronger, or put a body between them")


class RisingLaws:
    """laws(d): (forces, slopes) at an array d of the shape (count, places); sense: the sign of d, which is left out of
    deflections and forces. PhysicsError where a law falls from rest.

    `tops`, `peaks`: the deflection and the force at which each ceases to rise, inf where it does not."""

    def __init__(self, laws: "Laws", count: int, sense: int) -> None:
        self.laws, self.count, self.sense = laws, count, sense
        self.F, self.slopes = self.at(np.array([PLACES] * count))
        self._ends = [self._end(i) for i in range(count)]
        self.tops, self.peaks = np.array([self._top(i) for i in range(count)]).T

    @np.errstate(all="ignore")
    def at(self, d: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(forces, slopes)."""
        F, slopes = self.laws(self.sense * d)
        return self.sense * F, slopes

    @np.errstate(invalid="ignore")
    def _end(self, i: int) -> int:
        """The number of the last place up to which a law rises, or is level."""
        F, slope = self.F[i], self.slopes[i]
        falls = ~(F[1:] - F[:-1] >= -LEVEL * np.abs(F[1:])) | (slope[1:] < 0)
        if slope[0] < 0 or falls[0]:
            raise PhysicsError(*FALLS)
        found = np.flatnonzero(falls)
        return int(found[0]) if found.size else len(F) - 1

    def _top(self, i: int) -> tuple[float, float]:
        k = self._ends[i]
        if k == len(PLACES) - 1:
            return np.inf, np.inf
        low, high = PLACES[max(k - 1, 0)], PLACES[k + 1]
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            F, slope = (row[i, 0] for row in self.at(np.full((self.count, 1), middle)))
            low, high = (middle, high) if np.isfinite(F) and slope > 0 else (low, middle)
        return low, self.at(np.full((self.count, 1), low))[0][i, 0]

    def weak(self) -> int:
        """The number of the part that gives way first, or is level; PhysicsError where this is open."""
        level = [i for i in range(self.count) if np.any(np.diff(self.F[i, :self._ends[i] + 1]) == 0)]
        i = int(np.argmin(self.peaks))
        gives_way = bool(np.isfinite(self.peaks[i]))
        if len(level) > 1 or (level and gives_way and level != [i]):
            raise PhysicsError(*LEVEL_TWICE)
        if gives_way and np.sum(self.peaks <= self.peaks[i] + SAME * abs(self.peaks[i])) > 1:
            raise PhysicsError(*TOGETHER)
        return level[0] if level else i

    @np.errstate(invalid="ignore")
    def inverse(self, i: int, f: np.ndarray) -> np.ndarray:
        """d, of the shape of f, at which a law has a force f ≥ 0 before it ceases to rise, by bisection; NaN where it
        does not."""
        k = self._ends[i]
        heights, places = self.F[i, :k + 1], PLACES[:k + 1]
        if np.isfinite(self.tops[i]):
            rises = heights < self.peaks[i]
            heights, places = np.append(heights[rises], self.peaks[i]), np.append(places[rises], self.tops[i])
        after = np.clip(np.searchsorted(heights, f, side="left"), 1, len(heights) - 1)
        low, high = places[after - 1], places[after]
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            below = self.at(np.array([middle] * self.count))[0][i] < f
            low, high = np.where(below, middle, low), np.where(below, high, middle)
        return np.where(f == 0, 0.0, np.where((f > 0) & (f <= heights[-1]), high, np.nan))
