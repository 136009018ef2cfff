"""Numbers of signals of small motions: of the steady state that loads keep up, else of the free vibration. Each comes
with a function that gives its absolute error."""

import cmath
from collections.abc import Callable, Sequence
from math import cos, pi, sin, tau
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.quantities.quantity import EXACT
from vibcli.results import feature_errors, signal_features, steady_features
from vibcli.results.envelope import Envelope
from vibcli.results.signals import ComposedSignal, LinearSignal
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.results.long_after import LongAfter
    from vibcli.results.problem import Problem
    from vibcli.results.responses import SmallResponse
    from vibcli.results.steady_response import SteadyResponse

    Measured = tuple[float, Callable[[], float]]

ANGLE = 0.7     # no phasor of an undamped scene is at right angles to it


def _linear(problem: "Problem", tree: QuantityRef, harmonic: int | None = None) -> LinearSignal:
    """The signal as a linear output of a small motion; of members under loads with harmonics without end of one."""
    response = problem.response_of(tree)
    response = getattr(response, "kept_up", response)
    signal = (response if harmonic is None else _of_harmonic(response, harmonic)).signal(tree.args[0])
    if not isinstance(signal, LinearSignal):
        spec = problem.spec
        falls = spec.get("forces") and not spec.get("gravity") and spec.motion is None and problem.configuration.falls
        raise PhysicsError(f"'{tree.head}' is not found of {signal.KIND}", "ask for max(x), min(x) or values in time"
                           + (", or let what drives it from the start set in, as F*step(t) does" if falls else ""))
    return signal


def _repeating(problem: "Problem", tree: QuantityRef) -> Any:
    """The steady state of members under loads with harmonics without end; None of others."""
    response, asked = problem.response_of(tree), tree.args[0]
    if response.KIND != "steady" or response.input_forcing.period is None:
        return None
    if not _repeating_part(response, tree):
        asked = QuantityRef(0, 0, f"steady({tree.text})", "steady", args=(asked,))
    return response.signal(asked)


def _long_after(problem: "Problem", tree: QuantityRef) -> "LongAfter | None":
    """What motions of members come to whose loads do not keep them up; None of others."""
    response = problem.response_of(tree)
    found: LongAfter | None = response.long_after(tree.args[0]) if hasattr(response, "long_after") else None
    return found


def _told(measured: tuple[float, float]) -> tuple[float, Callable[..., float]]:
    found, error = measured
    return found, lambda: error


def _repeating_part(response: "SmallResponse", tree: QuantityRef) -> bool:
    """Is a quantity asked of the steady state of members by that name?"""
    return response.KIND == "steady" and getattr(tree.args[0], "head", "") == "steady"


def _of_harmonic(response: "SteadyResponse", number: int) -> "SteadyResponse":
    return response.of_harmonic(number) if response.KIND == "steady" else response


