"""The time after which a motion that was integrated repeats itself."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.results.full_signals import FullSignal

PERIODIC = 1e-7         # of its range: how nearly a signal repeats itself
SAMPLES, MOST = 64, 60  # instants that are compared, and passages within a period
FIRST = 1.0             # seconds that are looked at first where nothing tells how long
LONGER, LONGEST = 3, 6  # how often the end is doubled: where it is known how long to look, and where it is not


def searched_period(signal: Any, first: float | None) -> tuple[float, float]:
    """(period, how far it may be off) of a signal, looked for up to `first` [s] (None: not known), then for longer and
    longer."""
    end, turns = (first, LONGER) if first is not None else (FIRST, LONGEST)
    for turn in range(turns + 1):
        found = _period(signal, end * 2**turn)
        if found is not None:
            return found
    raise PhysicsError(f"this motion has no one period: it does not repeat itself for 0 ≤ t ≤ {end * 2**turns:.4g} s",
                       "ask for max(x), zero[1](x) or values in time")


def _period(signal: "FullSignal", end: float) -> tuple[float, float] | None:
    """The time between passages through the middle of the range, of a signal that repeats itself after it, and how far
    it may be off."""
    high, low = (signal.extreme(0.0, end, sense)[1] for sense in (1, -1))
    passages = signal.zeros(0.0, end, 0.5 * (high + low)) if high > low else []
    for later in passages[2:MOST:2]:
        period = later - passages[0]
        if passages[0] + 2 * period > end:
            return None
        times = passages[0] + period * np.linspace(0.0, 1.0, SAMPLES)
        if np.abs(signal.values(times + period) - signal.values(times)).max() <= PERIODIC * (high - low):
            return _averaged(signal, passages, passages.index(later), period)
    return None


def _averaged(signal: "FullSignal", passages: Sequence[float], step: int, period: float) -> tuple[float, float]:
    """The mean of the periods that follow one another as passages do, and its error: that of the passages at both ends,
    and what the periods differ by."""
    last = (len(passages) - 1) // step
    mean = (passages[last * step] - passages[0]) / last
    last, found = (last, mean) if abs(mean - period) <= PERIODIC * period else (1, period)
    ends = signal.error_of_time(passages[0]) + signal.error_of_time(passages[last * step])
    return found, ends / last + (abs(mean - period) if last > 1 else 0.0)
