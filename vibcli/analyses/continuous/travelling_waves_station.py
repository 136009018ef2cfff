"""Where waves arrive and leave: coordinates that hang together, a small differential equation driven by what arrives.

A wave a(t) that arrives at an end, u = row·q + s(t), and what leaves it, u − a, act with Z(2ȧ − u̇), Z = √(Nμ):

    M q̈ + (C + Σ Z rowᵀrow) q̇ + K q = F(t) + Σ Z rowᵀ(2ȧ − ṡ)

Of each coordinate the highest rate that stands in it (q̈; q̇ of what has no inertia; q of what nothing damps either) is
found at Chebyshev points from the equation integrated twice, once or not, which keeps digits where it is stiff.
"""

from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.continuous.travelling_waves_curves import LEVELS, series_of
from vibcli.analyses.continuous.travelling_waves_fields import is_resolved
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.chebyshev import AT_POINTS, ONCE, POINTS, RATE, TWICE, WIDTH, N

if TYPE_CHECKING:
    from collections.abc import Sequence

EPSILON = 2.0 ** -52
NOISE = 2           # EPSILON: coefficients below that, beside the largest, are rounding
INTEGRALS = (np.eye(N), (ONCE @ AT_POINTS[:N + 1]).T, (TWICE @ AT_POINTS).T)


class NotByWaves(PhysicsError):
    """A system whose motion is not followed by travelling waves, with the reason."""


class WaveEnd(NamedTuple):
    """The end of a piece at a station: its number (2·piece, and one more at the right), its row over the coordinates of
    the station, its impedance Z, the channel of the loads that moves it, None where there is none."""

    number: int
    row: np.ndarray
    impedance: float
    drive: int | None


class Stretch(NamedTuple):
    """What a station does on a stretch of time: the series of its coordinates and of what leaves its ends, (count,
    LEVELS, WIDTH); resolved: do these series tell it?"""

    coordinates: np.ndarray
    leaving: np.ndarray
    resolved: bool


