"""Means of functions of signals, of what lasts: of the steady state that loads keep up, else of the free vibrations
that do not die out. Of powers and products they are exact, of other functions by quadrature over the common period.
Each comes with an absolute bound of its error: (mean, bound)."""

from collections.abc import Callable, Mapping, Sequence
from math import tau
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.results import feature_errors
from vibcli.results.cancelled_drifts import next_to_zero, require_cancelled
from vibcli.results.composed_errors import propagated
from vibcli.results.feature_errors import SAMPLES
from vibcli.results.signal import require_finite
from vibcli.results.signal_features import at_rest, beside_drift, kept_up
from vibcli.results.signals import ComposedSignal, LinearSignal
from vibcli.results.steady_features import common
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.transient.wave_sums import WaveSum
    from vibcli.results.envelope import Envelope
    from vibcli.results.signal import Signal
    from vibcli.symbolic.node import Node

PANELS = 4          # of the first division for each of the fastest wave's periods
MOST_PANELS = 10_000


def mean(signal: "ComposedSignal | Envelope") -> tuple[float, float]:
    if not isinstance(signal, ComposedSignal):
        return _over_the_beats(signal, 1)
    return _mean(signal, signal.node)


def rms(signal: "ComposedSignal | Envelope") -> tuple[float, float]:
    """√ of the mean of the square."""
    square, error = _mean(signal, signal.node * signal.node) if isinstance(signal, ComposedSignal) else _over_the_beats(
        signal, 2)
    found = max(0.0, square) ** 0.5
    return found, error / max(found, error**0.5) if error else 0.0


def _over_the_beats(envelope: "Envelope", power: int) -> tuple[float, float]:
    if envelope.period is None:
        limit = envelope.final()
        if not limit:
            raise at_rest()
        return limit**power, power * limit ** (power - 1) * envelope.error_of_final()
    found = _averaged(lambda t: envelope.values(t) ** power, envelope.period, [tau / envelope.period])
    largest = envelope.extreme(0.0, envelope.period, 1)[1] if power > 1 else 1.0
    return found, 2 * power * largest * max(envelope.error(envelope.period * k / SAMPLES) for k in range(SAMPLES))


def _mean(signal: ComposedSignal, node: "Node") -> tuple[float, float]:
    """Of a node of the signals of a ComposedSignal."""
    signal.require_no_time("mean")
    require_cancelled(signal, node)
    parts = {name: _wave_sum(part) for name, part in signal.signals.items()}
    known = {name: found for name, found in parts.items() if found is not None}
    if len(known) == len(parts):
        if not any(map(_lasts, signal.signals.values())):
            raise at_rest()
        exact = _product(node, signal.floats, known)
        if exact is not None:
            return exact.mean
    return _by_quadrature(signal, node, known)


def _lasts(part: LinearSignal) -> bool:
    """Does a signal move, or stand under loads that oscillate, without end?"""
    if isinstance(part, ComposedSignal):
        return any(map(_lasts, part.signals.values()))
    return kept_up(part) or any(speed for speed, _ in beside_drift(part))


def _wave_sum(part: LinearSignal) -> "WaveSum | None":
    """The WaveSum of what lasts of a signal, beside what drifts; None where that has harmonics without end, or is no
    polynomial."""
    from vibcli.analyses.transient.wave_sums import WaveSum

    if isinstance(part, ComposedSignal):
        require_cancelled(part, part.node)
        parts = {name: _wave_sum(one) for name, one in part.signals.items()}
        return None if None in parts.values() else _product(part.node, part.floats, parts)
    if not isinstance(part, LinearSignal):
        return None
    if not kept_up(part):
        return WaveSum.of(beside_drift(part), feature_errors.of_lasting(part))
    steady = part.motion.steady
    if steady.period is not None:
        return None
    waves = [(0.0, complex(steady.polynomial(part.output)[0])), *steady.oscillating(part.output)]
    return WaveSum.of(waves, feature_errors.of_waves(part, waves))


def _product(node: "Node", floats: Mapping[str, float], parts: "Mapping[str, WaveSum]") -> "WaveSum | None":
    """The WaveSum that a node is of others {name: WaveSum}; None of what is no polynomial."""
    from vibcli.analyses.transient.wave_sums import WaveSums, wave_sum

    try:
        return wave_sum(evaluate([node], WaveSums, {**floats, **parts})[0])
    except KeyError:
        return None


def _by_quadrature(signal: ComposedSignal, node: "Node",
                   known: "Mapping[str, WaveSum]") -> tuple[float, float]:
    """Over the common period of all signals; {name: WaveSum} of those that are `known`."""
    import numpy as np

    from vibcli.symbolic.array_arithmetic import Arrays

    others = {name: LinearSignal(part.motion.steady, part.output, "steady") if isinstance(part, LinearSignal) else part
              for name, part in signal.signals.items() if name not in known}
    speeds = [float(speed) for found in known.values() for speed in found.speeds if speed > 0]
    periods = [part.period for part in others.values()]
    base = None if None in periods else common([*speeds, *(tau / period for period in periods)])
    if base is None:
        raise PhysicsError("the vibrations in this signal have no common period: the mean of what is no polynomial of "
                           "signals is found over one", "ask for max(x), or the mean of a power")

    beside = next_to_zero(signal)

    moving: dict[str, WaveSum | Signal] = {**known, **others}

    def values(t: "np.ndarray") -> "np.ndarray":
        parts = {name: found.values(t) + beside.get(name, 0.0) for name, found in moving.items()}
        with np.errstate(all="ignore"):
            found = evaluate([node], Arrays, {**signal.floats, **parts})[0]
        return require_finite(np.broadcast_to(found, t.shape), t)

    period = tau / base
    off = _of_values(signal, node, known, others, period)
    return _averaged(values, period, speeds, off), 2 * off


def _of_values(signal: ComposedSignal, node: "Node", known: "Mapping[str, WaveSum]",
               others: "Mapping[str, Signal]", period: float) -> float:
    """The largest bound of the error of the values of what is averaged, at instants of a period, twice."""
    import numpy as np

    moving: dict[str, WaveSum | Signal] = {**known, **others}

    def at(t: float) -> float:
        here = {name: float(found.values(np.array([t]))[0]) for name, found in moving.items()}
        errors = {name: float(found.errors.sum()) for name, found in known.items()}
        errors |= {name: found.error(t) for name, found in others.items()}
        return propagated(lambda values: evaluate([node], Floats, {**signal.floats, **values})[0], here, errors)

    return 2 * max(at(period * (k + 0.5) / SAMPLES) for k in range(SAMPLES))


def _averaged(values: "Callable[[np.ndarray], np.ndarray]", period: float, speeds: Sequence[float],
              off: float = 0.0) -> float:
    """(1/T) ∫ over a period T, of what is made of waves of these angular frequencies, its values `off` at most."""
    import numpy as np

    from vibcli.numerics.quadrature import integral

    panels = min(MOST_PANELS, max(PANELS, int(PANELS * max(speeds, default=0.0) * period / tau)))
    found = integral(values, np.linspace(0.0, period, panels + 1).tolist(), off)
    if found is None:
        raise PhysicsError("the mean of this signal does not settle: it has no bound, or bends too often",
                           "ask for max(x), or its value at a time")
    return found / period
