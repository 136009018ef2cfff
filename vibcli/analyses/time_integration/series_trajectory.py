"""A motion that was followed by series, in floats: each correct to its rounding, however long the motion is."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.fixed_point import to_float

if TYPE_CHECKING:
    from vibcli.analyses.time_integration.taylor_march import TaylorMarch


class SeriesWindow(NamedTuple):
    """A step: its start and its length `end` [s]."""

    start: float
    end: float


class SeriesTrajectory:
    """names: of the coordinates; windows: the SeriesWindows of the steps; end: up to which it is known."""

    def __init__(self, march: "TaylorMarch", names: Sequence[str], until: float) -> None:
        bits, self.names, self.until, self.end = march.bits, list(names), until, until
        self.windows = [SeriesWindow(to_float(step.start, bits), to_float(step.end - step.start, bits))
                        for step in march.steps]
        self._starts = np.array([window.start for window in self.windows])
        self._march, self._rows = march, {}

    def at(self, times: Sequence[float] | np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(q, q̇, q̈), each of shape (coordinates, times)."""
        times = np.atleast_1d(np.asarray(times, dtype=float))
        found = np.empty((3 * len(self.names), len(times)))
        number = np.clip(np.searchsorted(self._starts, times, side="right") - 1, 0, len(self.windows) - 1)
        for k in np.unique(number):
            here = number == k
            scale, rows = self._in_floats(k)
            s = (times[here] - self._starts[k]) / scale
            total = np.zeros((len(rows), len(s)))
            for column in rows.T[::-1]:
                total = total * s + column[:, None]
            found[:, here] = total
        q, v, a = found.reshape(3, len(self.names), len(times))
        return q, v, a

    def _in_floats(self, k: int) -> tuple[float, np.ndarray]:
        """(the scale of a step, its coefficients as rows)."""
        if k not in self._rows:
            step, bits = self._march.steps[k], self._march.bits
            rows = [[to_float(x, bits) for x in row] for kind in step.series for row in kind]
            self._rows[k] = to_float(step.scale, bits), np.array(rows)
        found: tuple[float, np.ndarray] = self._rows[k]
        return found
