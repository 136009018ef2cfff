"""Numbers of signals of small motions: of the steady state that loads keep up, else of the free vibration."""

import cmath
from collections.abc import Sequence
from math import cos, pi, sin, tau
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.quantities.frequency_response import wrapped
from vibcli.results import signal_features, steady_features
from vibcli.results.signals import ComposedSignal, Envelope, LinearSignal

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

ANGLE = 0.7     # no phasor of an undamped scene is at right angles to it


def _linear(problem, tree):
    """The signal as a linear output of a small motion."""
    signal = problem.response.signal(tree.args[0])
    if not isinstance(signal, LinearSignal):
        raise PhysicsError(f"'{tree.head}' is not found of {signal.KIND}", "ask for max(x), min(x) or values in time")
    return signal


def amplitude(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> float:
    """Of the steady state that loads keep up, else of the free vibration."""
    signal = _linear(problem, tree)
    if not signal_features.kept_up(signal):
        return signal_features.amplitude(signal)
    if problem.signed and signal.motion.steady.period is None:
        return sum(_signed(X) for _, X in steady_features.harmonics(signal))
    return steady_features.amplitude(signal)


def _signed(X):
    """Re X e^{−iψ}: of a phasor that passes through zero along a line it changes its sign there."""
    return X.real * cos(ANGLE) + X.imag * sin(ANGLE)


def phase(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> float:
    signal = _linear(problem, tree)
    if not signal_features.kept_up(signal):
        return wrapped(signal_features.from_the_start(signal).phase)
    found = steady_features.harmonics(signal)
    if len(found) != 1:
        raise PhysicsError(f"this steady state has no one phase: it holds {len(found) or 'no'} harmonics",
                           "ask for max(steady(x)), or its value at a time")
    return wrapped(-cmath.phase(found[0][1]) - 0.5 * pi)


def harmonic(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> float:
    signal = _linear(problem, tree)
    if not signal_features.kept_up(signal):
        raise PhysicsError("no load that repeats itself drives this signal: it has no harmonics", "ask for max(x)")
    return abs(steady_features.harmonic(signal, int(tree.indices[0])))


def _over_a_period(which):
    """Of the steady state that loads keep up, else of the free vibrations that last."""
    def value(problem, tree, args):
        signal = problem.response.signal(tree.args[0])
        if isinstance(signal, ComposedSignal | Envelope):
            from vibcli.results import composed_means

            return getattr(composed_means, which)(signal)
        signal = _linear(problem, tree)
        if not signal_features.kept_up(signal):
            return getattr(signal_features, which)(signal)
        return getattr(signal.motion.steady, which)(signal.output)
    return value


def _free(find):
    """Of a free vibration, the fractions in square brackets after the signal."""
    def value(problem, tree, args):
        return find(_linear(problem, tree), *map(float, tree.indices))
    return value


def period(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> float:
    """That of a full motion as it is found."""
    if problem.response.KIND != "small":
        return problem.response.period(tree.args[0])[0]
    signal = _linear(problem, tree)
    if signal_features.kept_up(signal):
        return tau / steady_features.fundamental(signal)
    return signal_features.free_period(signal)


mean, rms = _over_a_period("mean"), _over_a_period("rms")
decrement, beat_period = _free(signal_features.decrement), _free(signal_features.beat_period)
time_to, cycles_to = _free(signal_features.time_to), _free(signal_features.cycles_to)
