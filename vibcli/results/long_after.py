"""What motions of members come to long after their loads have: to the equilibrium under these, about which vibrates
what nothing damps. Signals that come to rest are seen to; of all others the mean over all times is the same."""

from collections.abc import Mapping
from functools import cached_property
from math import tau
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.modal_reads import Read
from vibcli.analyses.continuous.real_modes import RealModes
from vibcli.analyses.continuous.shapes import mean_tension
from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.base.errors import PhysicsError
from vibcli.language.signal_names import signal_name
from vibcli.results.averaged_waves import common_speed
from vibcli.results.composed_errors import propagated
from vibcli.results.lasting_products import is_of_modes, mean_of_products, swings
from vibcli.results.modal_signals import ModalSignal
from vibcli.results.moved_on import SEEN, moved_on
from vibcli.results.repeating_signal import DEAD, INNER, MODES, SAMPLES, RepeatingSignal
from vibcli.results.signal_features import at_rest
from vibcli.results.signals import ComposedSignal, LinearSignal
from vibcli.results.wave_signals import ComposedOfWaves, WaveSignal
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.mechanics.factored_system import FactoredSystem
    from vibcli.numerics.pieces.piece import Piece
    from vibcli.results.response_of_members import ResponseOfMembers
    from vibcli.results.signal import Signal

GONE = 40.0         # decay times after which nothing is left in floats
ALIKE = 1e-9        # of its speed: a decay that is none
REPEATED = 64.0     # times rounding: how far what repeats itself is from itself


