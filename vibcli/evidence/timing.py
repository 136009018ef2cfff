"""Methods timed by turns after a warm-up, in processor time, each answer beside the true one."""

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from statistics import quantiles
from time import process_time
from typing import Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject, TimeIsOver

RUNS, FEW, SLOW = 7, 3, 0.5     # of each; of those whose one run takes longer [s]
STOP, TIMES = 5.0, 100.0        # s, and times ours, after which a method is stopped
LEAST, SHORT = 1e-3, 0.02       # s of one measurement, which repeats what is shorter; of runs that are never spared
LONGER = 1.5                    # times that the next setting of a method takes at least
STOPPED, SPENT = "stopped", "left out: too long"


class Point(NamedTuple):
    """One attempt. seconds: (lower quartile, median, upper quartile) of its runs, the one of a run that was ended;
    error: relative, no less than the true value leaves open, None where it has no answer; bound: what it states; why:
    it has none."""

    method: str
    setting: str
    seconds: tuple[float, ...]
    runs: int
    error: float | None
    bound: float | None
    why: str = ""


def measured(subject: Subject, attempts: Sequence[MethodRun], runs: int = RUNS,
             patience: float = math.inf) -> list[Point]:
    """A Point of each attempt, the first of which is ours. After one that was stopped the later ones of its method are
    left out: their settings take longer; so are those for which no time is left, of `patience` s for all runs."""
    tried: list[Any] = []
    over, last, left = set(), {}, patience / 2
    for attempt in _in_turns(attempts):
        method = attempt.method
        if method in over:
            continue
        before, growth = last.get(method, (0.0, LONGER))
        if tried and before * growth > left:
            over.add(method)
            tried.append((attempt, before, None, SPENT))
            continue
        one = _tried(attempt, max(STOP, TIMES * tried[0][1]) if tried else STOP)
        tried.append(one)
        last[method], left = (one[1], max(LONGER, one[1] / before) if before else LONGER), left - one[1]
        if one[3] == STOPPED:
            over.add(method)
    spent = _by_turns(tried, runs, left + patience / 2)
    points = [_point(subject, *one, times) for one, times in zip(tried, spent, strict=True)]
    order = list(dict.fromkeys(point.method for point in points))
    return sorted(points, key=lambda point: order.index(point.method))


def measured_in_shares(asked: Iterable[tuple[Subject, Sequence[MethodRun]]], runs: int, whole: float
                       ) -> Iterator[list[Point]]:
    """The Points of each of several, of which each has an equal share of what those before left of `whole` s."""
    several = list(asked)
    for place, (subject, attempts) in enumerate(several):
        start = process_time()
        yield measured(subject, attempts, runs, whole / (len(several) - place))
        whole -= process_time() - start


def _in_turns(attempts: Sequence[MethodRun]) -> list[MethodRun]:
    """The first settings of all methods, their second ones …: no method takes the time of the others."""
    ranks, turns = Counter(), []
    for attempt in attempts:
        turns.append((ranks[attempt.method], attempt))
        ranks[attempt.method] += 1
    return [attempt for _, attempt in sorted(turns, key=lambda turn: turn[0])]


def _tried(attempt: MethodRun, allowed: float) -> tuple[MethodRun, float, MethodAnswer | None, str]:
    """(attempt, seconds, MethodAnswer or None, why there is none) of the warm-up."""
    found, why, start = None, "", process_time()
    try:
        found = attempt.run(Deadline(allowed))
    except Exception as error:      # whatever a library has to say of an input that it does not bear
        why = reason(error)
    return attempt, process_time() - start, found, why


def reason(error: Exception) -> str:
    """Why a method has no answer."""
    if isinstance(error, TimeIsOver):
        return STOPPED
    return error.message if isinstance(error, PhysicsError) else f"{type(error).__name__}: {error}"


def _by_turns(tried: Sequence[tuple[MethodRun, float, MethodAnswer | None, str]], runs: int,
              patience: float) -> list[list[float]]:
    """[seconds of each run] of each attempt; where all together take too long, those of the dearest are fewer."""
    counts = [0 if why else runs if spent <= SLOW else min(runs, FEW) for _, spent, _, why in tried]
    costs = [count * max(spent, LEAST) for count, (_, spent, _, _) in zip(counts, tried, strict=True)]
    for i in sorted(range(1, len(costs)), key=lambda i: -costs[i]):
        if sum(costs) > patience and tried[i][1] > SHORT:
            costs[i], counts[i] = 0.0, 0        # its warm-up stands for it
    times: list[list[float]] = [[] for _ in tried]
    for turn in range(max(counts, default=0)):
        for (attempt, spent, _, _), count, kept in zip(tried, counts, times, strict=True):
            if turn < count:
                kept.append(_timed(attempt, max(1, math.ceil(LEAST / max(spent, 1e-6)))))
    return times


def _timed(attempt: MethodRun, repeats: int) -> float:
    free = Deadline(math.inf)
    start = process_time()
    for _ in range(repeats):
        attempt.run(free)
    return (process_time() - start) / repeats


def _point(subject: Subject, attempt: MethodRun, spent: float, found: MethodAnswer | None, why: str,
           times: list[float]) -> Point:
    if found is None:
        return Point(attempt.method, attempt.setting, (spent,) * 3, 0, None, None, why)
    times = times or [spent]
    several = len(times) > 1
    quartiles = (*quantiles(times, n=4, method="inclusive"),) if several else (times[0],) * 3
    error = max(subject.error(found.values, subject.true), 10.0**-subject.true.digits)
    if not math.isfinite(error):
        return Point(attempt.method, attempt.setting, quartiles, len(times), None, None,
                     f"{len(found.values)} values, of which there are {len(subject.true.values)}")
    return Point(attempt.method, attempt.setting, quartiles, len(times), error, found.bound)