def amplitude(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> "Measured":
    """Of the steady state that loads keep up, else of the free vibration."""
    repeats = _repeating(problem, tree)
    if repeats is not None:
        return _told(repeats.amplitude)
    long_after = _long_after(problem, tree)
    if long_after is not None:
        return _told(long_after.amplitude)
    signal = _linear(problem, tree)
    if not signal_features.kept_up(signal):
        found = signal_features.amplitude(signal)
    elif problem.signed and signal.motion.steady.period is None:
        found = sum(_signed(X) for _, X in steady_features.harmonics(signal))
    else:
        found = steady_features.amplitude(signal)
    return found, lambda: feature_errors.amplitude(signal)


def _signed(X: complex) -> float:
    """Re X e^{−iψ}: of a phasor that passes through zero along a line it changes its sign there."""
    return X.real * cos(ANGLE) + X.imag * sin(ANGLE)


def phase(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> "Measured":
    signal = _linear(problem, tree)
    if not signal_features.kept_up(signal):
        free = signal_features.from_the_start(signal)
        return signal_features.wrapped(free.phase), lambda: feature_errors.phase(signal)
    found = steady_features.harmonics(signal)
    if len(found) != 1:
        raise PhysicsError(f"this steady state has no one phase: it holds {len(found) or 'no'} harmonics",
                           "ask for max(steady(x)), or its value at a time")
    return signal_features.wrapped(-cmath.phase(found[0][1]) - 0.5 * pi), lambda: feature_errors.phase(signal)


def harmonic(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> "Measured":
    number = int(tree.indices[0])
    signal = _linear(problem, tree, number)
    if not signal_features.kept_up(signal):
        raise PhysicsError("no load that repeats itself drives this signal: it has no harmonics", "ask for max(x)")
    return abs(steady_features.harmonic(signal, number)), lambda: feature_errors.harmonic(signal, number)


def _over_a_period(which: str) -> "Callable[[Problem, QuantityRef, Sequence[Any]], tuple[float, Callable[..., float]]]":
    """The mean or the rms of the steady state that loads keep up, else of the free vibrations that last."""
    def value(problem: "Problem", tree: QuantityRef, args: "Sequence[Any]") -> "tuple[float, Callable[..., float]]":
        repeats = _repeating(problem, tree) if which == "rms" else None
        if repeats is not None:
            return _told(repeats.rms)
        if _repeating_part(problem.response_of(tree), tree):
            tree = tree._replace(args=tree.args[0].args)
        long_after = _long_after(problem, tree)
        if long_after is not None:
            return _told(getattr(long_after, which))
        signal = _of_harmonic(problem.response_of(tree), 0).signal(tree.args[0])
        if isinstance(signal, ComposedSignal | Envelope):
            signal = problem.response_of(tree).signal(tree.args[0])
            from vibcli.results import composed_means

            return _told(getattr(composed_means, which)(signal))
        signal = _linear(problem, tree, 0 if which == "mean" else None)
        free = not signal_features.kept_up(signal)
        found = getattr(signal_features, which)(signal) if free else getattr(signal.motion.steady, which)(
            signal.output)
        return found, lambda: getattr(feature_errors, which)(signal, found)
    return value


def _free(find: Callable[..., float],
          relative: Callable[..., float]) -> "Callable[[Problem, QuantityRef, Sequence[Any]], Any]":
    """Of a free vibration, the fractions in square brackets after the signal; `relative`: its error over its size."""
    def value(problem: "Problem", tree: QuantityRef, args: "Sequence[Any]") -> "tuple[float, Callable[[], float]]":
        signal, fractions = _linear(problem, tree), list(map(float, tree.indices))
        found = find(signal, *fractions)
        return found, lambda: abs(found) * relative(signal, *fractions)
    return value


def period(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> "Measured":
    """That of a full motion as it is found."""
    if problem.response_of(tree).KIND not in EXACT:
        return problem.response.period(tree.args[0])[0], lambda: 0.0
    repeats = _repeating(problem, tree)
    if repeats is not None:
        return repeats.period, lambda: 0.0
    long_after = _long_after(problem, tree)
    if long_after is not None:
        return _told(long_after.period)
    signal = _linear(problem, tree)
    kept_up = signal_features.kept_up(signal)
    found = tau / steady_features.fundamental(signal) if kept_up else signal_features.free_period(signal)
    return found, lambda: found * feature_errors.relative_of_period(signal)


mean, rms = _over_a_period("mean"), _over_a_period("rms")
decrement = _free(signal_features.decrement, feature_errors.relative_of_decrement)
beat_period = _free(signal_features.beat_period, feature_errors.relative_of_beats)
time_to = _free(signal_features.time_to, feature_errors.relative_of_decay)
cycles_to = _free(signal_features.cycles_to, lambda signal, fraction: (
    feature_errors.relative_of_decrement(signal) + feature_errors.relative_of_decay(signal, fraction)))
