"""Values, extremes and their instants along a motion in Taylor series, of an expression of its coordinates."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.taylor_steps import TaylorSteps
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

SAMPLES = 12            # of a step
NEAR = 1e-6             # of the range of values: maxima so near to the largest are looked at
TOUCH = 1e-3            # of the largest value: extremes so near to zero may touch it
HALVINGS, SECANTS = 12, 60


class SignalAlongSteps(NamedTuple):
    """A signal along a motion: its expression and that of its rate, of the coordinates that are called `names` (with
    primes), of the time and of parameters; values(bits): {parameter: number}; jerked: does its rate hold third rates of
    coordinates?"""

    node: "Node"
    rate: "Node"
    names: Sequence[str]
    time: str
    values: Callable[[int], Mapping[str, Any]]
    jerked: bool = False

    def along(self, steps: TaylorSteps, which: "Sequence[Node]", t: int) -> list[Any]:
        """The values of expressions at an instant in fixed point."""
        known = {**self.values(steps.bits), self.time: steps.time(t)}
        for primes, row in zip(("", "'", "''"), steps.at(t), strict=True):
            known |= {name + primes: x for name, x in zip(self.names, row, strict=True)}
        if self.jerked:
            known |= {name + "'''": x for name, x in zip(self.names, steps.jerks(t), strict=True)}
        with mpmath.workprec(2 * steps.bits):
            return evaluate(list(steps.forms(which, t)), multiprecision(), known)


def value(signal: SignalAlongSteps, steps: TaylorSteps, time: Fraction) -> tuple[Any, Any]:
    """(the value at an instant, the largest magnitude until then)."""
    sampled = [abs(x) for _, x in _sampled(signal, steps)]
    found, = signal.along(steps, [signal.node], steps.fixed(time))
    return found, max([*sampled, abs(found)])


def extreme(signal: SignalAlongSteps, steps: TaylorSteps, sense: int) -> tuple[Any, Any, Any]:
    """(instant, value) of the largest (sense 1) or smallest value (−1), and the largest magnitude."""
    sampled = _sampled(signal, steps)
    best = max(sense * x for _, x in sampled)
    margin = NEAR * (best - min(sense * x for _, x in sampled))
    found = []
    for i, (t, x) in enumerate(sampled):
        low, high = sampled[max(i - 1, 0)], sampled[min(i + 1, len(sampled) - 1)]
        bulge = abs(2 * x - low[1] - high[1])
        if sense * x >= max(sense * low[1], sense * high[1]) and sense * x + bulge >= best - margin:
            top = _top(signal, steps, (low[0], high[0]), t, sense)
            found.append((top, signal.along(steps, [signal.node], top)[0]))
    largest, size = max((x for _, x in found), key=lambda x: sense * x), max(abs(x) for _, x in sampled)
    with mpmath.workprec(2 * steps.bits):       # of several that are alike the first
        top = next(t for t, x in found if abs(x - largest) <= mpmath.ldexp(size, -steps.accuracy // 2))
    return steps.time(top), largest, size


def _sampled(signal: SignalAlongSteps, steps: TaylorSteps) -> list[tuple[int, mpmath.mpf]]:
    """[(instant, value)] at all ends of steps, and between them; where it may jump, just before, too."""
    times = {step.start + (step.end - step.start) * k // SAMPLES for step in steps.steps for k in range(SAMPLES)}
    times |= {steps.steps[-1].end, *(t - 1 for t in steps.breaks if t)}
    return [(t, signal.along(steps, [signal.node], t)[0]) for t in sorted(times)]


def zeros(signal: SignalAlongSteps, steps: TaylorSteps, number: int) -> list[Any]:
    """The instants of so many zeros, that of a start there among them; PhysicsError where there are fewer, or where the
    signal may touch zero between samples."""
    sampled = _sampled(signal, steps)
    size = max(abs(x) for _, x in sampled)
    small = mpmath.ldexp(size, -steps.accuracy // 2)
    sampled = [(t, x if abs(x) > small else 0) for t, x in sampled]
    found = [] if sampled[0][1] else [sampled[0][0]]
    for before, (t, x), after in zip([None, *sampled], sampled, [*sampled[1:], None], strict=False):
        if after is None or len(found) == number:
            break
        if x and not after[1]:          # there where a step ends, from where on it may stay
            found.append(after[0])
        elif x * after[1] < 0:
            found.append(_zero(signal, steps, (t, after[0]), 1 if x > after[1] else -1))
        elif x and before and before[1] * x > 0 and abs(x) <= min(TOUCH * size, abs(before[1]), abs(after[1])):
            raise PhysicsError("no reference is found of where a signal may touch zero")
    if len(found) < number:
        raise PhysicsError(f"the reference finds {len(found)} zeros")
    return [steps.time(t) for t in found[:number]]


def _zero(signal: SignalAlongSteps, steps: TaylorSteps, ends: tuple[int, int], sense: int) -> int:
    """The instant between two at which a signal falls (sense 1) or rises through zero."""
    return passage(lambda at: sense * signal.along(steps, [signal.node], at)[0], ends, steps)


def _top(signal: SignalAlongSteps, steps: TaylorSteps, ends: tuple[int, int], t: int, sense: int) -> int:
    """The instant between two at which the rate passes through zero; where it does not, as at a corner or an end, the
    one that is given."""
    def rate(at: int) -> mpmath.mpf:
        return sense * signal.along(steps, [signal.rate], at)[0]

    if not (rate(ends[0]) > 0 > rate(ends[1])):
        return t
    return passage(rate, ends, steps)


def passage(function: Callable[[int], Any], ends: tuple[int, int], steps: TaylorSteps) -> int:
    """The instant between two at which a function falls through zero: by halves, then by secants."""
    low, high = ends
    below, above = function(low), function(high)
    for _ in range(HALVINGS):
        middle = (low + high) // 2
        x = function(middle)
        low, below, high, above = (middle, x, high, above) if x > 0 else (low, below, middle, x)
    kept = 0                            # the end that stayed last: once more, and it counts half (Illinois)
    for _ in range(SECANTS):
        with mpmath.workprec(2 * steps.bits):
            place = low + int((high - low) * (below / (below - above)))
        x = function(place)
        if not x or min(place - low, high - place) <= 1 << steps.bits - steps.accuracy:
            return place
        if x > 0:
            low, below, above, kept = place, x, above / 2 if kept == 1 else above, 1
        else:
            high, above, below, kept = place, x, below / 2 if kept == -1 else below, -1
    return place
