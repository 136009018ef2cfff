"""Means of functions of signals, of what lasts: of the steady state that loads keep up, else of the free vibrations
that do not die out. Of powers and products they are exact, of other functions by quadrature over the common period."""

from math import tau
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.results.signal_features import at_rest, kept_up, lasting
from vibcli.results.signals import ComposedSignal, LinearSignal, require_finite
from vibcli.results.steady_features import common
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from vibcli.results.envelope import Envelope

PANELS = 4          # of the first division for each of the fastest wave's periods
MOST_PANELS = 10_000


def mean(signal: "ComposedSignal | Envelope") -> float:
    if not isinstance(signal, ComposedSignal):
        return _over_the_beats(signal, 1)
    return _mean(signal, signal.node)


def rms(signal: "ComposedSignal | Envelope") -> float:
    """√ of the mean of the square."""
    if not isinstance(signal, ComposedSignal):
        return _over_the_beats(signal, 2) ** 0.5
    return max(0.0, _mean(signal, signal.node * signal.node)) ** 0.5


def _over_the_beats(envelope, power):
    if envelope.period is None:
        limit = envelope.final()
        if not limit:
            raise at_rest()
        return limit**power
    return _averaged(lambda t: envelope.values(t) ** power, envelope.period, [tau / envelope.period])


def _mean(signal, node):
    """Of a node of the signals of a ComposedSignal."""
    signal.require_no_time("mean")
    parts = {name: _wave_sum(part) for name, part in signal.signals.items()}
    known = {name: found for name, found in parts.items() if found is not None}
    if len(known) == len(parts):
        if not any(map(_lasts, signal.signals.values())):
            raise at_rest()
        exact = _product(node, signal.floats, known)
        if exact is not None:
            return exact.mean
    return _by_quadrature(signal, node, known)


def _lasts(part):
    """Does a signal move, or stand under loads that oscillate, without end?"""
    if isinstance(part, ComposedSignal):
        return any(map(_lasts, part.signals.values()))
    return kept_up(part) or any(speed for speed, _ in lasting(part))


def _wave_sum(part):
    """The WaveSum of what lasts of a signal; None where that has harmonics without end, or is no polynomial."""
    from vibcli.analyses.transient.wave_sums import WaveSum

    if isinstance(part, ComposedSignal):
        parts = {name: _wave_sum(one) for name, one in part.signals.items()}
        return None if None in parts.values() else _product(part.node, part.floats, parts)
    if not isinstance(part, LinearSignal):
        return None
    if not kept_up(part):
        return WaveSum.of(lasting(part))
    steady = part.motion.steady
    return None if steady.period is not None else WaveSum.of(steady.phasors(part.output))


def _product(node, floats, parts):
    """The WaveSum that a node is of others {name: WaveSum}; None of what is no polynomial."""
    from vibcli.analyses.transient.wave_sums import WaveSums, wave_sum

    try:
        return wave_sum(evaluate([node], WaveSums, {**floats, **parts})[0])
    except KeyError:
        return None


def _by_quadrature(signal, node, known):
    """Over the common period of all signals; {name: WaveSum} of those that are `known`."""
    import numpy as np

    from vibcli.symbolic.array_arithmetic import Arrays

    others = {name: part.steady if isinstance(part, LinearSignal) else part for name, part in signal.signals.items()
              if name not in known}
    speeds = [float(speed) for found in known.values() for speed in found.speeds if speed > 0]
    periods = [part.period for part in others.values()]
    base = None if None in periods else common([*speeds, *(tau / period for period in periods)])
    if base is None:
        raise PhysicsError("the vibrations in this signal have no common period: the mean of what is no polynomial of "
                           "signals is found over one", "ask for max(x), or the mean of a power")

    def values(t):
        parts = {name: found.values(t) for name, found in (*known.items(), *others.items())}
        with np.errstate(all="ignore"):
            found = evaluate([node], Arrays, {**signal.floats, **parts})[0]
        return require_finite(np.broadcast_to(found, t.shape), t)

    return _averaged(values, tau / base, speeds)


def _averaged(values, period, speeds):
    """(1/T) ∫ over a period T, of what is made of waves of these angular frequencies."""
    import numpy as np

    from vibcli.numerics.quadrature import integral

    panels = min(MOST_PANELS, max(PANELS, int(PANELS * max(speeds, default=0.0) * period / tau)))
    found = integral(values, np.linspace(0.0, period, panels + 1).tolist())
    if found is None:
        raise PhysicsError("the mean of this signal does not settle: it has no bound, or bends too often",
                           "ask for max(x), or its value at a time")
    return found / period
