"""What loads along a piece add to the waves that run along it to a place.

A load f(x) g(t) per length adds to a wave what it meets, f at the time σ upstream of the place and μ the inertia there:

    R′(t) = ∫ f(σ) g(t − σ) dσ / (2μ) + Σ I f(t − t_I) / (2μ)        σ from 0 to the end of the piece

with the impulses I of g; R″ takes g′ for g and the leaps of g for I. By Gauss's rule between the instants at which f or
g jumps or bends on the way: nothing is divided by what vanishes at resonance or at rest.
"""

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import ceil, inf
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.travelling_waves_curves import LEVELS, SAME, Loads, PiecewiseSeries, series_of
from vibcli.analyses.continuous.travelling_waves_fields import is_resolved
from vibcli.analyses.excitation.forcing import Segment
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.chebyshev import ONCE, POINTS, WIDTH, N
from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.panels import POINTS as RULE
from vibcli.numerics.pieces.panels import SPAN, plain_rule

if TYPE_CHECKING:
    from vibcli.analyses.continuous.travelling_waves_piece import WavePiece
    from vibcli.base.work import Task
    from vibcli.numerics.pieces.loads import LoadForm, LoadStretch

FINEST = 1e-10      # of the time: the shortest stretch
PANELS = 16         # of Gauss's rule: as much work as a stretch of a station
PLAIN = arithmetic_of()
SHARES = 33         # of a stretch: where the size of a load is looked at


class LoadAlong(NamedTuple):
    """f(x) of a piece, counted from its left end, times a channel of the loads."""

    form: "LoadForm"
    channel: int


class Upstream(NamedTuple):
    """A LoadStretch that lies from `near` to `far` upstream, as times; `channel` its g; pace: how fast f changes for
    what runs over it; sizes: of what f and f′ are summed of."""

    near: Fraction
    far: Fraction
    stretch: "LoadStretch"
    channel: int
    pace: float
    sizes: Sequence[float]


class LoadInTime:
    """One channel g of the loads as Loads, and what is known of its pieces."""

    def __init__(self, loads: Loads, channel: int) -> None:
        found: list[Segment] = []
        held: tuple[Any, ...] | None = None       # what the last piece holds, where that is the same all the time
        for piece in loads.pieces:
            waves = tuple(one._replace(channel=0) for one in piece.waves if one.channel == channel)
            impulses = tuple(one for one in piece.impulses if one[0] == channel)
            if impulses or waves != held:
                found.append(Segment(piece.start, waves, impulses))
            held = waves if not any(wave.power or wave.exponent for wave in waves) else None
        self.loads, self.starts = Loads(1, found), np.array([piece.start for piece in found])
        self._whole: dict[tuple[int, float], tuple[np.ndarray, np.ndarray]] = {}
        self._blows: dict[int, tuple[float, float]] = {}

    def blow(self, number: int) -> tuple[float, float]:
        """(impulse, leap) with which a piece begins."""
        if number not in self._blows:
            self._blows[number] = self._blow(number)
        return self._blows[number]

    def _blow(self, number: int) -> tuple[float, float]:
        here = Fraction(float(self.starts[number])), np.zeros(1)
        after = self.loads.at(number, *here)[0, 0]
        before = self.loads.at(number - 1, *here)[0, 0] if number else 0.0
        leap = after - before if abs(after - before) > SAME * max(abs(after), abs(before)) else 0.0
        return sum(size for _, size in self.loads.pieces[number].impulses), leap

    def weighted(self, number: int, tau: np.ndarray, weights: np.ndarray) -> np.ndarray:
        """(g, g′) of a piece at times since it began, (2, …), times weights."""
        start, flat = Fraction(float(self.starts[number])), tau.ravel()
        found = np.array([self.loads.at(number, start, flat, order)[0] for order in range(2)])
        return np.asarray(weights * found.reshape(2, *tau.shape))

    def whole(self, number: int, pace: float) -> tuple[np.ndarray, np.ndarray]:
        """(times since a piece began, g, g′ times weights) of Gauss's rule over all of it, (3, panels · points), and
        the sizes of their sums."""
        if (number, pace) not in self._whole:
            length = float(self.starts[number + 1] - self.starts[number])
            places, weights = _panels(self.pace(number) + pace, length)
            nodes = np.array([length * places, *self.weighted(number, length * places, length * weights)])
            self._whole[number, pace] = nodes, length * self.sizes(number, 0.0, length)
        return self._whole[number, pace]

    def sizes(self, number: int, start: float, end: float) -> np.ndarray:
        """Of what g and g′ are summed of, between times since a piece began."""
        found = np.zeros(2)
        for _, factor, power, rate in self.loads.pieces[number].waves:
            own = [abs(complex(factor)) * np.exp(complex(rate).real * tau) * np.array([
                tau**power, abs(rate) * tau**power + (power * tau ** (power - 1) if power else 0.0)])
                for tau in (start, end)]
            found += np.maximum(*own)
        return found

    def pace(self, number: int) -> float:
        """The fastest rate of a piece."""
        return max((abs(complex(wave.exponent)) for wave in self.loads.pieces[number].waves), default=0.0)