class WaveStation:
    """Coordinates `indices` of the scene with their matrices, and the ends that they move. q, v: where they are now."""

    __slots__ = ("C", "K", "M", "ends", "indices", "inverse", "principal", "q", "rates", "size", "v")

    def __init__(self, indices: "Sequence[int]", M: np.ndarray, C: np.ndarray, K: np.ndarray, ends: "Sequence[WaveEnd]",
                 q: np.ndarray, v: np.ndarray) -> None:
        self.indices, self.M, self.K, self.ends = list(indices), M, K, tuple(ends)
        self.C = C + sum((end.impedance * np.outer(end.row, end.row) for end in ends), np.zeros_like(C))
        self.rates = np.where(M.any(axis=0), 2, np.where(self.C.any(axis=0), 1, 0))
        self.principal = np.where(self.rates == 2, M, np.where(self.rates == 1, self.C, K))
        self.inverse = self._inverse()
        self.q, self.v, self.size = q.copy(), np.where(self.rates == 2, v, 0.0), np.zeros((len(q), LEVELS))

    def _inverse(self) -> np.ndarray:
        scale = np.abs(self.principal).max(axis=1, initial=0.0)
        if not scale.all() or (len(scale) and np.linalg.cond(self.principal / scale[:, None]) > 1e12):
            raise NotByWaves("inertia and dampers of this scene do not fix how its coordinates move, each by itself")
        return np.linalg.inv(self.principal)

    def struck(self, impulses: np.ndarray, arrived: np.ndarray, driven: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Take impulses on the coordinates, and leaps of what arrives at the ends and of what moves them; the leaps of
        the coordinates, and of what leaves the ends."""
        total = impulses + sum((end.impedance * (2 * a - s) * end.row
                                for end, a, s in zip(self.ends, arrived, driven, strict=True)), np.zeros(len(self.q)))
        jump = self.inverse @ total
        if jump[self.rates == 0].any():
            raise PhysicsError("a blow falls on what neither inertia nor a damper holds back: it would be displaced "
                               "without bound", hint="give it an inertia or a damper, or let the blow last")
        self.v = self.v + np.where(self.rates == 2, jump, 0.0)
        moved = np.where(self.rates == 1, jump, 0.0)
        self.q = self.q + moved
        return moved, np.array([end.row @ moved + s - a
                                for end, a, s in zip(self.ends, arrived, driven, strict=True)])

    def along(self, half: float, arriving: np.ndarray, driven: np.ndarray, forces: np.ndarray,
              scales: np.ndarray, gathered: np.ndarray) -> Stretch:
        """The Stretch of length 2·half from now on. arriving, driven: series (ends, LEVELS, WIDTH); forces:
        (coordinates, N) at the points; scales: (ends, LEVELS), how large what arrives has ever been; gathered: (ends,),
        what the rates are rounded from that loads on the way add to it."""
        load, size = forces.copy(), np.abs(forces).max(axis=1, initial=0.0)
        for end, a, s, least in zip(self.ends, arriving, driven, gathered, strict=True):
            rate = (2 * a[1] - s[1]) @ AT_POINTS
            load += end.impedance * np.outer(end.row, rate)
            size += end.impedance * np.abs(end.row) * (np.abs(rate).max() + least)
        coordinates = self._levels(half, self._highest(half, load))
        sizes = np.maximum(self._sizes(half, size), np.abs(coordinates).sum(axis=2))
        sizes = np.maximum(sizes, self.size)
        coordinates[np.abs(coordinates) < NOISE * EPSILON * sizes[..., None]] = 0.0
        leaving, resolved = [], all(is_resolved(rate[:N], size) for rate, size in
                                    zip(coordinates[:, 1], sizes[:, 1], strict=True))
        for end, a, s, scale in zip(self.ends, arriving, driven, scales, strict=True):
            resolved = resolved and is_resolved((s - a)[1, :N], scale[1])
            found = s - a + (np.tensordot(end.row, coordinates, 1) if len(self.q) else 0.0)
            noise = scale + np.abs(s).sum(axis=1) + np.abs(end.row) @ sizes
            found[np.abs(found) < NOISE * EPSILON * noise[:, None]] = 0.0
            leaving.append(found)
        return Stretch(coordinates, np.array(leaving).reshape(-1, LEVELS, WIDTH), resolved)

    def take(self, stretch: Stretch) -> None:
        """Be at the end of a Stretch."""
        self.q, self.v = stretch.coordinates[:, 0].sum(axis=1), stretch.coordinates[:, 1].sum(axis=1)
        self.size = np.maximum(self.size, np.abs(stretch.coordinates).sum(axis=2))

    def _highest(self, half: float, load: np.ndarray) -> np.ndarray:
        """(coordinates, N): the highest rate of each at the points."""
        second, damped = self.rates == 2, self.rates > 0
        v = np.where(second, self.v, 0.0)[:, None]
        q = np.where(damped, self.q, 0.0)[:, None] + half * v * (1 + POINTS)
        load = load - self.C @ np.broadcast_to(v, load.shape) - self.K @ q
        if not len(load) or (not self.K.any() and not second.any()):
            return cast("np.ndarray", self.inverse @ load)
        system = np.zeros((len(load), N, len(load), N))
        for j, rate in enumerate(self.rates):
            for lower, matrix in enumerate((self.K, self.C, self.M)[:rate + 1]):
                system[:, :, j, :] += matrix[:, j, None, None] * (half**(rate - lower) * INTEGRALS[rate - lower])
        return np.linalg.solve(system.reshape(load.size, load.size), load.ravel()).reshape(load.shape)

    def _levels(self, half: float, highest: np.ndarray) -> np.ndarray:
        """(coordinates, LEVELS, WIDTH): the series of q, q̇, q̈."""
        found = np.zeros((len(self.q), LEVELS, WIDTH))
        for j, rate in enumerate(self.rates):
            levels, values = found[j], highest[j]
            levels[rate] = series_of(values)
            if rate:
                levels[rate - 1, :N + 1] = half * (values @ ONCE)
                levels[rate - 1, 0] += (self.q, self.v)[rate - 1][j]
            if rate == 2:
                levels[0] = half * half * (values @ TWICE)
                levels[0, :2] += half * self.v[j]
                levels[0, 0] += self.q[j]
            for level in range(rate, LEVELS - 1):
                levels[level + 1] = levels[level] @ RATE / half
        return found

    def _sizes(self, half: float, size: np.ndarray) -> np.ndarray:
        """(coordinates, LEVELS): how large the terms are from which each level is found."""
        reach = np.abs(self.q) + half * np.abs(self.v)
        highest = np.abs(self.inverse) @ (size + np.abs(self.C) @ np.abs(self.v) + np.abs(self.K) @ reach)
        found = np.zeros((len(self.q), LEVELS))
        for level in range(LEVELS):
            found[:, level] = highest * half ** np.maximum(self.rates - level, 0.0)
        found[:, 0] += np.where(self.rates > 0, reach, 0.0)
        found[:, 1] += np.where(self.rates == 2, np.abs(self.v), 0.0)
        return found

