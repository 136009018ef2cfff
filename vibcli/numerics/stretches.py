"""Curves along a line in stretches, between which they may jump: their zeros and extremes."""

from collections.abc import Callable
from typing import Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.bracketing import maxima_between, zeros_between

PARTS, SECTIONS = 48, 34        # by which a stretch is shown; of a search for an extreme, which may be a corner
STEEP, ROUNDS = 0.12, 9         # of the range: more from one place to the next is a front, which is closed in upon
NOTHING, FLAT = 1e-11, 1e-9     # of the largest value, what is zero; of it and of the range, what is even


def kept(values: Callable[[np.ndarray], np.ndarray]) -> Callable[[np.ndarray], np.ndarray]:
    """The same function of places, found once for each array of them: curves are looked at again and again there."""
    known: dict[bytes, np.ndarray] = {}

    def at(places: np.ndarray) -> np.ndarray:
        asked = places.tobytes()
        if asked not in known:
            known[asked] = values(places)
        return known[asked].copy()
    return at


class CurveStretch(NamedTuple):
    """A curve from `start` to `end`, `values(places)` giving an array; as many `parts` show it where it is smooth."""

    start: float
    end: float
    values: Callable[[np.ndarray], Any]
    parts: int = PARTS

    def points(self) -> tuple[np.ndarray, np.ndarray]:
        """(places, values), ends and extremes among them."""
        places = np.linspace(self.start, self.end, self.parts + 1)
        values = np.asarray(self.values(places), float)
        for _ in range(ROUNDS):
            steep = np.flatnonzero(np.abs(np.diff(values)) > STEEP * np.ptp(values))
            if not len(steep):
                break
            middle = (places[steep] + places[steep + 1]) / 2
            places = np.insert(places, steep + 1, middle)
            values = np.insert(values, steep + 1, self.values(middle))
        return places, values

    def extremes(self) -> list[float]:
        """The places within at which the curve turns."""
        places, values = self.points()
        if np.ptp(values) <= FLAT * np.abs(values).max():
            return []
        rises = np.diff(values)
        rises = np.sign(np.where(np.abs(rises) > FLAT * np.ptp(values), rises, 0.0))
        found = []
        for sense in (1.0, -1.0):
            turns = np.flatnonzero((sense * rises[:-1] > 0) & (sense * rises[1:] <= 0)) + 1
            found += maxima_between(lambda x, sense=sense: sense * np.asarray(self.values(x)), places[turns - 1],
                                    places[turns + 1], SECTIONS).tolist() if len(turns) else []
        return sorted(found)

    def zeros(self, largest: float) -> list[float]:
        """The places within at which the curve changes its sign; `largest`: the size by which zero is told."""
        places, values = self.points()
        if not np.abs(values).max() > NOTHING * largest:
            return []
        values[np.abs(values) <= NOTHING * largest] = 0.0
        touched = [float(x) for x, before, y, after in zip(places[1:], values, values[1:], values[2:], strict=False)
                   if y == 0 and before * after < 0]
        turns = np.flatnonzero(values[:-1] * values[1:] < 0)
        between = zeros_between(self.values, places[turns], places[turns + 1]) if len(turns) else np.empty(0)
        return sorted([*touched, *between.tolist()])
