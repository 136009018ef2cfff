"""Signals of what waves travel through: smooth between fronts, and at a front two values."""

from typing import TYPE_CHECKING, Any, TypeAlias

from vibcli.base.errors import PhysicsError
from vibcli.numerics.chebyshev import N
from vibcli.results.signal import Signal
from vibcli.results.signals import ComposedSignal

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.continuous.dispersed_waves import DispersedMotion
    from vibcli.analyses.continuous.travelling_waves import WaveMotion
    from vibcli.analyses.continuous.travelling_waves_search import Stretches
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.results.boundless_signal import BoundlessSignal

BENDING = "abs", "sign", "ramp", "step", "min", "max"
FRONT = 1e-12       # relative: how far the instant of a front may be off
RUNS = 4            # stretches of the time in which an extreme is looked for


def _at_front(signal: "AtFronts", t: float) -> bool:
    import numpy as np

    return bool((np.abs(signal.fronts(t) - t) <= FRONT * t).any())


def _of_instant(signal: "AtFronts", t: float, order: int) -> float:
    """The error of an instant between fronts by difference quotients, in the pace of its series there."""
    from vibcli.results.composed_errors import at_pace

    if not t or _at_front(signal, t):
        return FRONT * t
    return at_pace(signal, t, order, N / float(_along(signal, 0.0, t).lengths[-1]))


def _error_of_top(signal: "AtFronts", t: float) -> float:
    return _of_instant(signal, t, 1)


def _error_of_zero(signal: "AtFronts", t: float) -> float:
    return _of_instant(signal, t, 0)


def _before(signal: "AtFronts", t: float) -> float | None:
    """Its value before an instant at which it leaps, else None."""
    import numpy as np

    at = np.array([t])
    before, after = float(signal.values_before(at)[0]), float(signal.values(at)[0])
    rounding = 4 * signal.error(t) + FRONT * max(abs(before), abs(after))
    return before if t > 0 and abs(before - after) > rounding else None


def _sampled(signal: "AtFronts", times: "np.ndarray") -> "np.ndarray":
    """Its values; where two samples stand at one instant, the first is that before it."""
    import numpy as np

    signal.require_bounded(times[-1])
    found = signal.values(times)
    first = np.flatnonzero(times[:-1] == times[1:])
    found[first] = signal.values_before(times[first])
    return found


def _along(signal: "AtFronts", start: float, end: float) -> "Stretches":
    from vibcli.analyses.continuous.travelling_waves_search import stretches

    signal.require_bounded(end)
    return stretches(signal.values, signal.breaks(end), start, end, signal.work)


def _extreme(signal: "AtFronts", start: float, end: float, sense: int) -> tuple[float, float]:
    """(instant, value) of the largest (sense 1) or smallest (−1) value, at a front that before it or after it."""
    from vibcli.analyses.continuous.travelling_waves_search import extreme

    return extreme(_along(signal, start, end), sense, signal.error(end))


def _zeros(signal: "AtFronts", start: float, end: float) -> list[float]:
    """Instants at which it passes, touches or leaps over zero."""
    from vibcli.analyses.continuous.travelling_waves_search import zeros

    found: list[float] = zeros(_along(signal, start, end), end, signal.error(end)).tolist()
    return found


def _read_at(signal: "WaveSignal | ComposedOfWaves", t: float) -> Signal:
    return signal.asked[0].best_at(signal, t) if signal.asked else signal


def _leaps(signal: "AtFronts", end: float) -> list[tuple[float, float, float]]:
    """[(instant, value before, value after)] of its fronts."""
    import numpy as np

    at = signal.fronts(end)
    at = at[(at > 0) & (at <= end)]
    before, after = signal.values_before(at), signal.values(at)
    size = np.abs(after).max(initial=0.0)
    found: list[tuple[float, float, float]] = []
    for t, one, other in zip(at.tolist(), before.tolist(), after.tolist(), strict=True):
        if abs(one - other) > 4 * signal.error(t) + FRONT * size and not (found and t - found[-1][0] <= FRONT * t):
            found.append((t, one, other))
    return found


def _without_limit(signal: "AtFronts") -> PhysicsError:
    return PhysicsError(f"the limit of {signal.KIND} is not found", "ask for its value at a late instant")


