"""Where a function that is smooth between known instants is largest, smallest or zero: there it is Chebyshev series."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.travelling_waves_curves import SAME, series_of
from vibcli.analyses.continuous.travelling_waves_fields import is_resolved
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.chebyshev import POINTS, WIDTH, N, passages, summed, turning_points

if TYPE_CHECKING:
    from vibcli.base.work import Work

EQUAL = 1e-14       # of the largest value: what is as large
MOST, HALVED = 20_000, 40       # stretches, how often each is halved
LATE = 8            # part of t·ẏ: a value off by the rounding of its instant is as resolved as one so large


class Stretches(NamedTuple):
    """A function stretch by stretch: its series from each of `starts` on, for `lengths`."""

    starts: np.ndarray
    lengths: np.ndarray
    series: np.ndarray


def stretches(values: Callable[..., np.ndarray], breaks: np.ndarray, start: float, end: float,
              work: "Work") -> Stretches:
    """The Stretches of values(times) from start to end, smooth between the instants `breaks`; work: counts them."""
    inside = breaks[(breaks > start + SAME * end) & (breaks < end * (1 - SAME))]
    starts = np.concatenate([[start], inside])
    starts = starts[np.append(True, np.diff(starts) > SAME * end)]
    lengths, parts = np.diff(np.append(starts, end)), []
    with work.task("the search along the waves", MOST) as task:
        for _ in range(HALVED):
            task.step(steps=len(starts))
            times = starts[:, None] + lengths[:, None] / 2 * (1 + POINTS)
            reached = values(times.ravel()).reshape(-1, N)
            series = series_of(reached)
            rounded = (starts + lengths) * np.ptp(reached, axis=1) / (LATE * lengths)
            scales = np.maximum(np.abs(series).max(initial=0.0), rounded)
            held = np.array([is_resolved(row[:N], scale) for row, scale in zip(series, scales, strict=True)])
            held |= lengths <= SAME * end
            parts.append(Stretches(starts[held], lengths[held], series[held]))
            starts, lengths = np.repeat(starts[~held], 2), np.repeat(lengths[~held] / 2, 2)
            starts[1::2] += lengths[1::2]
            if not len(starts):
                break
    found = Stretches(*(np.concatenate(part) for part in zip(*parts, strict=True)))
    order = np.argsort(found.starts)
    return Stretches(*(part[order] for part in found))


def extreme(parts: Stretches, sense: int, off: float = 0.0) -> tuple[float, float]:
    """(t, value) of the largest (sense 1) or smallest (−1) value, the earliest of equals but for errors `off`; at a
    front both its values count."""
    series = sense * parts.series
    ends = [(series * signs).sum(axis=1) for signs in ((-1.0) ** np.arange(WIDTH), np.ones(WIDTH))]
    rounding = max(EQUAL * np.abs(series).sum(axis=1).max(), 2 * off)
    best, found = max(values.max() for values in ends), []
    most = series[:, 0] + np.abs(series[:, 1:]).sum(axis=1)
    for k in np.argsort(-most):
        if most[k] < best - rounding:
            break
        for x in (-1.0, *turning_points(series[k]), 1.0):
            value = float(summed(series[k], np.array([x]))[0])
            found.append((float(parts.starts[k] + parts.lengths[k] * (1 + x) / 2), value))
            best = max(best, value)
    return min(t for t, value in found if value >= best - rounding), sense * best


def zeros(parts: Stretches, end: float, off: float = 0.0) -> np.ndarray:
    """All times where the function passes, touches or leaps over zero, ascending; where it rests at zero but for errors
    `off`, none, but the instant at which it leaves it, by a leap too."""
    times: list[float] = []
    before, rests = 0.0, None
    for begin, length, series in zip(*parts, strict=True):
        if np.abs(series).sum() <= off:
            before, rests = 0.0, begin if rests is None else rests
            continue
        left = float(summed(series, np.array([-1.0]))[0])
        if rests is not None and times and times[-1] >= rests - SAME * end:
            times.pop()
        if before * left < 0 or rests is not None:
            times.append(float(begin))
        rests = None
        if np.abs(series[1:]).sum() >= abs(series[0]):
            times += [float(begin + length * (1 + x) / 2) for x in passages(series)]
        before = float(series.sum())
    kept: list[float] = []
    for t in sorted(times):
        if not kept or t - kept[-1] > SAME * end:
            kept.append(t)
    return np.array(kept)
