"""Where an output of travelling waves is largest, smallest or zero: on each stretch between fronts it is one series."""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from vibcli.analyses.continuous.travelling_waves_curves import SAME, series_of
from vibcli.numerics.chebyshev import POINTS, WIDTH, N, passages, summed, turning_points

if TYPE_CHECKING:
    from vibcli.analyses.continuous.travelling_waves import WaveMotion, WaveOutput

EQUAL = 1e-14       # of the largest value: what is as large


class Stretches(NamedTuple):
    """An output from `start` to `end`: its series from each of `starts` on, for `lengths`."""

    starts: np.ndarray
    lengths: np.ndarray
    series: np.ndarray


def stretches(motion: "WaveMotion", output: "WaveOutput", start: float, end: float, order: int = 0) -> Stretches:
    """The output, or a rate of it, stretch by stretch."""
    breaks = motion.breaks(output, end)
    inside = breaks[(breaks > start + SAME * end) & (breaks < end * (1 - SAME))]
    starts = np.concatenate([[start], inside])
    lengths = np.diff(np.append(starts, end))
    held = np.append(True, lengths[1:] > SAME * end)
    starts = starts[held]
    lengths = np.diff(np.append(starts, end))
    times = starts[:, None] + lengths[:, None] / 2 * (1 + POINTS)
    return Stretches(starts, lengths, series_of(motion.values(output, times.ravel(), order).reshape(-1, N)))


def extreme(motion: "WaveMotion", output: "WaveOutput", start: float, end: float, sense: int) -> tuple[float, float]:
    """(t, value) of the largest (sense 1) or smallest (−1) value, the earliest of equals; at a front both its values
    count."""
    parts = stretches(motion, output, start, end)
    series = sense * parts.series
    ends = [(series * signs).sum(axis=1) for signs in ((-1.0) ** np.arange(WIDTH), np.ones(WIDTH))]
    scale = np.abs(series).sum(axis=1)
    best = max(found.max() for found in ends)
    found = []
    most = series[:, 0] + np.abs(series[:, 1:]).sum(axis=1)
    for k in np.argsort(-most):
        if most[k] < best - EQUAL * scale.max():
            break
        for x in (-1.0, *turning_points(series[k]), 1.0):
            value = float(summed(series[k], np.array([x]))[0])
            found.append((float(parts.starts[k] + parts.lengths[k] * (1 + x) / 2), value))
            best = max(best, value)
    t, value = min(item for item in found if item[1] >= best - EQUAL * scale.max())
    return t, sense * value


def zeros(motion: "WaveMotion", output: "WaveOutput", start: float, end: float) -> np.ndarray:
    """All times where the output passes, touches or leaps over zero, ascending; where it rests at zero, none, but the
    instant at which it leaves it."""
    parts, found, before = stretches(motion, output, start, end), [], None
    for begin, length, series in zip(*parts, strict=True):
        left, right = float(summed(series, np.array([-1.0]))[0]), float(series.sum())
        if before is not None and before * left < 0:
            found.append(float(begin))
        if np.abs(series[1:]).sum() >= abs(series[0]):
            found += [float(begin + length * (1 + x) / 2) for x in passages(series)]
        before = right
    times, kept = sorted(found), []
    for t in times:
        if not kept or t - kept[-1] > SAME * end:
            kept.append(t)
    return np.array(kept)
