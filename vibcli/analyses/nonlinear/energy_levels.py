"""Orbits of one conservative degree of freedom in the phase plane: level curves of H = ½ m(q) q̇² + V(q).

    q̇ = ±√(2 (E − V(q))/m(q))

E − V is added up from the place through which a level is asked for, and from where the orbit turns, by ways so short
that what V gains on each is known to rounding (well.py): no difference of energies is taken, so that an orbit is as
sharp next to a saddle and at its turning points as elsewhere.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from vibcli.analyses.nonlinear.well import EPS, Well
from vibcli.base.named_tuple import NamedTuple

CELLS = 400             # ways from end to end of a range
POINTS = 121            # of an orbit from one end to the other
SAME = 256 * EPS        # of the swing of V, from place to place: levels that differ by less are one
APART = 1e-9            # of a range: nearer places are one
HALVINGS = 200


class Orbit(NamedTuple):
    """The upper half of an orbit, from left to right: places q and speeds q̇ ≥ 0; `ends`: does it come to rest there (at
    the left, at the right)? The lower half has −q̇."""

    q: np.ndarray
    v: np.ndarray
    ends: tuple[bool, bool]


class EnergyLevels:
    """Level curves between two places. `places`: those at which levels are asked for, as equilibria; the nearest ones
    of `stops` are they."""

    @np.errstate(all="ignore")      # where V is not defined it is not known
    def __init__(self, well: Well, low: float, high: float, places: Sequence[float]) -> None:
        self.well = well
        known = np.array([q for q in places if low <= q <= high])
        others = np.concatenate((np.linspace(low, high, CELLS + 1), well.breaks(low, high)))
        clear = np.abs(others[:, None] - known[None, :]) > APART * (high - low)
        stops = np.unique(np.concatenate((known, others[clear.all(axis=1)])))
        force, m = well.force(stops), well.inertia(stops)
        self.stops = stops[np.isfinite(force) & np.isfinite(m) & (m > 0)]
        looked = np.unique(np.concatenate((known, self.stops[::CELLS // 8])))
        bounds = [well.rounding(q) for q in looked.tolist()]
        V_error, slope_error = (max((x for x in row if np.isfinite(x)), default=0.0)
                                for row in zip(*bounds, strict=True))
        self.rounding = V_error, slope_error
        self.gains = self._gains(self.stops)
        self.known = well.is_smooth(self.stops[:-1], np.diff(self.stops)) & np.isfinite(self.gains)
        self.gains[~np.isfinite(self.gains)] = 0.0
        self.heights = np.concatenate(([0.0], np.cumsum(self.gains)))

    def _gains(self, stops: np.ndarray) -> np.ndarray:
        """What V gains from each place to the next."""
        return self.well.gain(stops[:-1], np.diff(stops), self.rounding).value

    def index(self, q: float) -> int:
        """Of the stop at a place."""
        return int(np.abs(self.stops - q).argmin())

    def climbs(self, i: int) -> np.ndarray:
        """V at the stops less V at one of them."""
        return np.concatenate((-np.cumsum(self.gains[:i][::-1])[::-1], [0.0], np.cumsum(self.gains[i:])))

    def slack(self, i: int) -> np.ndarray:
        """Bounds of the errors of `climbs`."""
        swings = np.abs(self.gains)
        ways = np.concatenate((np.cumsum(swings[:i][::-1])[::-1], [0.0], np.cumsum(swings[i:])))
        return SAME * ways + 2 * self.rounding[0] * (ways > 0)

    @np.errstate(all="ignore")
    def level(self, i: int, kinetic: float, rests: Sequence[int] = ()) -> list[Orbit]:
        """The orbits of the level that has a kinetic energy at the stop of this number; `rests`: the numbers of stops
        that are equilibria, at which a level that reaches them ends."""
        left = kinetic - self.climbs(i)
        slack = self.slack(i)
        for k in rests:
            if abs(left[k]) <= slack[k]:
                left[k] = 0.0
        return [self._orbit(*ends) for ends in self._ways(left)]

    def _ways(self, left: np.ndarray) -> list[tuple[tuple[float, float], tuple[float, float]]]:
        """[((place, E − V there) of the left end, of the right end)] of the ways on which E − V > 0; where V is not
        known, as at a pole, one ends and another begins."""
        inside = left > 0
        found, start = [], (self.stops[0], left[0]) if inside[0] else None
        for k, (here, there) in enumerate(pairwise(inside.tolist())):
            if here and not (there and self.known[k]):
                end = self._end(k, k + 1, left) if self.known[k] else (self.stops[k], left[k])
                found.append((start, end))
            if there and not (here and self.known[k]):
                start = self._end(k + 1, k, left) if self.known[k] else (self.stops[k + 1], left[k + 1])
        if inside[-1]:
            found.append((start, (self.stops[-1], left[-1])))
        return [(start, end) for start, end in found if end[0] > start[0]]

    def _end(self, inside: int, outside: int, left: np.ndarray) -> tuple[float, float]:
        """(turning point, 0) between two neighbouring stops."""
        if left[outside] == 0:
            return self.stops[outside], 0.0
        start, end, energy = self.stops[inside], self.stops[outside], left[inside]

        def rest(q: float) -> float:
            found: float = energy - self.well.gain(np.array([start]), np.array([q - start]), self.rounding).value[0]
            return found

        low, high, q = start, end, end
        for _ in range(HALVINGS):
            value = rest(q)
            low, high = (q, high) if value > 0 else (low, q)
            slope = self.well.force_at(q)
            trial = q + value / slope if slope else np.nan
            trial = trial if min(low, high) < trial < max(low, high) else 0.5 * (low + high)
            if abs(trial - q) <= EPS * abs(q) or trial in (low, high):
                return trial, 0.0
            q = trial
        return q, 0.0

    def _orbit(self, start: tuple[float, float], end: tuple[float, float]) -> Orbit:
        """From one end to the other, denser towards both."""
        (a, at_a), (b, at_b) = start, end
        shares = 0.5 * (1 - np.cos(np.linspace(0, np.pi, POINTS)))
        within = self.stops[(self.stops > a) & (self.stops < b)]
        q = np.unique(np.concatenate(([a, b], a + (b - a) * shares[1:-1], within)))
        gains = self._gains(q)
        from_a = at_a - np.concatenate(([0.0], np.cumsum(gains)))
        from_b = at_b + np.concatenate((np.cumsum(gains[::-1])[::-1], [0.0]))
        ways = np.concatenate(([0.0], np.cumsum(np.abs(gains))))
        energy = np.where(ways <= 0.5 * ways[-1], from_a, from_b)
        m = self.well.inertia(q)
        return Orbit(q, np.sqrt(np.maximum(2 * energy / m, 0.0)), (at_a == 0, at_b == 0))
