"""Functions of the time that jump or bend at fronts and are smooth between: Chebyshev series, stretch by stretch."""

from bisect import bisect_right
from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.numerics.chebyshev import POINTS, RATE, TO_SERIES, WIDTH, N, summed

if TYPE_CHECKING:
    from vibcli.analyses.excitation.forcing import Segment, Wave

LEVELS = 3          # a function, its rate, the rate of that
EVEN = 8 * 2.0**-52 # of the largest rate: how far a rate that is constant may stray
MOST_POWERS = 24    # of the time: what is left of e^{sτ} for |sτ| ≤ 1 is far below rounding
SAME = 1e-12        # relative distance of instants that are one


class PiecewiseSeries:
    """A function known stretch by stretch, with its first two rates, each a Chebyshev series. Stretches begin at exact
    instants, so that delays add up without rounding. scale: the largest that each level has been; leaps: the
    instants at which the function itself leaps, so that its rates are infinite there."""

    __slots__ = ("_lengths", "_series", "_starts", "count", "exact", "leaps", "scale")

    def __init__(self) -> None:
        self.count, self.scale, self.exact, self.leaps = 0, np.zeros(LEVELS), [], []
        self._starts, self._lengths, self._series = np.empty(16), np.empty(16), np.empty((16, LEVELS, WIDTH))

    def append(self, start: Fraction, length: Fraction, series: np.ndarray, sizes: Any = 0.0) -> None:
        """One stretch more, that begins where the last ended; series: (LEVELS, WIDTH); sizes: what each level is
        rounded from at least."""
        if self.count == len(self._starts):
            room = np.empty_like(self._starts)
            self._starts, self._lengths = np.append(self._starts, room), np.append(self._lengths, room)
            self._series = np.concatenate([self._series, np.empty_like(self._series)])
        self.exact.append((start, length))
        self._starts[self.count], self._lengths[self.count], self._series[self.count] = start, length, series
        self.count += 1
        self.scale = np.maximum(np.maximum(self.scale, sizes), np.abs(series).sum(axis=1))

    @property
    def starts(self) -> np.ndarray:
        """The instants at which the stretches begin."""
        return self._starts[:self.count]

    @property
    def end(self) -> float:
        """The value with which the last stretch ends; 0 where there is none."""
        return float(self._series[self.count - 1, 0].sum()) if self.count else 0.0

    def at(self, times: np.ndarray, level: int = 0, tolerance: Any = 0.0, before: bool = False) -> np.ndarray:
        """The values at instants; within a tolerance of a jump those after it, or before it. Rates beyond the levels
        are those of the last."""
        if before:
            place = np.searchsorted(self.starts, times - tolerance, "left") - 1
        else:
            place = np.searchsorted(self.starts, times + tolerance, "right") - 1
        place = np.maximum(place, 0)
        length, series = self._lengths[place], self._series[place, min(level, LEVELS - 1)]
        for _ in range(level - LEVELS + 1):
            series = series @ RATE * (2 / length[:, None])
        return summed(series, 2 * (times - self._starts[place]) / length - 1)

    @property
    def even_from(self) -> tuple[float, float]:
        """(the instant from which its rate has been constant and it has not leapt, as far as it is known, infinite
        where its rate still changes; that rate)."""
        rates = self._series[:self.count, 1]
        last = float(rates[-1, 0])
        other = rates[:, 1:].any(axis=1) | (np.abs(rates[:, 0] - last) > EVEN * self.scale[1])
        changing = np.flatnonzero(other)
        first = int(changing[-1]) + 1 if len(changing) else 0
        return (max([float(self._starts[first]), *self.leaps]) if first < self.count else np.inf), last

    def rounding(self, times: np.ndarray, level: int) -> np.ndarray:
        """How often the rounding of a number the values may be off: that of each stretch so far adds to it, and each
        differentiation of a series multiplies it."""
        count = np.maximum(np.searchsorted(self.starts, times, "right"), 1)
        found: np.ndarray = (16 + 4 * count) * self.scale[min(level, LEVELS - 1)]
        if level >= LEVELS - 1:
            found = found + (16 + 4 * count) * self.scale[1] * (N * N / self._lengths[count - 1])**(level - 1)
        return found

    def series(self, start: Fraction, length: Fraction) -> np.ndarray:
        """(LEVELS, WIDTH): its series on a stretch."""
        first = max(bisect_right(self.exact, start, key=lambda part: part[0]) - 1, 0)
        nearest = min(range(first, min(first + 2, self.count)), key=lambda k: abs(self.exact[k][0] - start))
        if max(abs(float(x - y)) for x, y in zip(self.exact[nearest], (start, length), strict=True)) < SAME * length:
            return cast("np.ndarray", self._series[nearest].copy())
        values, points = np.empty((LEVELS, N)), float(length) / 2 * (1 + POINTS)
        while first < self.count:
            begin, lasts = self.exact[first]
            tau = float(start - begin) + points
            inside = tau >= 0 if first else slice(None)
            rows = np.broadcast_to(self._series[first][:, None], (LEVELS, N, WIDTH))
            values[:, inside] = summed(rows, 2 * tau / float(lasts) - 1)[:, inside]
            if begin + lasts >= start + length:
                break
            first += 1
        return series_of(values)


