"""Values, extremes and their instants along a motion in Taylor series, of an expression of its coordinates."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.taylor_steps import TaylorSteps
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node

SAMPLES = 12            # of a step
NEAR = 1e-6             # of the range of values: maxima so near to the largest are looked at
HALVINGS, SECANTS = 12, 60


class SignalAlongSteps(NamedTuple):
    """A signal along a motion: its expression and that of its rate, of the coordinates that are called `names` (with
    primes), of the time and of parameters; values(bits): {parameter: number}."""

    node: "Node"
    rate: "Node"
    names: Sequence[str]
    time: str
    values: Callable[[int], Mapping[str, Any]]

    def along(self, steps: TaylorSteps, which: "Sequence[Node]", t: int) -> list[Any]:
        """The values of expressions at an instant in fixed point."""
        known = {**self.values(steps.bits), self.time: steps.time(t)}
        for primes, row in zip(("", "'", "''"), steps.at(t), strict=True):
            known |= {name + primes: x for name, x in zip(self.names, row, strict=True)}
        with mpmath.workprec(2 * steps.bits):
            return evaluate(list(which), multiprecision(), known)


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


def _sampled(signal, steps):
    """[(instant, value)] at all ends of steps, and between them."""
    times = [step.start + (step.end - step.start) * k // SAMPLES for step in steps.steps for k in range(SAMPLES)]
    times.append(steps.steps[-1].end)
    return [(t, signal.along(steps, [signal.node], t)[0]) for t in times]


def _top(signal, steps, ends, t, sense):
    """The instant between two at which the rate passes through zero: by halves, then by secants; where it does not, as
    at a corner or an end, the one that is given."""
    def rate(at):
        return sense * signal.along(steps, [signal.rate], at)[0]

    low, high = ends
    below, above = rate(low), rate(high)
    if not (below > 0 > above):
        return t
    for _ in range(HALVINGS):
        middle = (low + high) // 2
        x = rate(middle)
        low, below, high, above = (middle, x, high, above) if x > 0 else (low, below, middle, x)
    kept = 0                            # the end that stayed last: once more, and it counts half (Illinois)
    for _ in range(SECANTS):
        with mpmath.workprec(2 * steps.bits):
            place = low + int((high - low) * (below / (below - above)))
        x = rate(place)
        if not x or min(place - low, high - place) <= 1 << steps.bits - steps.accuracy:
            return place
        if x > 0:
            low, below, above, kept = place, x, above / 2 if kept == 1 else above, 1
        else:
            high, above, below, kept = place, x, below / 2 if kept == -1 else below, -1
    return place
