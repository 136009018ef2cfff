"""First-order bounds of the errors of functions of signals: Σ |∂f/∂s| δs, by differences, and the rounding of f."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np

    from vibcli.results.signal import Signal
    from vibcli.results.signals import ComposedSignal

ROUNDING = 2.0**-50
STEP = 2.0**-20         # relative, of a difference
WIDE = 2.0**10          # of a difference, in errors
KINKED = 0.4            # of the second difference over twice the step, a quarter of which it is where nothing kinks
SLOW = 2.0**-8          # of the time in which the fastest part turns by a radian


def propagated(function: Callable[..., float], values: Mapping[str, float], errors: Mapping[str, float]) -> float:
    """The error of function(values) where each value is off by its error, and by a rounding."""
    total, here = 0.0, float(function(values))
    for name, off in errors.items():
        x = values[name]
        off += ROUNDING * abs(x)
        step = max(WIDE * off, STEP * abs(x))
        if not off:
            continue
        sides = [float(function({**values, name: x + way * step})) for way in (1, -1)]
        near = [abs(float(function({**values, name: x + way * off})) - here) for way in (1, -1)]
        slope = max(abs(side - here) for side in sides) / step
        total += min(slope * off, 2 * max(near)) if max(near) > 64 * ROUNDING * abs(here) else slope * off
    return total + ROUNDING * abs(here)


def spread(function: "Callable[..., np.ndarray]", values: "Mapping[str, np.ndarray]",
           errors: "Mapping[str, np.ndarray]") -> "np.ndarray":
    """How far function(values) may be off at many instants, where each of its values is off by its error."""
    import numpy as np

    here = function(values)
    found = ROUNDING * np.abs(here)
    for name, off in errors.items():
        sides = [np.abs(function({**values, name: values[name] + way * off}) - here) for way in (1, -1)]
        found = found + np.maximum(*sides)
    return np.where(np.isnan(found), np.inf, found)


def of_value(signal: "ComposedSignal", t: float, errors: "dict[str, float]") -> float:
    """Of a composed signal at an instant, of whose parts each is off by its error."""
    import numpy as np

    at = np.array([t])
    values = {name: float(one.values(at)[0]) for name, one in signal.parts.items()}
    numbers = {name: value for name, value in signal.floats.items() if isinstance(value, float)
               and any(symbol == name for symbol in signal.names)}
    exact = [*numbers, *([signal.time.name] if signal.node.mask & signal.time.mask else [])]
    errors = errors | dict.fromkeys(exact, 0.0)

    def function(known: "Mapping[str, float]") -> float:
        found: float = signal.composed(at, {name: np.array([x]) for name, x in known.items()})[0]
        return found

    return propagated(function, {**values, **numbers, signal.time.name: t}, errors)


def of_instant(signal: "ComposedSignal", t: float, order: int) -> float:
    """Of an instant at which a composed signal passes zero (order 0) or is largest (1), by difference quotients."""
    motions = [one.motion for one in signal.signals.values() if hasattr(one, "motion")]
    rates = [abs(node) for motion in motions for block in motion.blocks for node in block.nodes]
    return at_pace(signal, t, order, max(rates, default=0.0) or 1 / (t or 1.0))


def at_pace(signal: "Signal", t: float, order: int, fastest: float) -> float:
    """The same where the fastest part turns by so many radians in a second."""
    import numpy as np

    step = SLOW / fastest
    at = t + step * np.array([-1.0, -0.5, 0.0, 0.5, 1.0])
    first, before, here, after, last = signal.values(np.maximum(at, 0.0))
    error, slope, bend = signal.error(t), (last - first) / (2 * step), (last - 2 * here + first) / step**2
    if order:
        if abs(slope) > 2 * abs(bend) * step or not bend:
            return ROUNDING * t
        if abs(after - 2 * here + before) > KINKED * abs(last - 2 * here + first):
            found: float = 4 * error / (abs(bend) * step) + ROUNDING * t
            return found
        result: float = 2 * fastest * error / abs(bend) + ROUNDING * t
        return result
    if abs(slope) > abs(bend) * step:
        value: float = 2 * error / abs(slope) + ROUNDING * t
        return value
    return 2 * float(np.sqrt(2 * error / abs(bend))) + ROUNDING * t if bend else t