class LongAfter:
    """Of the signal that a tree asks of a response whose loads come to rest."""

    def __init__(self, response: "ResponseOfMembers", tree: Any) -> None:
        self.response, self.tree, self.problem = response, tree, response.problem

    @cached_property
    def signal(self) -> "Signal":
        """As it moves."""
        return self.response.signal(self.tree)

    @cached_property
    def still(self) -> tuple[float, float]:
        """(its value in the equilibrium under the last loads, how far that may be off); PhysicsError where loads or
        members keep nothing still."""
        if self._loads.period is not None or not self._loads.listed:
            raise PhysicsError("loads keep this signal in motion: it has no limit", "ask for max(x), or mean(x)")
        drifts = any(mode.rigid for mode in self.problem.modal.modes.shown()) and self._drifts
        shift, off = moved_on(self._by_modes, self._loads.last.start, self._longest) if drifts else (0.0, 0.0)
        if any(-decay > error for decay, error in self._pairs):
            raise PhysicsError("what vibrates grows without end: it has neither limit nor mean",
                               "ask for its value at a time")
        value, error = _still(self._kept)
        return value + shift, error + off

    @property
    def _drifts(self) -> bool:
        """Does it see a motion that nothing holds?"""
        if self._steady or (isinstance(self.tree, NameRef) and signal_name(self.tree.name).kind in INNER):
            return False
        return _drifts(self._by_modes)

    @property
    def _steady(self) -> bool:
        """Is only the steady state of a signal asked?"""
        return getattr(self.tree, "head", "") == "steady"

    @property
    def _by_modes(self) -> "Signal":
        """The signal as modes tell it, of whatever motion is followed."""
        signal = self.signal
        if isinstance(signal, WaveSignal | ComposedOfWaves):
            found: Signal = self.response.modal.signal(self.tree)      # type: ignore[attr-defined]
            return found
        return signal

    @cached_property
    def _kept(self) -> LinearSignal | ComposedSignal:
        return cast("LinearSignal | ComposedSignal", self.response.kept_up.signal(self.tree))

    @property
    def _loads(self) -> "Forcing":
        return self.response.kept_up.input_forcing

    @cached_property
    def final(self) -> tuple[float, float]:
        """(its limit, how far that may be off); PhysicsError where it vibrates on."""
        value, error = self.still
        left = self._left
        if left is None and not 0 < len(self._decays) == len(self._pairs):
            raise PhysicsError("what vibrates in this signal does not die out: it has no limit",
                               "ask for mean(x), or damp what vibrates")
        if left is None:
            raise PhysicsError("what vibrates in this signal has not died out long after modes far down have: whether "
                               "it has a limit is not told", "ask for mean(x), or damp where it vibrates")
        return value, error + left

    @cached_property
    def _left(self) -> float | None:
        """How far it may be from its limit long after; None where it is seen to move then."""
        if _dies_out(self.signal):
            return 0.0
        start, window = self._last, self._longest
        decays = self._decays
        late = start + (GONE / min(decays) if decays else window)
        times = late + window * np.linspace(0.0, 1.0, SAMPLES)
        signal = self.signal.read_at(float(times[-1]))
        apart = float(np.abs(signal.values(times) - self.still[0]).max())
        size = max(float(np.abs(signal.values(start + window * np.linspace(0.0, 1.0, SAMPLES))).max()), abs(
            self.still[0]))
        known = max(DEAD * size, signal.error(float(times[-1])))
        return known if apart <= known + self.still[1] else None

    @property
    def _last(self) -> float:
        """From when on its loads do not change but for what dies out."""
        fades = [-wave.exponent.real for wave in self._loads.last.waves if wave.exponent.real < 0]
        return self._loads.last.start + (GONE / min(fades) if fades else 0.0)

    @cached_property
    def _damped(self) -> list[Any]:
        damped = self.problem.modal.damped
        return [] if damped is None else damped.first(MODES)

    @property
    def _decays(self) -> list[float]:
        """Those of damped modes that are seen to be damped."""
        return [decay for decay, error in self._pairs if decay > error]

    @property
    def _pairs(self) -> list[Any]:
        """[(decay, how far it may be off)] of the first damped modes."""
        return [(-float(mode.eigenvalue.real), abs(complex(mode.eigenvalue)) * float(mode.error))
                for mode in self._damped if mode.eigenvalue]

    @cached_property
    def _longest(self) -> float:
        """A time in which all that vibrates has swung once, and each wave has come back."""
        periods = [tau / float(mode.omega) for mode in self.problem.modal.modes.shown() if mode.omega]
        return max(periods, default=0.0) + 2 * sum(_way(placed.piece) for placed in self.response.placed)

    @cached_property
    def mean(self) -> tuple[float, float]:
        """(over all times, how far it may be off); PhysicsError where it comes to rest."""
        found = self.still
        if _driven(self.problem.configuration.linear_system):
            raise PhysicsError("a damper drives these members, and where some of what vibrates grows there is no "
                               "mean", "ask for final(x), or for its value at a time")
        if self.problem.modal.damped is not None and self._left is not None:
            raise at_rest()
        return found if isinstance(self._kept, LinearSignal) else self._of_function

    @property
    def _of_function(self) -> tuple[float, float]:
        """Of a function of signals."""
        signal, kept, repeats = self._by_modes, self._kept, self.repeating
        if repeats is not None:
            return repeats.mean
        if self.problem.modal.damped is not None or not is_of_modes(signal) or isinstance(kept, LinearSignal):
            raise PhysicsError("means of functions of these signals are not found: some of what vibrates dies out, or "
                               "is read off waves and modes together", "ask for mean(x) of a single signal")
        still = {name: _still(part) for name, part in kept.signals.items()}
        return mean_of_products(signal, self._loads.last.start, still)

    @cached_property
    def rms(self) -> tuple[float, float]:
        """(root of the mean square over all times, how far it may be off)."""
        if not isinstance(self._kept, LinearSignal):
            if self.repeating is not None:
                return self.repeating.rms
            raise PhysicsError("the root mean square of functions of signals of members that vibrate freely is not "
                               "found", "ask for mean(x^2), or for rms(x) of a single signal")
        mean, error = self.mean
        square, off = self._square
        found = (mean**2 + square) ** 0.5
        return found, (2 * abs(mean) * error + off) / found if found else (error**2 + off) ** 0.5

    @property
    def _square(self) -> tuple[float, float]:
        """(mean square about the mean, how far it may be off)."""
        if self._steady:
            return 0.0, 0.0
        repeats = self.repeating
        if repeats is not None:
            return repeats.mean_square(self.still[0])
        if self.problem.modal.damped is not None:
            raise PhysicsError("the mean square is not found where some of what vibrates dies out", "ask for mean(x)")
        signal = self._by_modes
        if not isinstance(signal, ModalSignal):
            raise PhysicsError("the mean square is not found of what is read off waves and modes together",
                               "ask for that of a single signal")
        vibrations = swings(signal, self._loads.last.start)
        return vibrations.product(vibrations)

    @cached_property
    def repeating(self) -> RepeatingSignal | None:
        """What repeats itself, as waves bring it back; None where it is not seen to."""
        modal, waves = self.problem.modal, isinstance(self.signal, WaveSignal | ComposedOfWaves)
        speed = common_speed(modal.modes) if waves and modal.damped is None else None
        if speed is None:
            return None
        period, start = tau / speed, self._last + self._longest
        times = start + period * (np.linspace(0.0, 1.0, SAMPLES)[:-1] + 1 / (3 * SAMPLES))
        try:
            earlier, later = self.signal.values(times), self.signal.values(times + period)
        except NotByWaves:
            return None
        apart, known = float(np.abs(later - earlier).max()), self.signal.error(float(times[-1] + period))
        if apart > REPEATED * known + DEAD * float(np.abs(later).max()):
            return None
        return RepeatingSignal(self.signal, period, start, max(apart, known))

    @property
    def amplitude(self) -> tuple[float, float]:
        """(half the range of what repeats itself, how far it may be off)."""
        self.still  # noqa: B018 - do loads come to rest?
        if self.repeating is None:
            raise PhysicsError("the vibrations of this signal have no common period that is seen: no one amplitude is "
                               "that of all", "ask for max(x) and min(x)")
        return self.repeating.amplitude

    @property
    def period(self) -> tuple[float, float]:
        """(that of what repeats itself, how far it may be off)."""
        if self.repeating is None:
            raise PhysicsError("the vibrations of this signal have no common period that is seen", "ask for max(x)")
        return self.repeating.period, DEAD * self.repeating.period


