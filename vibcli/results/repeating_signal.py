"""The steady state of members under loads that repeat themselves with jumps: the motion in time so many periods later
that what it started with has died out. Nothing is cut off: fronts stand where they are, and what modes leave out keeps
its bound."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from math import ceil
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.base.errors import NoBound, PhysicsError
from vibcli.language.signal_names import signal_name
from vibcli.results.averaged_waves import averaged, fits_into
from vibcli.results.modal_signals import ModalSignal
from vibcli.results.signal import Signal
from vibcli.results.signals import LinearSignal
from vibcli.results.without_bound import whenever
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.results.problem import Problem
    from vibcli.results.steady_response import SteadyResponse
    from vibcli.symbolic.syntax import Power, Sum

FIRST, MOST = 16, 2048      # periods after which it is looked at first, and at most
JUMPS = 16_384      # pieces of a load that are followed
MODES = 12          # free vibrations that are looked at one by one
SAMPLES, DEAD = 257, 2.0**-49       # instants of a period; of the largest value: a difference that is rounding
SURE = 4.0          # times what is known: what is more than that is there
HARMONICS = "ask for harmonic[1](…), harmonic[2](…) and so on of single signals"
INNER = "force", "moment", "shear", "stress"       # what a free motion does not change
PANELS, NODES = 64, (12, 8)     # of a period, and of Gauss's rule on each of them
MANY = 256          # of them that are not divided further
HALVES = 16         # times that panels are halved on which the rules differ, as next to fronts at small masses
BEHIND = 1e-12      # relative: how far an instant may be before a front that it stands for


class RepeatingSignal(Signal):
    """A motion in time from `start` on, a multiple of its period; left: how far it may be from what repeats itself.
    aside: by how much its mean is larger than that of what loads keep up, where nothing holds it."""

    KIND = "a steady state that repeats itself"

    def __init__(self, signal: Signal, period: float, start: float, left: float, aside: float = 0.0) -> None:
        self.signal, self.start, self.left, self.aside = signal, start, left, aside
        self.period: Any = period
        self._tops: dict[tuple[float, float], tuple[float, float]] = {}     # as told, and as the signal has them

    def _late(self, times: np.ndarray | float) -> np.ndarray:
        late: np.ndarray = np.asarray(times, float) % self.period + self.start
        fronts = self.signal.fronts(self.start + self.period)
        if not len(fronts):
            return late
        after = fronts[np.minimum(np.searchsorted(fronts, late), len(fronts) - 1)]
        found: np.ndarray = np.where((after >= late) & (after - late <= BEHIND * late), after, late)
        return found

    def values(self, times: np.ndarray, order: int = 0) -> np.ndarray:
        late = self._late(times)
        return self.signal.values(late, order) if order else self.signal.values(late) - self.aside

    def extreme(self, start: float, end: float, sense: int) -> tuple[float, float]:
        """(instant, value) of the largest (sense 1) or smallest (−1) value within a period."""
        end = min(end, start + self.period)
        with _all_along():
            late = self.signal.extreme(start + self.start, end + self.start, sense)
        top = late[0] - self.start, late[1] - self.aside
        self._tops[top] = late
        return top

    def error(self, t: float) -> float:
        return self.signal.error(float(self._late(t))) + self.left

    def told_zero(self, t: float) -> float:
        return self.signal.told_zero(self.start + self.period)

    @property
    def is_estimated(self) -> bool:
        return self.signal.is_estimated

    @property
    def why_estimated(self) -> str:
        return self.signal.why_estimated

    def error_of_extreme(self, start: float, end: float, top: tuple[float, float], sense: int) -> float:
        end = min(end, start + self.period)
        late = self._tops.get(top, (top[0] + self.start, top[1] + self.aside))
        return self.signal.error_of_extreme(start + self.start, end + self.start, late, sense) + self.left

    def error_of_time(self, t: float) -> float:
        return self.signal.error_of_time(t + self.start)

    def zeros(self, start: float, end: float) -> list[float]:
        """Instants within a period at which it passes or touches zero."""
        if self.aside:
            raise PhysicsError("zeros are not found of the steady state of members that nothing holds",
                               "ask for max(steady(x)), or for values at instants")
        end = min(end, start + self.period)
        found = self.signal.zeros(start + self.start, end + self.start)
        return [t - self.start for t in found]

    def error_of_zero(self, t: float) -> float:
        return self.signal.error_of_zero(t + self.start)

    @property
    def amplitude(self) -> tuple[float, float]:
        """(half its range over a period, how far that may be off)."""
        tops = [(sense, self.extreme(0.0, self.period, sense)) for sense in (1, -1)]
        error = sum(self.error_of_extreme(0.0, self.period, top, sense) for sense, top in tops)
        return 0.5 * (tops[0][1][1] - tops[1][1][1]), 0.5 * error

    def mean_square(self, about: float) -> tuple[float, float]:
        """(the mean of the square of its distance from a value over a period, how far that may be off)."""
        return self._averaged(lambda values: (values - self.aside - about) ** 2,
                              lambda most: 2 * max(abs(most - self.aside - about)))

    @property
    def mean(self) -> tuple[float, float]:
        """(its mean over a period, how far that may be off)."""
        return self._averaged(lambda values: values - self.aside, lambda most: 1.0)

    def _averaged(self, function: Callable[..., Any], slope: Callable[..., Any]) -> tuple[float, float]:
        """(the mean of a function of its values over a period, how far that may be off); slope: by how much it changes
        with some of them at most."""
        with _all_along():
            return self._by_panels(function, slope)

    def _by_panels(self, function: Callable[..., Any], slope: Callable[..., Any]) -> tuple[float, float]:
        self.signal.require_bounded(self.start + self.period)
        edges = _edges(self.period, [self.signal.fronts(self.start + self.period) - self.start])
        known = float(slope(self.signal.values(self.start + edges))) * (
            self.left + self.signal.error(self.start + self.period))
        for _ in range(HALVES):
            fine, coarse = (_panels(lambda t: function(self.signal.values(t)), self.start, edges, order) / self.period
                            for order in NODES)
            off = abs(fine - coarse)
            if off.sum() <= max(known, DEAD * abs(fine).sum()) or len(off) > MANY:
                break
            steep = off * len(off) > known + DEAD * abs(fine).sum()
            edges = np.unique(np.concatenate([edges, (edges[1:] + edges[:-1])[steep] / 2]))
        return float(fine.sum()), float(off.sum()) + known

    @property
    def rms(self) -> tuple[float, float]:
        """(root of its mean square, how far that may be off)."""
        square, error = self.mean_square(0.0)
        found = square**0.5
        return found, error / found if found else error**0.5

    @property
    def steady(self) -> "RepeatingSignal":
        return self

    def along(self, end: float) -> Any:
        """It has no few parts with known bounds."""
        raise KeyError(self.KIND)


@contextmanager
def _all_along() -> Iterator[None]:
    """Of a whole period no instants are later on."""
    try:
        yield
    except NoBound as error:
        raise error.told(hint=whenever(str(error.hint), HARMONICS)) from None


def repeating(response: "SteadyResponse", tree: Any) -> RepeatingSignal:
    """The RepeatingSignal of a tree under periodic loads; PhysicsError where free vibrations do not die out within
    MOST periods from its `since` on."""
    problem, forcing = response.problem, response.input_forcing
    if problem.modal.damped is None:
        return _undamped(problem, tree, forcing)
    period = float(forcing.period)
    count, before = FIRST, ceil(forcing.since / period)
    most = min(MOST, JUMPS // len(forcing.pieces) - before)
    if most < FIRST:
        raise PhysicsError("what drives this scene jumps or bends too often to be followed until free vibrations have "
                           "died out", f"let it begin earlier or repeat itself sooner, or {HARMONICS}")
    ahead, times = _ahead(problem, period), np.linspace(0.0, period, SAMPLES)[:-1] + period / (3 * SAMPLES)
    signal = problem.response.signal(tree)
    while count <= most:
        late = before + count
        try:
            values = signal.values(np.concatenate([times + (late - 1) * period, times + late * period]))
        except NotByWaves as error:
            more = str(error.hint).removeprefix("ask for an earlier end, ")
            raise error.told(hint=f"damp them more, {HARMONICS}, {more}") from None
        earlier, later = values[:len(times)], values[len(times):]
        apart = float(np.abs(later - earlier).max())
        pace = float(np.abs(np.diff(later)).max()) / float(times[1] - times[0])
        known = max(DEAD * max(float(np.abs(later).max()), pace * late * period),      # as instants round
                    signal.error(late * period + float(times[-1])))
        if apart <= known:
            aside, error = _aside(response, tree, signal, late * period)
            looked = signal.coarse if error else signal     # as no mean is known better than values at instants are
            return RepeatingSignal(looked, period, late * period, apart / ahead + error, aside)
        if isinstance(signal, ModalSignal):
            _require_dying(signal, late - 1, period, most - count, known * most / count)
        count *= 2
    raise _lasting(count // 2)


def _require_dying(signal: ModalSignal, before: int, period: float, more: int, known: float) -> None:
    """The same PhysicsError where what some mode changes by from one period to the next, after so many of them, is more
    than is known even some more later."""
    sizes, rates = signal.modal.changes(signal.reads, before * period, period)
    left = sizes * np.exp(rates.real * more * period)
    if left.max(initial=0.0) > SURE * known:
        raise _lasting(before + 1 + more, float(abs(rates[np.argmax(left)])))


def _lasting(periods: int, omega: float | None = None) -> PhysicsError:
    own = "" if omega is None else f", that of {omega:.5g} rad/s least of all"
    return PhysicsError(f"free vibrations of these members have not died out after {periods} periods of this load{own}",
                        f"damp them more, where they move, or {HARMONICS}")


def _undamped(problem: "Problem", tree: "NameRef | Power | Sum", forcing: "Forcing") -> RepeatingSignal:
    found = averaged(problem, problem.response.signal(tree), float(forcing.period), float(forcing.since))
    if found is None:
        raise PhysicsError("free vibrations of these members never die out, and some harmonic of this load may meet "
                           "any of them: the sum of all is not found", f"damp the scene, or {HARMONICS}")
    signal, start, left = found
    return RepeatingSignal(signal, float(forcing.period), start, left)


def _ahead(problem: "Problem", period: float) -> float:
    """How far any free vibration is from itself a period later, as a part of itself; PhysicsError where that is 0:
    what is not damped and fits into the period is not told from what loads keep up."""
    found = 2.0
    for mode in problem.modal.damped.first(MODES):
        turned = complex(mode.eigenvalue) * period
        apart = abs(np.expm1(turned))
        if turned and apart <= 2 * abs(turned) * float(mode.error + DEAD):
            raise fits_into(mode.index, "not seen to be damped", f"damp it, or {HARMONICS}")
        found = min(found, apart) if turned else found
    return found


def _aside(response: "SteadyResponse", tree: NameRef, signal: ModalSignal, start: float) -> tuple[float, float]:
    """(by how much the mean of a motion in the period from `start` on is larger than that which loads keep up, a bound
    of the error of that): where nothing holds the members, it is what they started with that sets it."""
    if not any(not mode.eigenvalue for mode in response.problem.modal.damped.first(MODES)) or (
            isinstance(tree, NameRef) and (tree.primes or signal_name(tree.name).kind in INNER)):
        return 0.0, 0.0
    still, forcing = response.of_harmonic(0).signal(tree), response.input_forcing
    if not isinstance(still, LinearSignal):
        raise PhysicsError("the steady state of functions of signals is not found of members that nothing holds",
                           "ask for that of single signals")
    changes = np.array([(piece.start - forcing.since) % forcing.period for piece in forcing.pieces])
    edges = _edges(forcing.period, [signal.fronts(start + forcing.period) - start, changes])
    fine, coarse = (_mean(signal.values, start, edges, order) for order in NODES)
    mean = still.motion.steady.mean(still.output)
    size = float(np.abs(signal.values(start + edges)).max())
    return fine - mean, abs(fine - coarse) + DEAD * size + signal.error_of_mean(start, start + float(edges[-1]))


def _edges(period: float, bends: Sequence[np.ndarray]) -> np.ndarray:
    """Of the panels of a period, and what bends within it."""
    found = np.concatenate([np.linspace(0.0, period, PANELS + 1), *bends])
    return np.unique(found[(found >= 0.0) & (found <= period)])


def _mean(values: Callable[[np.ndarray], np.ndarray], start: float, edges: np.ndarray, order: int) -> float:
    """The mean of a function between edges."""
    found: float = float(_panels(values, start, edges, order).sum()) / (edges[-1] - edges[0])
    return found


def _panels(values: Callable[[np.ndarray], np.ndarray], start: float, edges: np.ndarray, order: int) -> np.ndarray:
    """The integrals of a function over the stretches between edges by Gauss's rule on each of them."""
    at, weights = np.polynomial.legendre.leggauss(order)
    middle, half = (edges[1:] + edges[:-1]) / 2, np.diff(edges) / 2
    values = values(start + (middle[:, None] + half[:, None] * at).ravel()).reshape(-1, order)
    return half * (values @ weights)
