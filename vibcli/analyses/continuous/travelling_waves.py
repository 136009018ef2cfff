"""Bars, shafts and strings in time by travelling waves, exact but for rounding, with fronts that stay sharp.

Along a piece u = f(t − x/c) + g(t − (l − x)/c), f leaving its left end and g its right one (d'Alembert); what leaves
follows from what arrives by the motion of the station that the end belongs to.
"""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.travelling_waves_curves import EVEN, LEVELS, SAME, Loads, PiecewiseSeries
from vibcli.analyses.continuous.travelling_waves_fields import straight
from vibcli.analyses.continuous.travelling_waves_loads import LoadAlong
from vibcli.analyses.continuous.travelling_waves_march import WaveMarch
from vibcli.analyses.continuous.travelling_waves_piece import WavePiece
from vibcli.analyses.continuous.travelling_waves_station import EPSILON, WaveEnd, WaveStation
from vibcli.base.errors import PhysicsError
from vibcli.base.work import Work

if TYPE_CHECKING:
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.analyses.excitation.linear_output import LinearOutput

LONG = 8            # times the sum of all delays: how long it may take until waves are swallowed


def wave_motion(M: np.ndarray, C: np.ndarray, K: np.ndarray, pieces: Sequence[WavePiece], forcing: "Forcing",
                q0: np.ndarray, v0: np.ndarray, fields: "Sequence[Forcing | None] | None" = None,
                work: Work | None = None, loads: Sequence[Sequence[LoadAlong]] | None = None) -> "WaveMotion":
    """M q̈ + C q̇ + K q + what waves bring = f(t), from q(0) = q0 and q̇(0) = v0.

    forcing: its first n channels are the forces on the coordinates; fields: for each piece u(x) and u̇(x) at the start
    as a Forcing over x with two channels, None where it is at rest, straight between its ends; loads: those along each
    piece.
    """
    q0, v0, n, work = np.asarray(q0, float), np.asarray(v0, float), len(q0), work or Work()
    shapes = [_straight(piece, q0) if field is None else field
              for piece, field in zip(pieces, fields or [None] * len(pieces), strict=True)]
    stations = [_station(group, (M, C, K), pieces, q0, v0) for group in _groups(n, (M, C, K), pieces)]
    stations += [_held(number, pieces) for number in range(2 * len(pieces)) if not _end(pieces, number)[0]]
    march = WaveMarch(pieces, stations, shapes, forcing, n, work, loads or [()] * len(pieces))
    return WaveMotion(march, forcing, work)


def _straight(piece: WavePiece, q0: np.ndarray) -> "Forcing":
    left, right = (sum(x * q0[i] for i, x in row.items()) for row, _ in (piece.left, piece.right))
    return straight(left, right, piece.length)


