"""Passages through a level, and extremes, of any signal along a trajectory: by the roots of its polynomial per window.

A signal is a function of times, smooth within each window as the motion is. Its Legendre series there comes from its
values at the Gauss points; the roots are those of that series (numerics/legendre_roots.py), of all windows at once.
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.collocation_rule import rule
from vibcli.numerics.legendre_roots import coming_to, numbered_roots, overshoot, roots, sampled, slopes

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.collocation_step import Window
    from vibcli.analyses.time_integration.series_trajectory import SeriesWindow
    from vibcli.analyses.time_integration.trajectory import Trajectory

POINTS = 40
NOTHING = 1e-15         # of the largest coefficient
ALIKE = 4e-15           # of the range of a signal
BESIDE = 1e-5           # of a window
CLEAR = 64              # roundings by which a signal has left a level
TOUCH = 1e-6            # of a window: how far apart the two roots of a touch may be by rounding
JUMP = 1e-9             # of a signal: what is more than the rounding of its series
SAME = 1e-11            # of a window: roots closer than this are one


class SignalWindows(NamedTuple):
    """Of the windows that an interval meets: their starts and lengths [s], as far as the motion is known, and the
    Legendre series of a signal in each, as rows; windows: these themselves."""

    windows: "list[Window | SeriesWindow]"
    starts: np.ndarray
    lengths: np.ndarray
    series: np.ndarray

    def times(self, rows: Any, x: Any) -> np.ndarray:
        """The instants at places in [−1, 1] of windows."""
        found: np.ndarray = self.starts[rows] + 0.5 * (x + 1) * self.lengths[rows]
        return found


def passages(trajectory: "Trajectory", signal: Callable[..., np.ndarray], start: float, end: float,
             level: float = 0.0) -> list[float]:
    """Instants in [start, end] at which a signal passes the level, ascending; a place from which it starts counts."""
    found, parts = [], _parts(trajectory, signal, start, end)
    begins = np.asarray(signal(parts.starts), dtype=float) - level
    places = roots(parts.series - level * np.eye(1, POINTS))
    for k, (window, series, begin, xs) in enumerate(zip(parts.windows, parts.series, begins, places, strict=True)):
        size = np.abs(series).max(initial=0.0)
        if not size:
            continue
        times = parts.times(k, xs).tolist()
        if abs(begin) <= NOTHING * size:
            away = window.start + _away(signal, level, window, size)
            times = [window.start, *(time for time in times if time > away)]
        found += [(time, window.end, size) for time in times if start <= time <= end]
    return _distinct(sorted(found), lambda times: np.asarray(signal(times), dtype=float) - level)


def _distinct(found: Sequence[tuple[float, float, float]], signal: Callable[..., Any]) -> list[float]:
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


def _away(signal: Callable[..., np.ndarray], level: float, window: "Window | SeriesWindow", size: float) -> float:
    """How long after the start of a window a signal that starts at the level is but rounding away from it."""
    sooner = window.end * 2.0 ** np.arange(-60, 1)
    clear = np.abs(np.asarray(signal(window.start + sooner), dtype=float) - level) > CLEAR * NOTHING * size
    return float(sooner[clear.argmax()]) if clear.any() else window.end


def extreme(trajectory: Any, signal: Callable[..., np.ndarray], start: float, end: float, sense: int,
            alike: float = 0.0) -> tuple[float, float]:
    """(instant, value) of the largest (sense 1) or smallest (−1) value in [start, end]; where the signal jumps, the
    limits on both sides count. alike: by how much values may differ that are taken for the same, of which the first
    counts: at the start, or where the signal turns."""
    parts = _parts(trajectory, signal, start, end)
    begins, lasts, (rows, places), spread = _places(parts, start, end, sense, alike)
    turns, lengths, limits = parts.times(rows, places), parts.lengths[rows], parts.series[lasts].sum(axis=1)
    ends = np.minimum(parts.starts[lasts] + parts.lengths[lasts], trajectory.end)
    times = np.sort(np.concatenate([[start, end], parts.starts[begins], ends, turns]))
    times = times[(start <= times) & (times <= end)]
    values, jumps = np.array(signal(times), dtype=float), set()
    at, sizes = np.searchsorted(times[:-1], ends), np.abs(parts.series[lasts]).sum(axis=1)
    for k in np.flatnonzero((times[at] == ends) & (sense * (limits - values[at]) > JUMP * sizes)):
        values[at[k]] = limits[k]
        jumps.add(int(at[k]))
    spread = max(spread, float(np.ptp(values)))
    best = int(np.argmax(sense * values >= max(sense * values) - ALIKE * spread))       # the first of those alike
    if alike:
        turning = np.isin(times, [start, times[best], *turns])
        best = int(np.argmax(turning & (sense * values >= sense * values[best] - alike)))
    beside = turns[(np.abs(turns - times[best]) <= BESIDE * lengths) & (start <= turns) & (turns <= end)]
    if len(beside) and best not in jumps and start < times[best] < end:     # the end of a window next to its turn
        best = int(np.searchsorted(times, beside[np.argmin(np.abs(beside - times[best]))]))
    return float(times[best]), float(values[best])


def _places(parts: SignalWindows, start: float, end: float, sense: int,
            alike: float) -> tuple[np.ndarray, np.ndarray, tuple[np.ndarray, np.ndarray], float]:
    """Where a signal can have its extreme from start to end: (windows at whose start, windows at whose end, (windows in
    which it turns, places of this in each), and its range in the windows within)."""
    series = sense * parts.series
    values = sampled(series)
    highest, lowest = values.max(axis=1), values.min(axis=1)
    middle, reach = 0.5 * (highest + lowest), 0.5 * (highest - lowest)
    most = middle + reach * overshoot(POINTS)
    whole = (start <= parts.times(slice(None), -1)) & (parts.times(slice(None), 1) <= end)
    slack = alike + CLEAR * ALIKE * (most.max() - (middle - reach).min() + np.abs(middle).max())
    level = highest[whole].max(initial=-np.inf) - slack
    able = np.flatnonzero(most >= level)
    rates = slopes(series[able])
    rates[np.abs(rates).max(axis=1) <= NOTHING * np.abs(series[able]).max(axis=1)] = 0.0
    rows, places = numbered_roots(rates, coming_to(level, series[able], values[able]))
    spread = highest[whole].max(initial=-np.inf) - lowest[whole].min(initial=np.inf)
    at_start, at_end = (np.flatnonzero(values[:, k] >= level - slack) for k in (0, -1))
    return at_start, at_end, (able[rows], places), float(spread)


def _parts(trajectory: "Trajectory", signal: Callable[..., np.ndarray], start: float, end: float) -> SignalWindows:
    """The SignalWindows that [start, end] meets."""
    gauss = rule(POINTS)
    windows = [window for window in trajectory.windows if window.start <= min(end, trajectory.end)
               and window.start + window.end >= start]
    starts = np.array([window.start for window in windows])
    lengths = np.minimum([window.end for window in windows], trajectory.end - starts)
    times = starts[:, None] + gauss.c * lengths[:, None]
    values = np.asarray(signal(times.ravel()), dtype=float).reshape(times.shape)
    return SignalWindows(windows, starts, lengths, values @ gauss.to_series)