def _still(signal: LinearSignal | ComposedSignal) -> tuple[float, float]:
    """(value, how far it may be off) of what loads keep up that do not oscillate."""
    if not isinstance(signal, LinearSignal):
        signal.require_no_time("limit")
        parts = {name: _still(part) for name, part in signal.signals.items()}
        values, errors = ({name: part[k] for name, part in parts.items()} for k in range(2))

        def function(known: "Mapping[str, float]") -> float:
            found: float = evaluate([signal.node], Floats, {**signal.floats, **known})[0]
            return found
        return function(values), propagated(function, values, errors)
    steady = signal.motion.steady
    if any(rate for rate, _ in steady.phasors(signal.output)):
        raise PhysicsError("loads keep this signal in motion: it has no limit", "ask for max(x), or mean(x)")
    return steady.mean(signal.output), float(steady.errors(signal.output, np.zeros(1))[0])


def _dies_out(signal: "Signal") -> bool:
    """Do all modes that a signal is read off, those too that are left out?"""
    if isinstance(signal, ComposedSignal):
        return all(map(_dies_out, signal.signals.values()))
    if not isinstance(signal, ModalSignal):
        return False
    modes, rates = signal.modal.modes, signal.modal.states.rates
    rates = rates[rates != 0]       # what nothing holds is seen to apart
    least = 0.0 if isinstance(modes, RealModes) else ALIKE * abs(rates)     # others are found, not given
    return modes.fading < 0 and bool((rates.real < -least).all())


def _driven(system: "FactoredSystem") -> bool:
    """Is there damping that drives, of stations or along pieces? Modes far up may grow then."""
    from vibcli.analyses.continuous.dynamic_matrix import dynamic_matrix

    C = dynamic_matrix(system).polynomial[1]
    rates = np.linalg.eigvalsh((C + C.T) / 2)
    return bool((rates < -SEEN * abs(rates).max(initial=0.0)).any()) or any(
        placed.piece.drag < 0 or placed.retardation < 0 for placed in system.pieces)


def _drifts(signal: "Signal") -> bool:
    """Does a signal see a motion that nothing holds, or is that not told?"""
    if isinstance(signal, ComposedSignal):
        return any(map(_drifts, signal.signals.values()))
    if not isinstance(signal, ModalSignal):
        return True
    motion, reads = signal.modal, signal.reads
    kinds: list[dict[Any, Any]] = [reads.q, reads.v, reads.a, {}, reads.places]
    parts = [LinearOutput(0.0, *({key: x} if i == k else {} for i in range(5)))
             for k, kind in enumerate(kinds) for key, x in kind.items()]

    def seen(output: LinearOutput) -> np.ndarray:
        read = Read(motion, output, 0)
        return np.concatenate([read.rigid.ravel(), read.states[motion.states.rates == 0]])
    sizes = sum(abs(seen(part)) for part in parts)
    return bool((abs(seen(reads)) > SEEN * sizes).any())


def _way(piece: "Piece") -> float:
    """The time in which a wave runs along a piece; 0 where it has no speed."""
    return float(piece.length) * (float(piece.inertia / mean_tension(piece)) ** 0.5 if piece.order == 2 else 0.0)