def series_of(values: np.ndarray) -> np.ndarray:
    """The series of values at the points, (…, N) to (…, WIDTH); of what is constant, exactly that constant."""
    first = values[..., :1]
    found = np.zeros((*values.shape[:-1], WIDTH))
    found[..., :N] = (values - first) @ TO_SERIES
    found[..., :1] += first
    return found


class Loads:
    """Piecewise sums of τᵏe^{sτ} read at instants: of the time, or of a place along a member."""

    __slots__ = ("channels", "pieces", "starts")

    def __init__(self, channels: int, pieces: "list[Segment]") -> None:
        self.channels, self.pieces = channels, pieces
        self.starts = np.array([piece.start for piece in pieces] or [0.0])

    def piece_at(self, instant: float) -> int:
        """The number of the piece in which an instant lies."""
        return max(int(np.searchsorted(self.starts, instant, "right")) - 1, 0)

    def at(self, number: int, start: Fraction | float, later: np.ndarray, order: int = 0) -> np.ndarray:
        """(channels, instants): the order-th rates of a piece at instants after `start`, also beyond its ends."""
        found = np.zeros((self.channels, len(later)))
        since = float(start - Fraction(float(self.starts[number])))
        waves = self.pieces[number].waves if self.pieces else ()
        fastest = max((abs(complex(wave.exponent)) for wave in waves), default=0.0)
        if 0 < fastest * np.abs(since + later).max(initial=0.0) <= 1:
            return _in_powers(waves, found, since + later, order)
        for wave in waves:
            terms = {wave.power: complex(wave.coefficient)}
            for _ in range(order):
                terms = _differentiated(terms, wave.exponent)
            moved = np.exp(wave.exponent * since) * np.exp(wave.exponent * later)
            for power, factor in terms.items():
                found[wave.channel] += np.real(factor * (since + later)**power * moved)
        return found

    def used(self, number: int) -> set[int]:
        """The channels on which a piece has waves."""
        return {wave.channel for wave in self.pieces[number].waves} if self.pieces else set()


def _in_powers(waves: "tuple[Wave, ...]", found: np.ndarray, tau: np.ndarray, order: int) -> np.ndarray:
    """The same while no wave has turned far, in powers of the time, of which those that cancel leave nothing."""
    sums = {wave.channel: np.zeros(MOST_POWERS) for wave in waves}
    for wave in waves:
        s, factor = complex(wave.exponent), complex(wave.coefficient)
        for power in range(wave.power, MOST_POWERS):
            sums[wave.channel][power] += factor.real
            factor *= s / (power - wave.power + 1)
    for channel, row in sums.items():
        found[channel] = np.polynomial.polynomial.polyval(tau, np.polynomial.polynomial.polyder(row, order))
    return found


def _differentiated(terms: Mapping[int, complex], exponent: complex) -> dict[int, complex]:
    found: dict[int, complex] = {}
    for power, factor in terms.items():
        found[power] = found.get(power, 0.0) + factor * exponent
        if power:
            found[power - 1] = found.get(power - 1, 0.0) + factor * power
    return found
