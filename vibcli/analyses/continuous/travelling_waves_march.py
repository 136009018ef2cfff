"""Waves followed from station to station: what leaves an end of a piece arrives at its other end after its delay.

The station that is least far goes on, up to the next front that reaches it, never beyond what is known to arrive, and
by stretches on which Chebyshev series tell what happens to rounding.
"""

from collections.abc import Sequence
from fractions import Fraction
from heapq import heapify, heappop, heappush
from math import inf
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.travelling_waves_curves import LEVELS, SAME, Loads, PiecewiseSeries, series_of
from vibcli.analyses.continuous.travelling_waves_fields import starting_waves
from vibcli.analyses.continuous.travelling_waves_loads import GatheredWave, LoadAlong, LoadInTime
from vibcli.analyses.continuous.travelling_waves_piece import WavePiece
from vibcli.analyses.continuous.travelling_waves_station import NotByWaves, WaveStation
from vibcli.numerics.chebyshev import POINTS, WIDTH, N

if TYPE_CHECKING:
    from vibcli.analyses.continuous.travelling_waves_station import Stretch, WaveEnd
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.base.errors import PhysicsError
    from vibcli.base.work import Task, Work

MOST = 6_000       # stretches of time of all stations
FINEST = 1e-10      # of the time, and of the shortest delay: the shortest stretch