class WaveMotion:
    """The motion of what waves travel through, read by LinearOutputs; forcing: that whose channels these read."""

    def __init__(self, march: WaveMarch, forcing: "Forcing", work: Work) -> None:
        self.march, self.pieces, self.forcing, self.work = march, march.pieces, forcing, work

    def under(self, forcing: "Forcing") -> "WaveMotion":
        """The same motion, whose outputs read further channels of the loads."""
        return WaveMotion(self.march, forcing, self.work)

    def values(self, output: "LinearOutput", times: np.ndarray, order: int = 0, before: bool = False) -> np.ndarray:
        """The order-th rate of the output at instants; at a front that after it, or before it."""
        times = np.asarray(times, float)
        t = times.ravel()
        self.march.reach(t.max(initial=0.0) * (1 + 2 * SAME) + self._slack)
        found = np.full(len(t), output.constant if not order else 0.0)
        for factor, curve, level, delay in self._terms(output, order):
            found += factor * curve.at(t - delay, level, SAME * np.maximum(t, self._slack), before)
        return (found + self._direct(output, t, order, before)).reshape(times.shape)

    def _direct(self, output: "LinearOutput", t: np.ndarray, order: int, before: bool) -> float | np.ndarray:
        """What loads add of themselves."""
        if not output.channels:
            return 0.0
        loads = Loads(self.forcing.channels, self.forcing.segments(float(t.max(initial=0.0)) * (1 + 2 * SAME),
                                                                   self.work))
        place = np.searchsorted(loads.starts, t * (1 + (-SAME if before else SAME)), "left" if before else "right") - 1
        found = np.zeros(len(t))
        for number in np.unique(np.maximum(place, 0)).tolist():
            here = np.maximum(place, 0) == number
            waves = loads.at(number, loads.starts[number], t[here] - loads.starts[number], order)
            found[here] = sum(factor * waves[channel] for channel, factor in output.channels.items())
        return found

    @property
    def _slack(self) -> float:
        return SAME * float(min(self.march.delays, default=0.0))

    def errors(self, output: "LinearOutput", times: np.ndarray, order: int = 0) -> np.ndarray:
        """How far the same values may be off by rounding: that of each stretch so far, and of the instant."""
        t = np.asarray(times, float)
        self.march.reach(t.max(initial=0.0))
        found = np.full(t.shape, EPSILON * abs(output.constant))
        for factor, curve, level, delay in self._terms(output, order):
            found += EPSILON * abs(factor) * (curve.rounding(t - delay, level) + 4 * t * curve.scale[min(
                level + 1, LEVELS - 1)])
        return found

    def breaks(self, output: "LinearOutput", until: float) -> np.ndarray:
        """The instants between which the output is one series, ascending."""
        self.march.reach(until)
        found = [curve.starts + delay for _, curve, _, delay in self._terms(output, 0)]
        if output.channels:
            found.append(np.array([piece.start for piece in self.forcing.segments(until, self.work)]))
        return np.unique(np.concatenate([np.zeros(1), *found]))

    @property
    def long_after(self) -> float:
        """An instant at which waves that are swallowed have long arrived, after the last change of listed loads."""
        last = max((piece.start for piece in self.march.forcing.pieces), default=0.0) if (
            self.march.forcing.listed) else 0.0
        return last + LONG * float(sum(self.march.delays))

    def still_from(self, until: float) -> float:
        """The instant up to `until` from which nothing moves any more; infinite where something does."""
        march, loads = self.march, self.march.forcing
        march.reach(until)
        last = 0.0
        for p, delay in enumerate(march.delays):
            ways = [*march.leaving[2 * p:2 * p + 2], *(march.arriving[end].curve for end in (2 * p, 2 * p + 1)
                                                       if end in march.arriving)]
            since, rates = zip(*(curve.even_from for curve in ways), strict=True)
            # what loads add from the left and from the right to a place is together what they add at an end
            opposite = abs(sum(rates[:3])) <= EVEN * max(curve.scale[1] for curve in ways)
            last = max(last, max(since) + float(delay) if opposite else np.inf)
        for curve in march.coordinates:
            still, rate = curve.even_from
            last = max(last, still if not rate else np.inf)
        lasting = not loads.listed or any(piece.start > last for piece in loads.pieces)
        return np.inf if last > until or lasting else last

    def require_bounded(self, output: "LinearOutput", until: float, at: np.ndarray | None = None) -> None:
        """PhysicsError where a slope or a rate in the output is infinite up to an instant, or at one of `at`, as a
        displacement leaps."""
        self.march.reach(until)
        spikes = [leap + delay for _, curve, level, delay in self._terms(output, 0) if level
                  for leap in curve.leaps if 0 <= leap + delay <= until]
        if at is not None:
            spikes = [t for t in spikes if (np.abs(at - t) <= SAME * t).any()]
        if spikes:
            raise PhysicsError(f"this signal is infinite for an instant, at t = {min(spikes):.6g} s: a displacement "
                               "leaps there", "let a blow on what has no mass last for a while, or give it a mass; "
                               "values between the fronts are found")

    def _terms(self, output: "LinearOutput", order: int) -> Iterable[tuple[float, PiecewiseSeries, int, float]]:
        """(factor, curve, which of its rates, how much later) of all in an output."""
        for rates, factors in enumerate((output.q, output.v, output.a)):
            for i, factor in factors.items():
                yield factor, self.march.coordinates[i], rates + order, 0.0
        for place, factor in output.places.items():
            piece, speed = self.pieces[place.piece], self.pieces[place.piece].speed
            scale, level = factor / speed**place.along, place.along + place.rates + order
            delays = place.x / speed, (piece.length - place.x) / speed
            for side, (sign, delay) in enumerate(zip(((-1)**place.along, 1), delays, strict=True)):
                yield scale * sign, self.march.leaving[2 * place.piece + side], level, delay
            for sign, curve in zip(((-1)**place.along, 1), self.march.gathered(place.piece, place.x), strict=False):
                yield scale * sign, curve, level, 0.0


def _end(pieces: Sequence[WavePiece], number: int) -> tuple[dict[int, float], int | None]:
    """(row, channel) of an end."""
    return (pieces[number // 2].left, pieces[number // 2].right)[number % 2]


def _groups(n: int, matrices: tuple[np.ndarray, np.ndarray, np.ndarray],
            pieces: Sequence[WavePiece]) -> list[list[int]]:
    """Lists of coordinates that hang together: by matrices, or as they move one end."""
    root = list(range(n))

    def find(i: int) -> int:
        while root[i] != i:
            i = root[i]
        return i

    tied = [(int(i), int(j)) for matrix in matrices for i, j in np.argwhere(matrix)]
    for piece in pieces:
        for row, _ in (piece.left, piece.right):
            tied += [(min(row), i) for i in row]
    for i, j in tied:
        root[find(i)] = find(j)
    groups: dict[int, list[int]] = {}
    for i in range(n):
        groups.setdefault(find(i), []).append(i)
    return list(groups.values())


def _station(group: list[int], matrices: tuple[np.ndarray, np.ndarray, np.ndarray], pieces: Sequence[WavePiece],
             q0: np.ndarray, v0: np.ndarray) -> WaveStation:
    ends = []
    for number in range(2 * len(pieces)):
        row, drive = _end(pieces, number)
        if row and next(iter(row)) in group:
            ends.append(WaveEnd(number, np.array([float(row.get(i, 0.0)) for i in group]),
                                pieces[number // 2].impedance, drive))
    M, C, K = (matrix[np.ix_(group, group)] for matrix in matrices)
    return WaveStation(group, M, C, K, ends, q0[group], v0[group])


def _held(number: int, pieces: Sequence[WavePiece]) -> WaveStation:
    """The station of an end that nothing moves but its drive."""
    none, nothing = np.zeros((0, 0)), np.zeros(0)
    end = WaveEnd(number, nothing, pieces[number // 2].impedance, _end(pieces, number)[1])
    return WaveStation([], none, none, none, [end], nothing, nothing)
