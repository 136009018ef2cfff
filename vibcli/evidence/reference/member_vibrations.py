"""Values and extremes of beams in time, and of what is joined with them, by the poles of Laplace images: of more and
more of them until enough digits stay, or as many as stay with all that are worth their time."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.member_pole_sums import DIGITS, signal_in_poles
from vibcli.evidence.reference.rated_members import RatedSignal
from vibcli.evidence.reference.settled import LOST, DoesNotSettle, TrueValues

if TYPE_CHECKING:
    from vibcli.evidence.reference.member_pole_sums import SignalInPoles
    from vibcli.results.problem import Problem

ENOUGH, LEAST = 24, 15      # digits that stay
TAKEN = (1, 2), (3, 4), (7, 8)      # parts of the poles beside all of them
SHOWN, FINE, FEW = 1e-9, 24, 1e-3   # residues that samples show, samples to a period of those that are no less
SAMPLES = 200_000
ALIKE, MOST = 1e-6, 8       # of the largest: tops of samples among which the highest is looked for, and how many
STEPS = 60


def at_instant(problem: "Problem", signal: str, t: Callable[[], Any]) -> TrueValues:
    """The value of a signal at t(), an instant; about: its largest size until then."""
    with mpmath.workdps(DIGITS):
        instant = t()
        along = _along(problem, signal, max(instant, mpmath.mpf(problem.response.until)))
        if not instant:
            value = along.members.at_first()
            return TrueValues([value], DIGITS // 2, DIGITS, DIGITS // 2, abs(value) or mpmath.mpf(1))
        size = max(abs(y) for _, y in _sampled(along))
        return _settled(along, instant, lambda count: along.at(instant, count=count), size)


def extremes(problem: "Problem", signal: str, until: float, sense: int, instant: bool) -> TrueValues:
    """The largest or smallest value of a signal until an instant, or where it has it; about: its largest size, or
    `until`."""
    with mpmath.workdps(DIGITS):
        along = _along(problem, signal, mpmath.mpf(until))
        samples = _sampled(along)
        size = max(abs(y) for _, y in samples)
        tops = _highest(along, samples, sense, size)
        size = along.until if instant else size
        return _settled(along, tops[0][0], lambda count: _top(along, tops, sense, count)[0 if instant else 1], size)


def _along(problem: "Problem", signal: str, until: mpmath.mpf) -> Any:
    try:
        if problem.spec.get("damping") is None:
            return signal_in_poles(problem, signal, until)
        return RatedSignal(problem, signal, until)
    except (*LOST, np.linalg.LinAlgError) as error:
        raise DoesNotSettle("the reference does not settle: the poles of these members are not found",
                            "leave this quantity out of the comparison") from error


def _settled(along: Any, t: Any, found: Callable[[int | None], Any], size: Any) -> TrueValues:
    """What all poles give, with as many digits as parts of them give, too."""
    while True:
        count, value = len(along.sources[0].p), found(None)
        rounded, cut = along.left(t), max(abs(found(count * p // q) - value) for p, q in TAKEN)
        left = rounded + cut
        digits = DIGITS // 2 if not left else min(int(-mpmath.log10(left / size)), DIGITS // 2)
        if digits >= ENOUGH or cut <= rounded or along.many:
            break
        along.doubled()
    if digits < LEAST:
        raise DoesNotSettle(f"the reference does not settle: {LEAST} digits of it are not found by {count} poles",
                            "leave this quantity out of the comparison")
    return TrueValues([value], digits, DIGITS, DIGITS, size)


def _sampled(along: "RatedSignal | SignalInPoles") -> list[tuple[float, float]]:
    """[(t, y)] in floats, from before to after every instant at which something begins."""
    terms = []
    for part in along.sources:
        p = np.array([*(complex(x) for x, _ in part.few), *part.p], complex)
        c = np.array([*(complex(x) for _, x in part.few), *part.c], complex)
        terms.append((float(part.start), p, c))
    largest = max(float(np.abs(part.c).max(initial=0.0)) for part in along.sources)
    largest = max([largest, *(float(abs(x)) for part in along.sources for _, x in part.few)])
    fast = max((float(np.abs(p[np.abs(c) > FEW * largest].imag).max(initial=0.0)) for _, p, c in terms), default=0.0)
    until = float(along.until)
    count = int(FINE * fast * until / (2 * np.pi)) + 200
    if count > SAMPLES:
        raise PhysicsError(f"the reference takes too long: {count} samples of this motion, of up to {SAMPLES}")
    times = np.union1d(np.linspace(0.0, until, count + 1), [start for start, _, _ in terms if start < until])
    values = np.full(len(times), float(along.held))
    for start, p, c in terms:
        shown = np.abs(c) > SHOWN * largest
        here = times > start
        for pole, weight in zip(p[shown], c[shown], strict=True):
            values[here] += 2 * (weight * np.exp(pole * (times[here] - start))).real
    values[0] = float(along.members.at_first())
    return list(zip(times.tolist(), values.tolist(), strict=True))


def _highest(along: "SignalInPoles", samples: Sequence[tuple[float, float]], sense: int,
             size: float) -> list[tuple[mpmath.mpf, mpmath.mpf, mpmath.mpf]]:
    """[(an end before, the sample, an end after)] of the highest tops of samples, (t, t, t) of one that is an end."""
    t, y = np.array([time for time, _ in samples]), sense * np.array([value for _, value in samples])
    found = [(y[i], (t[i],) * 3) for i in (0, len(y) - 1)]
    for i in range(1, len(y) - 1):
        if y[i - 1] <= y[i] >= y[i + 1]:
            bend = y[i - 1] - 2 * y[i] + y[i + 1]
            found.append((y[i] - ((y[i + 1] - y[i - 1]) ** 2 / (8 * bend) if bend else 0), (t[i - 1], t[i], t[i + 1])))
    best = max(top for top, _ in found)
    near = [place for top, place in found if top >= best - ALIKE * float(size)]
    if len(near) > MOST:
        raise PhysicsError("no reference is found of the highest of very many tops that are nearly alike")
    return [tuple(map(mpmath.mpf, place)) for place in near]


def _top(along: "SignalInPoles", tops: Sequence[tuple[mpmath.mpf, mpmath.mpf, mpmath.mpf]], sense: int,
         count: int) -> tuple[mpmath.mpf, mpmath.mpf]:
    """(t, y) of the highest of tops, the first of those that are alike."""
    turns = [_turn(along, place, count) for place in tops]
    found = [(t, along.at(t, count=count) if t else along.members.at_first()) for t in turns]
    best = max(sense * y for _, y in found)
    return min((t, y) for t, y in found if sense * y >= best - mpmath.mpf(10) ** -ENOUGH * abs(best))


def _turn(along: "SignalInPoles", near: tuple[mpmath.mpf, mpmath.mpf, mpmath.mpf], count: int) -> mpmath.mpf:
    """Where the rate is zero between two instants; the instant itself where they are one."""
    low, middle, high = near
    if low == high:
        return middle
    rates = [along.at(t, 1, count) for t in (low, high)]
    if rates[0] * rates[1] >= 0:
        raise DoesNotSettle("the reference does not settle: no turn of this motion is found between samples")
    return mpmath.findroot(lambda t: along.at(t, 1, count), (low, high), solver="anderson", verify=False,
                           tol=mpmath.mpf(10) ** -(DIGITS - 10), maxsteps=STEPS)