class GatheredWave:
    """What runs to the place x of a piece, from its left end (way 1) or from its right one (−1), of loads on the way.
    curve: R up to `now`."""

    __slots__ = ("_breaks", "_inertia", "_pace", "_parts", "_speed", "_times", "_told", "_x", "curve", "now")

    def __init__(self, piece: "WavePiece", delay: Fraction, x: float, way: int, loads: Sequence[LoadAlong]) -> None:
        self._speed, self._x, self._inertia, self._pace = way * piece.speed, x, piece.inertia, inf
        self.curve, self.now, self._breaks, self._told = PiecewiseSeries(), Fraction(0), [], -1.0
        self._parts, self._times = [], {}
        first, last = (0.0, x) if way > 0 else (x, piece.length)
        for form, channel in loads:
            for one in form.stretches:
                start, end = max(first, float(one.start)), min(last, float(one.end))
                near, far = sorted(delay * abs(Fraction(x) - Fraction(place)) / Fraction(piece.length)
                                   for place in (start, end))
                if start < end and one.terms:
                    sizes = tuple(float(f.size(np.linspace(start, end, SHARES)).max()) for f in (one, one.slope))
                    self._parts.append(Upstream(near, far, one, channel, one.pace * piece.speed, sizes))

    def tell(self, times: dict[int, LoadInTime], until: float) -> list[Fraction]:
        """Take over the loads up to an instant; the instants behind those told before at which R bends."""
        if until <= self._told:
            return []
        count, self._times = len(self._breaks), times
        for instant in sorted({Fraction(start) + edge for part in self._parts for edge in (part.near, part.far)
                               for start in times[part.channel].starts.tolist()}):
            last = self._breaks[-1] if self._breaks else Fraction(0)
            if self._told < instant <= until and instant > last * (1 + Fraction(SAME)):
                self._breaks.append(instant)
        self._told = until
        return self._breaks[count:]

    def reach(self, until: Fraction, task: "Task") -> None:
        """Know R up to an instant at least, to which loads are told."""
        while self.now < until:
            limit = min([Fraction(self._told), *self._breaks[(k := bisect_right(self._breaks, self.now)):k + 1]])
            if limit - self.now > 1.5 * self._pace:
                limit = self.now + Fraction(self._pace)
            while True:
                levels, sizes, panels = self._levels(float(limit - self.now) / 2)
                task.step(None, (1 + panels) / PANELS)
                resolved = all(is_resolved(levels[k, :N], sizes[k]) for k in (1, 2))
                if resolved or limit - self.now <= FINEST * limit:
                    break
                self._pace = float(limit - self.now) / 2
                limit = self.now + Fraction(self._pace)
            self._pace *= 2
            self.curve.append(self.now, limit - self.now, levels, sizes)
            self.now = limit

    def _levels(self, half: float) -> tuple[np.ndarray, np.ndarray, float]:
        """(R, R′, R″ as series on the stretch that begins now, the sizes of what they are summed of, how many panels
        that took)."""
        found, sizes, count = np.zeros((2, N)), np.zeros(LEVELS), 0
        for part in self._parts:
            for added, size, nodes in self._shares(part, self._times[part.channel], half):
                found, count = found + added, count + nodes
                sizes[1:] += size
        found, sizes = found / (2 * self._inertia), sizes / (2 * self._inertia)
        levels = np.zeros((LEVELS, WIDTH))
        levels[0, :N + 1] = half * (found[0] @ ONCE)
        levels[0, 0] += self.curve.end
        levels[1:] = series_of(found)
        sizes[0] = 2 * half * sizes[1]
        return levels, np.maximum(sizes, self.curve.scale), count / RULE

    def _shares(self, part: Upstream, g: LoadInTime, half: float) -> Iterator[tuple[Any, Any, int]]:
        """What a part adds of each piece of g: ((2, N) to R′ and R″, their sizes, how many nodes that took)."""
        later, near, far = half * (1 + POINTS), float(part.near), float(part.far)
        early = float(self.now)
        since = early - g.starts + float(self.now - Fraction(early))        # the pieces of g began, now
        first, last = (max(int(np.count_nonzero(since + half > edge)) - 1, 0) for edge in (far, near))
        if not len(since) or since[0] + half <= near:
            return
        whole = []
        for number in range(first, last + 1):
            high, low = np.minimum(far, since[number] + later), np.full(N, near)
            if number < len(since) - 1:
                low = np.maximum(low, since[number + 1] + later)
            if near < since[number] + half < far:
                yield self._blow(part, since[number] + later, *g.blow(number))
            if first < number < last:
                whole.append(number)
            elif g.loads.pieces[number].waves:
                width = np.maximum(high - low, 0.0)
                places, weights = _panels(g.pace(number) + part.pace, float(width.max()))
                sigma = low[:, None] + width[:, None] * places
                tau = since[number] + later[:, None] - sigma
                shares = g.weighted(number, tau, width[:, None] * weights) * self._f(part.stretch, sigma)
                sizes = g.sizes(number, max(float(tau.min()), 0.0), float(tau.max()))
                yield shares.sum(axis=2), part.sizes[0] * float(width.max()) * sizes, len(places)
        if whole:
            nodes, sizes = zip(*(g.whole(number, part.pace) for number in whole), strict=True)
            tau, *rates = np.concatenate(nodes, axis=1)
            tau -= np.repeat(since[whole], [one.shape[1] for one in nodes])
            f = self._f(part.stretch, later[:, None] - tau)
            yield np.array([f @ rate for rate in rates]), part.sizes[0] * sum(sizes), len(tau)

    def _blow(self, part: Upstream, sigma: np.ndarray, impulse: float, leap: float) -> tuple[Any, Any, int]:
        if not impulse and not leap:
            return 0.0, 0.0, 0
        f, slope = self._f(part.stretch, sigma), self._speed * self._f(part.stretch.slope, sigma)
        sizes = [abs(impulse) * part.sizes[0],
                 abs(leap) * part.sizes[0] + abs(impulse * self._speed) * part.sizes[1]]
        return np.array([impulse * f, leap * f - impulse * slope]), sizes, 0

    def _f(self, stretch: Any, sigma: np.ndarray) -> np.ndarray:
        return cast("np.ndarray", stretch.at(self._x - self._speed * sigma, PLAIN))


def _panels(pace: float, length: float) -> tuple[np.ndarray, np.ndarray]:
    """(places, weights) of Gauss's rule on 0 … 1, on as many panels as what changes so fast over a length takes."""
    count, (at, weights) = max(1, ceil(pace * length / (2 * SPAN))), plain_rule()
    places = (np.arange(count)[:, None] + (1 + at) / 2) / count
    return places.ravel(), np.tile(weights / (2 * count), count)
