"""Passages through a level, and extremes, of any signal along a trajectory: by the roots of its polynomial per window.

A signal is a function of times, smooth within each window as the motion is. Its Legendre series there comes from its
values at the Gauss points; the roots are those of that series (numerics/legendre_roots.py), of all windows at once.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.polynomial import legendre

from vibcli.numerics.collocation_rule import rule
from vibcli.numerics.legendre_roots import overshoot, roots, sampled

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.trajectory import Trajectory

POINTS = 40
NOTHING = 1e-15         # of the largest coefficient
ALIKE = 4e-15           # of the range of a signal
BESIDE = 1e-5           # of a window
CLEAR = 64              # roundings by which a signal has left a level
TOUCH = 1e-6            # of a window: how far apart the two roots of a touch may be by rounding
JUMP = 1e-9             # of a signal: what is more than the rounding of its series
SAME = 1e-11            # of a window: roots closer than this are one


def passages(trajectory: "Trajectory", signal: Callable, start: float, end: float, level: float = 0.0) -> list[float]:
    """Instants in [start, end] at which a signal passes the level, ascending; a place from which it starts counts."""
    found, parts = [], list(_series(trajectory, signal, start, end))
    begins = np.asarray(signal(np.array([window.start for window, _, _ in parts])), dtype=float) - level
    places = roots(np.array([series for *_, series in parts]) - level * np.eye(1, POINTS))
    for (window, t, series), begin, xs in zip(parts, begins, places, strict=True):
        size = np.abs(series).max(initial=0.0)
        if not size:
            continue
        times = [float(t(x)) for x in xs]
        if abs(begin) <= NOTHING * size:
            away = window.start + _away(signal, level, window, size)
            times = [window.start, *(time for time in times if time > away)]
        found += [(time, window.end, size) for time in times if start <= time <= end]
    return _distinct(sorted(found), lambda times: np.asarray(signal(times), dtype=float) - level)


def _distinct(found, signal):
    """The times of [(time, length of its window, size of the signal there)], those once between which the signal is
    but rounding away from the level: it touches the level there."""
    if not found:
        return []
    times, lengths, sizes = np.array(found).T
    gaps, middles = np.diff(times), 0.5 * (times[1:] + times[:-1])
    same = gaps <= SAME * lengths[1:] + 4e-16 * times[1:]
    near = ~same & (gaps <= TOUCH * lengths[1:])
    touch = near & (np.abs(signal(middles)) <= CLEAR * NOTHING * sizes[1:]) if near.any() else near
    kept = []
    for k, time in enumerate(times):
        if k and touch[k - 1]:
            kept[-1] = float(middles[k - 1])
        elif not k or not same[k - 1]:
            kept.append(float(time))
    return kept


def _away(signal, level, window, size):
    """How long after the start of a window a signal that starts at the level is but rounding away from it."""
    sooner = window.end * 2.0 ** np.arange(-60, 1)
    clear = np.abs(np.asarray(signal(window.start + sooner), dtype=float) - level) > CLEAR * NOTHING * size
    return float(sooner[clear.argmax()]) if clear.any() else window.end


def extreme(trajectory: Any, signal: Callable, start: float, end: float, sense: int,
            alike: float = 0.0) -> tuple[float, float]:
    """(instant, value) of the largest (sense 1) or smallest (−1) value in [start, end]; where the signal jumps, the
    limits on both sides count. alike: by how much values may differ that are taken for the same, of which the first
    counts: at the start, or where the signal turns."""
    candidates, before, parts = [start, end], {}, list(_series(trajectory, signal, start, end))
    for window, _, series in parts:
        last = min(window.start + window.end, trajectory.end)
        candidates += [window.start, last]
        before[float(last)] = float(series.sum()), float(np.abs(series).sum())
    turns = _turns(parts, start, end, sense, alike)
    times = np.array(sorted({float(time) for time in [*candidates, *(turn for turn, _ in turns)]
                             if start <= time <= end}))
    values, jumps = np.array(signal(times), dtype=float), set()
    for i, time in enumerate(times):
        limit, size = before.get(float(time), (values[i], 0.0))
        if abs(limit - values[i]) > JUMP * size and sense * limit > sense * values[i]:
            values[i] = limit
            jumps.add(i)
    best = int(np.argmax(sense * values >= max(sense * values) - ALIKE * np.ptp(values)))    # the first of those alike
    if alike:
        turning = np.isin(times, [start, times[best], *(turn for turn, _ in turns)])
        best = int(np.argmax(turning & (sense * values >= sense * values[best] - alike)))
    beside = [turn for turn, length in turns if abs(turn - times[best]) <= BESIDE * length and start <= turn <= end]
    if beside and best not in jumps and start < times[best] < end:      # the end of a window next to its turn
        best = int(np.searchsorted(times, min(beside, key=lambda turn: abs(turn - times[best]))))
    return float(times[best]), float(values[best])


def _turns(parts, start, end, sense, alike):
    """[(instant, length of its window)] at which a signal turns, in the windows that can hold its extreme from start to
    end."""
    series = np.array([one for _, _, one in parts])
    values = sense * sampled(series)
    middle, reach = 0.5 * (values.max(axis=1) + values.min(axis=1)), 0.5 * np.ptp(values, axis=1)
    highest = middle + reach * overshoot(POINTS)
    whole = [start <= float(t(-1)) and float(t(1)) <= end for _, t, _ in parts]
    slack = alike + CLEAR * ALIKE * (highest.max() - (middle - reach).min() + np.abs(middle).max())
    able = np.flatnonzero(highest >= values[whole].max(initial=-np.inf) - slack)
    slopes = legendre.legder(series[able], axis=1)
    slopes[np.abs(slopes).max(axis=1) <= NOTHING * np.abs(series[able]).max(axis=1)] = 0.0
    return [(float(parts[k][1](x)), parts[k][0].length) for k, xs in zip(able, roots(slopes), strict=True) for x in xs]


def _series(trajectory, signal, start, end):
    """(window, map of [−1, 1] to its times, Legendre series of the signal on it) of the windows that [start, end]
    meets."""
    gauss = rule(POINTS)
    windows = [window for window in trajectory.windows if window.start <= min(end, trajectory.end)
               and window.start + window.end >= start]
    lengths = [min(window.end, trajectory.end - window.start) for window in windows]
    times = np.concatenate([window.start + gauss.c * length for window, length in zip(windows, lengths, strict=True)])
    values = np.asarray(signal(times), dtype=float).reshape(len(windows), POINTS)
    for window, length, row in zip(windows, lengths, values @ gauss.to_series, strict=True):
        yield window, (lambda x, window=window, length=length: window.start + 0.5 * (x + 1) * length), row