class WaveMarch:
    """leaving: what leaves each end, coordinates: the motion of each coordinate, as PiecewiseSeries up to `known` at
    least. loads: those along each piece."""

    def __init__(self, pieces: Sequence[WavePiece], stations: Sequence[WaveStation], fields: "Sequence[Forcing]",
                 forcing: "Forcing", n: int, work: "Work", loads: Sequence[Sequence[LoadAlong]]) -> None:
        self.pieces, self.stations, self.forcing, self.work = pieces, stations, forcing, work
        self.delays = [Fraction(piece.length / piece.speed) for piece in pieces]
        self._shortest = float(min(self.delays, default=0))
        self.coordinates, self.leaving = [PiecewiseSeries() for _ in range(n)], []
        self.home = {end.number: k for k, station in enumerate(stations) for end in station.ends}
        self.now, self.known = [Fraction(0)] * len(stations), 0.0
        self._events: list[list[tuple[Fraction, int, Any]]] = [[(Fraction(0), -1, 0.0)] for _ in stations]
        self._pace = [inf] * len(stations)
        self._loads, self._load_until = Loads(forcing.channels, []), -1.0
        self._told, self._spread = -1.0, loads
        self._gathered: dict[tuple[int, float, int], GatheredWave] = {}
        self._times: dict[int, LoadInTime] = {}
        self.arriving = {2 * p + side: self._gathering(p, side * piece.length, 2 * side - 1)
                         for p, piece in enumerate(pieces) for side in (0, 1) if loads[p]}
        with work.task("the waves at the start", MOST) as task:
            for number, (piece, field, delay) in enumerate(zip(pieces, fields, self.delays, strict=True)):
                left, right, corners = starting_waves(field, piece.length, delay, task)
                self.leaving += [left, right]
                for x, leap in corners:
                    after = delay * Fraction(x) / Fraction(piece.length)
                    self._announce(2 * number + 1, delay - after, -leap / 2)
                    self._announce(2 * number, after, leap / 2)

    def reach(self, until: float) -> None:
        """Follow the waves up to an instant, and as far beyond as makes no stretch of time short."""
        if until <= self.known or not self.stations:
            return
        beyond = float(max(self.delays, default=0)) + until / 64
        end = Fraction(until + beyond)
        self._tell_loads(until + 3 * beyond)
        self.require_few(float(end))
        heap = [(now, k) for k, now in enumerate(self.now)]
        heap.sort()
        with self.work.task("the waves from front to front", MOST, self._refusal) as task:
            while heap[0][0] < end:
                _, k = heappop(heap)
                self._advance(k, end, task)
                heappush(heap, (self.now[k], k))
        self.known = float(end)

    def _refusal(self, task: "Task") -> "PhysicsError":
        return _too_many(task.limit, self.work.patience)

    def require_few(self, end: float, most: int = MOST) -> None:
        """NotByWaves where there are more fronts up to an instant than stretches are followed: seen before any is."""
        self._tell_loads(end)
        limit, grain = most * self.work.patience, 1e-6 * float(min(self.delays, default=end))
        coming = [(float(event[0]), k) for k, events in enumerate(self._events) for event in events]
        ways = [[(float(self.delays[one.number // 2]), self.home[one.number ^ 1]) for one in station.ends]
                for station in self.stations]
        seen: set[tuple[int, int]] = set()
        heapify(coming)
        while coming and coming[0][0] < end:
            t, k = heappop(coming)
            if (round(t / grain), k) in seen:
                continue
            seen.add((round(t / grain), k))
            if len(seen) > limit:
                raise _too_many(limit, self.work.patience)
            for delay, other in ways[k]:
                heappush(coming, (t + delay, other))

    def _tell_loads(self, until: float) -> None:
        """Announce where the loads jump or bend up to an instant."""
        if until <= self._told:
            return
        self._told = until
        self._loads = Loads(self.forcing.channels, self.forcing.segments(until * (1 + SAME), self.work))
        for number, start in enumerate(self._loads.starts.tolist()):
            if start <= self._load_until:
                continue
            acting = self._loads.used(number) | self._loads.used(max(number - 1, 0)) | {
                channel for channel, _ in (self._loads.pieces[number].impulses if self._loads.pieces else ())}
            for k, station in enumerate(self.stations):
                if start and acting & self._channels(station):
                    heappush(self._events[k], (Fraction(start), -1, 0.0))
        self._load_until = max(self._load_until, float(self._loads.starts[-1]))
        self._times = {channel: LoadInTime(self._loads, channel)
                       for channel in {one.channel for loads in self._spread for one in loads}}
        for number, wave in self.arriving.items():
            for instant in wave.tell(self._times, until):
                heappush(self._events[self.home[number]], (instant, -1, 0.0))

    def gathered(self, piece: int, x: float) -> list[PiecewiseSeries]:
        """What loads along a piece add to the waves from its left and from its right to a place, as far as waves are
        followed."""
        with self.work.task("what loads along a member add to its waves", MOST, self._refusal) as task:
            found = [self._gathering(piece, x, way) for way in (1, -1)] if self._spread[piece] else []
            for wave in found:
                wave.tell(self._times, self._told)
                wave.reach(Fraction(self.known), task)
            return [wave.curve for wave in found]

    def _gathering(self, piece: int, x: float, way: int) -> GatheredWave:
        key = piece, x, way
        if key not in self._gathered:
            self._gathered[key] = GatheredWave(self.pieces[piece], self.delays[piece], x, way, self._spread[piece])
        return self._gathered[key]

    def _channels(self, station: WaveStation) -> set[int]:
        return {*station.indices, *(end.drive for end in station.ends if end.drive is not None)}

    def _announce(self, number: int, instant: Fraction, leap: float) -> None:
        """A front arrives at an end at an instant, over which what arrives leaps."""
        heappush(self._events[self.home[number]], (instant, number, leap))

    def _tolerance(self, instant: Fraction) -> float:
        return SAME * max(abs(float(instant)), self._shortest)

    def _is_reached(self, instant: Fraction, now: Fraction) -> bool:
        """Is it before this one, or next to it?"""
        return instant <= now or float(instant - now) <= self._tolerance(now)

    def _advance(self, k: int, until: Fraction, task: "Task") -> None:
        """The next stretch of a station."""
        station, now, events = self.stations[k], self.now[k], self._events[k]
        if events and self._is_reached(events[0][0], now):
            self._front(k)
        limit = min((self.now[self.home[end.number ^ 1]] + self.delays[end.number // 2] for end in station.ends),
                    default=until)
        if events and self._is_reached(events[0][0], limit):
            limit = events[0][0]
        if limit - now > 1.5 * self._pace[k]:
            limit = now + Fraction(self._pace[k])
        while True:
            task.step()
            stretch = self._stretch(station, now, limit, task)
            if stretch.resolved or limit - now <= FINEST * max(now, min(self.delays, default=limit)):
                break
            self._pace[k] = float(limit - now) / 2
            limit = now + Fraction(self._pace[k])
        self._pace[k] *= 2
        station.take(stretch)
        for index, series in zip(station.indices, stretch.coordinates, strict=True):
            self.coordinates[index].append(now, limit - now, series)
        for end, series in zip(station.ends, stretch.leaving, strict=True):
            self.leaving[end.number].append(now, limit - now, series)
        self.now[k] = limit

    def _stretch(self, station: WaveStation, now: Fraction, limit: Fraction, task: "Task") -> "Stretch":
        half = float(limit - now) / 2
        piece, count = self._loads.piece_at(float(now + limit) / 2), len(station.ends)
        loads = np.zeros((LEVELS, self.forcing.channels, N))
        if self._loads.used(piece) & self._channels(station):
            loads = np.array([self._loads.at(piece, now, half * (1 + POINTS), level) for level in range(LEVELS)])
        arriving, driven = np.zeros((2, count, LEVELS, WIDTH))
        scales, gathered = np.zeros((count, LEVELS)), np.zeros(count)
        for i, end in enumerate(station.ends):
            source = self.leaving[end.number ^ 1]
            scales[i], arriving[i] = source.scale, source.series(now - self.delays[end.number // 2], limit - now)
            added = self.arriving.get(end.number)
            if added is not None:
                added.reach(limit, task)
                scales[i] += added.curve.scale
                gathered[i] = added.curve.scale[1]
                arriving[i] += added.curve.series(now, limit - now)
            if end.drive is not None:
                driven[i] = series_of(loads[:, end.drive])
        return station.along(half, arriving, driven, loads[0][station.indices], scales, gathered)

    def _front(self, k: int) -> None:
        """All that reaches a station at this instant."""
        station, now, events = self.stations[k], self.now[k], self._events[k]
        arrived = dict.fromkeys((end.number for end in station.ends), 0.0)
        while events and self._is_reached(events[0][0], now):
            _, number, leap = heappop(events)
            if number >= 0:
                arrived[number] += leap
        impulses, driven = self._blows(station, now)
        moved, leaps = station.struck(impulses, np.array([arrived[end.number] for end in station.ends]), driven)
        curves = [*(self.coordinates[i] for i in station.indices), *(self.leaving[end.number] for end in station.ends)]
        for curve, leap in zip(curves, (*moved, *leaps), strict=True):
            if leap:
                curve.leaps.append(float(now))
        for end, leap in zip(station.ends, leaps, strict=True):
            self._announce(end.number ^ 1, now + self.delays[end.number // 2], float(leap))

    def _blows(self, station: WaveStation, now: Fraction) -> tuple[np.ndarray, np.ndarray]:
        """(impulses on the coordinates, leaps of what moves the ends) at an instant."""
        impulses, driven = np.zeros(len(station.indices)), np.zeros(len(station.ends))
        loads = self._loads
        number = loads.piece_at(float(now + self._tolerance(now)))
        if not loads.pieces or abs(loads.starts[number] - now) > self._tolerance(now):
            return impulses, driven
        for channel, size in loads.pieces[number].impulses:
            if channel in station.indices:
                impulses[station.indices.index(channel)] += size
        here = Fraction(float(loads.starts[number])), np.zeros(1)
        for i, end in enumerate(station.ends):
            if end.drive is not None:
                after = loads.at(number, *here)[end.drive, 0]
                before = loads.at(number - 1, *here)[end.drive, 0] if number else self._shift(station, end)
                size = max(abs(after), abs(before), *(
                    () if number else (self.leaving[one].scale[0] for one in (end.number, end.number ^ 1))))
                driven[i] = after - before if abs(after - before) > SAME * size else 0.0
        return impulses, driven

    def _shift(self, station: WaveStation, end: "WaveEnd") -> float:
        """How far the field at the start has moved an end beside its coordinates."""
        piece = self.pieces[end.number // 2]
        own, other = self.leaving[end.number], self.leaving[end.number ^ 1]
        u = own.at(np.array([0.0]), before=True)[0] + other.at(np.array([-piece.length / piece.speed]))[0]
        return cast("float", u - end.row @ station.q)


def _too_many(limit: float, patience: int) -> NotByWaves:
    return NotByWaves(f"the fronts in this scene multiply: after {limit:.0f} stretches of time between them they are "
                      "not followed further", f"ask for an earlier end, or --patience {10 * patience} follows ten "
                      "times as many")
