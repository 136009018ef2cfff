"""Bars, shafts and strings that drag and a foundation in proportion to their mass disperse, in time without any series:
with s the rate of what moves them and G(p) what they answer without both, N u″ = μ (s² + 2δ s + κ) u has

    Y(s) = G(p) F(s),      p² = s² + 2δ s + κ,

so that, r(τ) being the answer to a unit step without both, which waves bring,

    y(t) = ∫ W(t, τ) dr(τ),   W = e^{−δτ} f(t − τ) + ∫ from τ to t of e^{−δT} σ²τ B(σ²(T² − τ²)) f(t − T) dT,

σ² = δ² − κ, B(z²) = I₁(z)/z (the telegraph equation's; Doetsch, Laplace transforms, 1974). r leaps at fronts and is a
series between them. What starts displaced and at rest answers so too, to F = (s + 2δ)/p² instead of a load. Rates are
what f′ does, and the jumps of f as blows; these, and what starts with a velocity, are in dispersed_blows.py.

By Gauss's rule on panels of h ≤ 2/(δ + |σ| + |s|), σ²t h ≤ 16: as all but r′ is entire, and grows by less than e²² in
4h about a panel, 32 places leave less than 8⁻³⁹ e²² ~ 1e-25 of it beside polynomials r′ of degree 25 (Cauchy).
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.dispersed_blows import Dispersal, Told
from vibcli.analyses.continuous.modal_reads import key_of
from vibcli.analyses.continuous.travelling_waves_curves import SAME
from vibcli.analyses.continuous.travelling_waves_station import EPSILON, NotByWaves
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from vibcli.analyses.continuous.travelling_waves import WaveMotion
    from vibcli.analyses.excitation.forcing import Segment
    from vibcli.base.work import Work

PLACES, PACE, WIDE = 32, 2.0, 16.0      # of Gauss's rule; of panels, times their fastest rate, and times σ²t
MOST = 25_000       # panels of τ times those of T
SEARCHED = 60_000   # the same times fronts that are looked at in turn
AT_ONCE = 512       # places of τ
ROUNDED = 64.0      # how often a term is rounded
SMALL = 1e-200      # z² of a front
AT, WEIGHTS = np.polynomial.legendre.leggauss(PLACES)


class WaveSource(NamedTuple):
    """What a unit step on a channel brings without dispersion; velocity: what starts with one, and no load."""

    motion: "WaveMotion"
    channel: int
    velocity: bool = False

    def starts(self, t: float) -> "list[Segment]":
        """The segments of what moves it up to an instant."""
        return self.motion.forcing.segments(t * (1 + SAME) + 1e-300, self.motion.work)

    def load(self, times: np.ndarray, order: int, before: bool) -> np.ndarray:
        """f, or a rate of it."""
        return self.motion.values(LinearOutput(channels={self.channel: 1.0}), times, order, before)

    def blows(self, t: float, order: int) -> list[tuple[float, float, int]]:
        """[(instant, size, which rate of what a blow brings)] of a rate of what it brings, up to t."""
        if self.velocity:
            return [(0.0, 1.0, order)]
        found, starts = [], self.starts(t)
        for segment in starts:
            found += [(segment.start, float(size), order) for one, size in segment.impulses if one == self.channel]
        if order:
            at = np.array([segment.start for segment in starts])
            after, earlier = self.load(at, 0, False), self.load(at, 0, True) * (at > 0)
            found += [(start, leap, 0) for start, leap, size in zip(
                at.tolist(), (after - earlier).tolist(), (abs(after) + abs(earlier)).tolist(), strict=True)
                if abs(leap) > ROUNDED * EPSILON * size]
        return found


class DispersedMotion:
    """waves: the WaveSources of all loads, and of a start."""

    def __init__(self, waves: "Sequence[WaveSource]", delta: float, square: float, work: "Work") -> None:
        self.waves, self.delta, self.square, self.work = waves, delta, square, work
        self._known: dict[tuple[Any, ...], tuple[float, float]] = {}
        self._reached = -1.0

    def reach(self, until: float) -> None:
        """Follow the waves up to an instant; NotByWaves where fronts or panels are too many."""
        for motion, panels in self._panels_of(until) if until > self._reached else ():
            most = int(MOST / panels - panels)
            if most < 1:
                raise NotByWaves("waves that a drag or a foundation disperses are not followed for so long",
                                 "ask for an earlier instant")
            motion.march.require_few(until, most)
            motion.march.reach(until)
        self._reached = max(until, self._reached)

    def search(self, until: float) -> None:
        """NotByWaves where an output is not looked at in all of the time up to an instant: from front to front."""
        for motion, panels in self._panels_of(until):
            motion.march.require_few(until, int(((panels**2 + 4 * SEARCHED / panels) ** 0.5 - panels) / 2))

    def _panels_of(self, until: float) -> "Iterator[tuple[WaveMotion, float]]":
        """(WaveMotion, how many panels there are) of each load."""
        for source in self.waves:
            starts, pace = self._load(source, until)
            yield source.motion, 1 + len(starts) + until * self._panels(pace, until)

    def values(self, output: LinearOutput, times: np.ndarray, order: int = 0, before: bool = False) -> np.ndarray:
        """The output, or its rate, at instants; at a front that after it, or before it."""
        times = np.asarray(times, float)
        self.reach(times.max(initial=0.0))
        found = [self._at(output, t, before and t > 0, order)[0] for t in times.ravel().tolist()]
        return np.reshape(found, times.shape)

    def errors(self, output: LinearOutput, times: np.ndarray) -> np.ndarray:
        """Bounds of the errors of the same values, of rounding alone."""
        return np.array([self._at(output, float(t), False, 0)[1] for t in times])

    def breaks(self, output: LinearOutput, until: float) -> np.ndarray:
        """The instants between which the output is smooth, ascending."""
        found = [np.zeros(1)]
        for source in self.waves:
            starts = self._load(source, until)[0]
            found += [np.add.outer(source.motion.breaks(part, until), starts).ravel() for _, part in by_rates(output)]
        instants = np.unique(np.concatenate(found))
        return instants[(instants >= 0) & (instants <= until)]

    def require_bounded(self, output: LinearOutput, until: float, at: np.ndarray | None = None) -> None:
        """PhysicsError where the output is infinite."""
        for source in self.waves:
            for rates, part in by_rates(output):
                source.motion.require_bounded(part, until)
                for start, _, order in source.blows(until, rates):
                    source.motion.require_bounded(_faster(part, order + (not source.velocity)), until - start,
                                                  None if at is None else at - start)

    def _at(self, output: LinearOutput, t: float, before: bool, order: int) -> tuple[float, float]:
        """(value, bound of its error)."""
        key = key_of(output), t, before, order
        if key not in self._known:
            parts = [self._of(source, part, t, before, rates + order)
                     for source in self.waves for rates, part in by_rates(output)]
            value, error = (sum(part) for part in zip((0.0, 0.0), *parts, strict=True))
            constant = 0.0 if order else output.constant
            self._known[key] = constant + value, error + EPSILON * abs(constant)
        return self._known[key]

    def _load(self, source: WaveSource, t: float) -> tuple[np.ndarray, float]:
        """(where it jumps or bends, its fastest rate)."""
        pace = self.delta + abs(self.square) ** 0.5
        if source.velocity:
            return np.zeros(1), pace
        own = source.starts(t)
        rates = [abs(wave.exponent) for segment in own for wave in segment.waves if wave.channel == source.channel]
        return np.array([segment.start for segment in own]), max(rates, default=0.0) + pace

    def _panels(self, pace: float, t: float) -> float:
        """1/h."""
        return max(pace / PACE, abs(self.square) * t / WIDE)

    def _of(self, source: WaveSource, output: LinearOutput, t: float, before: bool, order: int) -> np.ndarray:
        """(value, bound of its error) of what one load does, or its rate."""
        if order > 1:
            raise NotByWaves("accelerations of what disperses its waves are not followed by these")
        found = np.zeros(2) if source.velocity else np.array(self._after_load(source, output, t, before, order))
        for start, size, faster in source.blows(t, order):
            later = max(t - start, 0.0)
            if later > SAME * t or not before:
                told = self._told(source, output, later, before)
                found += np.array([size, abs(size)]) * Dispersal(self.delta, self.square).after_blow(
                    source.motion, int(not source.velocity), output, told, later, before, faster)
        return found

    def _told(self, source: WaveSource, output: LinearOutput, t: float, before: bool) -> list[Told]:
        """What h is up to t: at places of panels, and where it is infinite."""
        motion, base = source.motion, int(not source.velocity)
        fronts = motion.breaks(output, t * (1 + SAME))
        fronts = np.minimum(fronts[(fronts >= 0) & (fronts < t * (1 - SAME) if before else True)], t)
        first, last = _apart(fronts, 4 * SAME * t)
        edges = np.union1d(fronts, np.linspace(0.0, t, 2 + int(t * self._panels(self.delta + abs(
            self.square) ** 0.5, t))))
        places, weights = (part.ravel() for part in _panels(edges[:-1], edges[1:]))
        h = weights * motion.values(output, places, base)
        told = [Told(places, h, np.abs(h), weights * motion.errors(output, places, base))]
        if base:
            leaps = motion.values(output, last) - np.where(first, motion.values(output, first, before=True), 0.0)
            told.append(Told(last, leaps, np.abs(leaps), 2 * motion.errors(output, last)))
        return told

    def _after_load(self, source: WaveSource, output: LinearOutput, t: float, before: bool,
                    order: int) -> tuple[float, float]:
        """(value, bound of its error) of what a load, or its rate, does between its jumps."""
        output, motion, (starts, pace) = output._replace(constant=0.0), source.motion, self._load(source, t)
        fronts = motion.breaks(output, t * (1 + SAME))
        fronts = np.minimum(fronts[(fronts >= 0) & (fronts < t * (1 - SAME) if before else True)], t)
        first, last = _apart(fronts, 4 * SAME * t)
        answer = TelegraphWaves(self, np.union1d(np.maximum(t - starts, 0.0), np.linspace(
            0.0, t, 2 + int(t * self._panels(pace, t)))), lambda times: source.load(
            _snapped(times, starts, SAME * t), order, before))
        edges = np.union1d(answer.edges, fronts)
        places, weights = (part.ravel() for part in _panels(edges[:-1], edges[1:]))
        rates, leaps = motion.values(output, places, 1), motion.values(output, last)
        leaps = leaps - np.where(first, motion.values(output, first, before=True), 0.0)
        (W, sizes), (W_at, sizes_at) = answer.to_waves(places), answer.to_waves(last)
        size = weights * np.abs(rates) @ sizes + np.abs(leaps) @ sizes_at
        lost = weights * motion.errors(output, places, 1) @ sizes + 2 * motion.errors(output, last) @ sizes_at
        late = abs(self.square) * answer.largest * (weights * np.abs(rates) @ places + np.abs(leaps) @ last)
        rounded = EPSILON * ((ROUNDED + 4 * t * pace) * size + 4 * t * late)
        return weights * rates @ W + leaps @ W_at, lost + rounded


def by_rates(output: LinearOutput) -> list[tuple[int, LinearOutput]]:
    """[(rates, output of places alone)] that an output is the sum of those rates of."""
    parts = [output.q, output.v, output.a]
    found = []
    for rates, own in enumerate(parts):
        places = {place._replace(rates=0): factor for place, factor in output.places.items() if place.rates == rates}
        if own or places:
            found.append((rates, LinearOutput(q=own, places=places)))
    return found


def _faster(output: LinearOutput, rates: int) -> LinearOutput:
    """So high a rate of an output of places."""
    parts: list[dict[Any, Any]] = [{}, {}, {}]
    parts[rates] = output.q
    places = {place._replace(rates=rates): x for place, x in output.places.items()}
    return LinearOutput(0.0, parts[0], parts[1], parts[2], places=places)


class TelegraphWaves:
    """W at an instant, the last of some `edges` of panels between which loads are smooth; largest: |f| up to then."""

    def __init__(self, of: DispersedMotion, edges: np.ndarray, load: "Callable[[np.ndarray], np.ndarray]") -> None:
        self.delta, self.square, self.edges, self.load = of.delta, of.square, edges, load
        self._places, weights = _panels(edges[:-1], edges[1:])
        loads = load(edges[-1] - self._places)
        self.largest, self._loads = np.abs(loads).max(initial=0.0), loads * weights

    def to_waves(self, tau: np.ndarray) -> np.ndarray:
        """(W, the sizes of what it is summed of) at ascending τ, (2, τ)."""
        if not len(tau):
            return np.zeros((2, 0))
        panel = np.searchsorted(self.edges, tau, "right") - 1
        cuts = np.unique([*(np.flatnonzero(np.diff(panel)) + 1), *range(0, len(tau), AT_ONCE)])
        parts = zip(np.split(tau, cuts[1:]), panel[cuts], strict=True)
        return np.concatenate([self._within(part, number) for part, number in parts], axis=1)

    def _within(self, tau: np.ndarray, panel: int) -> np.ndarray:
        """The same on one panel."""
        direct = np.exp(-self.delta * tau) * self.load(self.edges[-1] - tau)
        found = np.array([direct, np.abs(direct)])
        if panel < len(self.edges) - 1:
            T, weights = _panels(tau, np.full(len(tau), self.edges[panel + 1]))
            for places, loads in ((T, self.load(self.edges[-1] - T) * weights), (
                    self._places[panel + 1:].reshape(1, -1), self._loads[panel + 1:].reshape(1, -1))):
                terms = self._tail(places, tau[:, None]) * loads
                found += terms.sum(axis=1), np.abs(terms).sum(axis=1)
        return found

    def _tail(self, T: np.ndarray, tau: np.ndarray) -> np.ndarray:
        """e^{−δT} σ²τ B."""
        from scipy.special import i1e, j1

        z = np.sqrt(np.maximum(abs(self.square) * (T - tau) * (T + tau), SMALL))
        B = np.exp(z - self.delta * T) * i1e(z) / z if self.square > 0 else np.exp(-self.delta * T) * j1(z) / z
        return cast("np.ndarray", self.square * tau * B)


def _panels(low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Places and weights of Gauss's rule, (panels, PLACES)."""
    return np.add.outer((low + high) / 2, 0 * AT) + np.outer((high - low) / 2, AT), np.outer((high - low) / 2, WEIGHTS)


def _apart(fronts: np.ndarray, room: float) -> tuple[np.ndarray, np.ndarray]:
    """The first and the last of each group of fronts that are one but for rounding."""
    gaps = np.flatnonzero(np.diff(fronts) > room)
    return fronts[np.append(0, gaps + 1)], fronts[np.append(gaps, len(fronts) - 1)]


def _snapped(times: np.ndarray, starts: np.ndarray, room: float) -> np.ndarray:
    """Instants, those next to one of the starts being it."""
    nearest = starts[np.abs(np.subtract.outer(times, starts)).argmin(axis=-1)]
    return np.where(np.abs(times - nearest) <= room, nearest, times)
