"""A record: a function of time given by samples, linear between them and zero outside."""

from bisect import bisect_right
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import mpmath
    import numpy as np


class Samples:
    """`times` ascending [s] and `values` (SI), as floats."""

    _arrays: "tuple[np.ndarray, np.ndarray] | None"

    __slots__ = ("_arrays", "times", "values")

    def __init__(self, times: Sequence[float], values: Sequence[float]) -> None:
        self.times, self.values, self._arrays = tuple(times), tuple(values), None

    @property
    def jumps(self) -> bool:
        """Does the record begin or end elsewhere than at zero?"""
        return bool(self.values[0] or self.values[-1])

    @property
    def arrays(self) -> "tuple[np.ndarray, np.ndarray]":
        """(times, values) as NumPy arrays."""
        if self._arrays is None:
            import numpy as np

            self._arrays = np.array(self.times), np.array(self.values)
        return self._arrays

    def at(self, u: "float | mpmath.mpf", order: int = 0) -> "float | mpmath.mpf":
        """The value at the instant u, or its rate (0 of the second order: there are impulses at the samples), for
        floats and mpmath numbers."""
        zero, last = u * 0, len(self.times) - 1
        i = last - 1 if u == self.times[last] else bisect_right(self.times, u) - 1
        if not 0 <= i < last or order > 1:
            return zero
        low, start = zero + self.times[i], zero + self.values[i]
        slope = (self.values[i + 1] - start) / (self.times[i + 1] - low)
        return slope if order else start + slope * (u - low)

    def on_arrays(self, u: "np.ndarray", order: float = 0) -> "np.ndarray":
        """The same for NumPy arrays."""
        import numpy as np

        times, values = self.arrays
        if not order:
            found: np.ndarray = np.interp(u, times, values, left=0.0, right=0.0)
            return found
        slopes = np.concatenate(([0.0], np.diff(values) / np.diff(times), [0.0]))
        return slopes[np.searchsorted(times, u, side="right")] * (order == 1)
