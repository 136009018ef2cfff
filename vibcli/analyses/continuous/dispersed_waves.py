"""Bars, shafts and strings that drag and a foundation in proportion to their mass disperse, in time without any series:
with s the rate of what moves them and G(p) what they answer without both, N u″ = μ (s² + 2δ s + κ) u has

    Y(s) = G(p) F(s),      p² = s² + 2δ s + κ,

so that, r(τ) being the answer to a unit step without both, which waves bring,

    y(t) = ∫ W(t, τ) dr(τ),   W = e^{−δτ} f(t − τ) + ∫ from τ to t of e^{−δT} σ²τ B(σ²(T² − τ²)) f(t − T) dT,

σ² = δ² − κ, B(z²) = I₁(z)/z (the telegraph equation's; Doetsch, Laplace transforms, 1974). r leaps at fronts and is a
series between them. What starts displaced and at rest answers so too, to F = (s + 2δ)/p² instead of a load.

By Gauss's rule on panels of h ≤ 2/(δ + |σ| + |s|), σ²t h ≤ 16: as all but r′ is entire, and grows by less than e²² in
4h about a panel, 32 places leave less than 8⁻³⁹ e²² ~ 1e-25 of it beside polynomials r′ of degree 25 (Cauchy).
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.modal_reads import key_of
from vibcli.analyses.continuous.travelling_waves_curves import SAME
from vibcli.analyses.continuous.travelling_waves_station import EPSILON, NotByWaves
from vibcli.analyses.excitation.linear_output import LinearOutput

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from vibcli.analyses.continuous.travelling_waves import WaveMotion
    from vibcli.base.work import Work

PLACES, PACE, WIDE = 32, 2.0, 16.0      # of Gauss's rule; of panels, times their fastest rate, and times σ²t
MOST = 25_000       # panels of τ times those of T
SEARCHED = 60_000   # the same times fronts that are looked at in turn
AT_ONCE = 512       # places of τ
ROUNDED = 64.0      # how often a term is rounded
SMALL = 1e-200      # z² of a front
AT, WEIGHTS = np.polynomial.legendre.leggauss(PLACES)


class DispersedMotion:
    """waves: each the WaveMotion under a unit step, or of a start, and the channel of its loads that is f."""

    def __init__(self, waves: "Sequence[tuple[WaveMotion, int]]", delta: float, square: float, work: "Work"):
        self.waves, self.delta, self.square, self.work = waves, delta, square, work
        self._known: dict[tuple, tuple[float, float]] = {}
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

    def _panels_of(self, until):
        """(WaveMotion, how many panels there are) of each load."""
        for motion, channel in self.waves:
            starts, pace = self._load(motion, channel, until)
            yield motion, 1 + len(starts) + until * self._panels(pace, until)

    def values(self, output: LinearOutput, times: np.ndarray, order: int = 0, before: bool = False) -> np.ndarray:
        """The output at instants, of order 0 alone; at a front that after it, or before it."""
        times = np.asarray(times, float)
        self.reach(times.max(initial=0.0))
        found = [self._at(output, t, before and t > 0)[0] for t in times.ravel().tolist()]
        return np.reshape(found, times.shape)

    def errors(self, output: LinearOutput, times: np.ndarray) -> np.ndarray:
        """Bounds of the errors of the same values, of rounding alone."""
        return np.array([self._at(output, float(t), False)[1] for t in times])

    def breaks(self, output: LinearOutput, until: float) -> np.ndarray:
        """The instants between which the output is smooth, ascending."""
        found = [np.zeros(1)]
        for motion, channel in self.waves:
            found.append(np.add.outer(motion.breaks(output, until), self._load(motion, channel, until)[0]).ravel())
        instants = np.unique(np.concatenate(found))
        return instants[(instants >= 0) & (instants <= until)]

    def require_bounded(self, output: LinearOutput, until: float, at: np.ndarray | None = None) -> None:
        """PhysicsError where the output is infinite."""
        for motion, _ in self.waves:
            motion.require_bounded(output, until)

    def _at(self, output, t, before):
        """(value, bound of its error)."""
        key = key_of(output), t, before
        if key not in self._known:
            parts = [self._of(motion, channel, output, t, before) for motion, channel in self.waves]
            value, error = (sum(part) for part in zip((0.0, 0.0), *parts, strict=True))
            self._known[key] = output.constant + value, error + EPSILON * abs(output.constant)
        return self._known[key]

    def _load(self, motion, channel, t):
        """(where it jumps or bends, its fastest rate)."""
        segments = motion.forcing.segments(t * (1 + SAME) + 1e-300, motion.work)
        if any(one == channel for segment in segments for one, _ in segment.impulses):
            raise NotByWaves("a blow on a member that disperses its waves is not followed by these")
        own = [(segment.start, [abs(wave.exponent) for wave in segment.waves if wave.channel == channel])
               for segment in segments]
        starts = np.array([start for start, _ in own])
        return starts, max((rate for _, rates in own for rate in rates), default=0.0) + self.delta + abs(
            self.square) ** 0.5

    def _panels(self, pace, t):
        """1/h."""
        return max(pace / PACE, abs(self.square) * t / WIDE)

    def _of(self, motion, channel, output, t, before):
        """(value, bound of its error) of what one load does."""
        output, (starts, pace) = output._replace(constant=0.0), self._load(motion, channel, t)
        fronts = motion.breaks(output, t * (1 + SAME))
        fronts = np.minimum(fronts[(fronts >= 0) & (fronts < t * (1 - SAME) if before else True)], t)
        first, last = _apart(fronts, 4 * SAME * t)
        answer = TelegraphWaves(self, np.union1d(np.maximum(t - starts, 0.0), np.linspace(
            0.0, t, 2 + int(t * self._panels(pace, t)))), lambda times: motion.values(
            LinearOutput(channels={channel: 1.0}), _snapped(times, starts, SAME * t), 0, before))
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


class TelegraphWaves:
    """W at an instant, the last of some `edges` of panels between which loads are smooth; largest: |f| up to then."""

    def __init__(self, of: DispersedMotion, edges: np.ndarray, load: "Callable[[np.ndarray], np.ndarray]"):
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

    def _within(self, tau, panel):
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

    def _tail(self, T, tau):
        """e^{−δT} σ²τ B."""
        from scipy.special import i1e, j1

        z = np.sqrt(np.maximum(abs(self.square) * (T - tau) * (T + tau), SMALL))
        B = np.exp(z - self.delta * T) * i1e(z) / z if self.square > 0 else np.exp(-self.delta * T) * j1(z) / z
        return self.square * tau * B


def _panels(low, high):
    """Places and weights of Gauss's rule, (panels, PLACES)."""
    return np.add.outer((low + high) / 2, 0 * AT) + np.outer((high - low) / 2, AT), np.outer((high - low) / 2, WEIGHTS)


def _apart(fronts, room):
    """The first and the last of each group of fronts that are one but for rounding."""
    gaps = np.flatnonzero(np.diff(fronts) > room)
    return fronts[np.append(0, gaps + 1)], fronts[np.append(gaps, len(fronts) - 1)]


def _snapped(times, starts, room):
    """Instants, those next to one of the starts being it."""
    nearest = starts[np.abs(np.subtract.outer(times, starts)).argmin(axis=-1)]
    return np.where(np.abs(times - nearest) <= room, nearest, times)