class DispersedSignal(Signal):
    """A linear output of a motion that waves bring, of a DispersedMotion at least."""

    KIND = "a motion whose waves disperse"
    sampled, before, leaps, extreme, zeros = _sampled, _before, _leaps, _extreme, _zeros
    error_of_time, error_of_zero = _error_of_top, _error_of_zero

    def __init__(self, waves: "WaveMotion | DispersedMotion", output: "LinearOutput") -> None:
        self.waves: Any = waves
        self.reads, self.work = output, waves.work

    def values(self: "OfWaves", times: "np.ndarray", order: int = 0) -> "np.ndarray":
        found: np.ndarray = self.waves.values(self.reads, times, order)
        return found

    def values_before(self: "OfWaves", times: "np.ndarray") -> "np.ndarray":
        found: np.ndarray = self.waves.values(self.reads, times, before=True)
        return found

    def breaks(self: "OfWaves", end: float) -> "np.ndarray":
        """The instants up to an end between which it is smooth, ascending."""
        found: np.ndarray = self.waves.breaks(self.reads, end)
        return found

    def fronts(self: "OfWaves", end: float) -> "np.ndarray":
        return self.breaks(end)

    def require_bounded(self: "OfWaves", end: float) -> None:
        self.waves.require_bounded(self.reads, end)

    def highest(self, cells: "np.ndarray", sense: int) -> tuple[float, float] | None:
        """(instant, value) of the largest (sense 1) or smallest (−1) value within cells, ascending, (…, 2); None where
        these are many stretches of the time."""
        import numpy as np

        from vibcli.analyses.continuous.travelling_waves_search import Stretches, extreme, stretches

        first = np.append(True, cells[1:, 0] > cells[:-1, 1])
        runs = np.stack([cells[first, 0], cells[np.append(first[1:], True), 1]], axis=1)
        if len(runs) > RUNS:
            return None
        self.require_bounded(runs[-1, 1])
        breaks = self.breaks(runs[-1, 1])
        found = [stretches(self.values, breaks, low, high, self.work) for low, high in runs.tolist()]
        t, value = extreme(Stretches(*(np.concatenate(part) for part in zip(*found, strict=True))), sense)
        return t, float(value)

    def error(self: "OfWaves", t: float) -> float:
        import numpy as np

        self.waves.require_bounded(self.reads, t, np.array([t]))
        return float(self.waves.errors(self.reads, np.array([t]))[0])

    def final(self) -> float:
        """It is not found."""
        raise _without_limit(self)


class WaveSignal(DispersedSignal):
    """One of a WaveMotion; asked: (the WaveResponse, what was asked of it), empty of a part of a signal."""

    KIND = "a motion that is followed by travelling waves"
    read_at = _read_at

    def __init__(self, waves: "WaveMotion", output: "LinearOutput",
                 asked: tuple[Any, ...] = ()) -> None:
        super().__init__(waves, output)
        self.asked = asked

    def error_of_time(self, t: float) -> float:
        from vibcli.analyses.transient.instant_errors import of_top

        return FRONT * t if _at_front(self, t) else of_top(self.waves, self.reads, t)

    def error_of_zero(self, t: float) -> float:
        from vibcli.analyses.transient.instant_errors import of_passage

        return FRONT * t if _at_front(self, t) else of_passage(self.waves, self.reads, t)

    def final(self) -> float:
        """Its value where all is at rest, if waves that die out have left it so; else it is not found."""
        import numpy as np

        end = self.waves.still_from(self.waves.long_after)
        if not end < np.inf:
            raise _without_limit(self)
        return float(self.values(np.array([2 * end]))[0])

    def error_of_final(self) -> float:
        return self.error(self.waves.long_after)


class ComposedOfWaves(ComposedSignal):
    """A function of WaveSignals, and of steady states perhaps."""

    KIND = "a signal composed of others that waves bring"
    signals: Any
    read_at, sampled, before, leaps, extreme, zeros = _read_at, _sampled, _before, _leaps, _extreme, _zeros
    error_of_time, error_of_zero = _error_of_top, _error_of_zero

    def __init__(self, *composed: Any, asked: tuple[Any, ...] = ()) -> None:
        super().__init__(*composed)
        self.asked = asked

    def fronts(self, end: float) -> "np.ndarray":
        import numpy as np

        return np.unique(np.concatenate([part.fronts(end) for part in self.signals.values()]))

    def breaks(self, end: float) -> "np.ndarray":
        """Those between which it is smooth itself, with what |x|, max(x, y) and the like bend at."""
        import numpy as np

        return np.unique(np.concatenate([self.fronts(end), *(part.zeros(0.0, end) for part in self._turning)]))

    @property
    def _turning(self) -> "list[ComposedOfWaves]":
        """What is zero where a function within it bends."""
        from vibcli.symbolic.expression_graph import reachable

        calls = [node for node in reachable([self.node]) if node.op == "call" and node.name in BENDING]
        return [ComposedOfWaves(node.args[0] - node.args[1] if len(node.args) > 1 else node.args[0], self.signals,
                                self.floats, self.time, None, self.work) for node in calls]

    def require_bounded(self, end: float) -> None:
        for part in self.signals.values():
            part.require_bounded(end)

    def values_before(self, times: "np.ndarray") -> "np.ndarray":
        return self.composed(times, {name: part.values_before(times) for name, part in self.signals.items()})

    def final(self) -> float:
        """It is not found: waves are followed up to an instant."""
        raise _without_limit(self)


if TYPE_CHECKING:
    OfWaves: TypeAlias = "DispersedSignal | BoundlessSignal"
    AtFronts: TypeAlias = "DispersedSignal | BoundlessSignal | ComposedOfWaves"
