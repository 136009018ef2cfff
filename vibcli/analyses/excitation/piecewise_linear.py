"""Functions of time that are straight lines from one break to the next, with impulses at some of the breaks.

Each has `breaks(low, high)`, the instants within [low, high]; `line(at)`, its value at the start and its slope on the
piece that holds the middle of an Instant; `impulses(low, high)` as (instant, size); `period` (None: it ends at `end`).
"""

from bisect import bisect_right
from fractions import Fraction
from math import ceil, floor
from typing import Any

from vibcli.base.named_tuple import NamedTuple


class Instant(NamedTuple):
    """A segment: its start, and an instant within it, as numbers of the arithmetic and exactly."""

    start: Any
    exact_start: Fraction
    middle: Any
    exact_middle: Fraction


class Periodic(NamedTuple):
    """A line on each part of a turn x = a·t + b, a > 0: value and slope per turn from each of the corners (0 ≤ x < 1)
    on; `blows`: the impulse at each corner."""

    a: Fraction
    b: Fraction
    corners: tuple[Fraction | int, ...]
    lines: tuple[tuple[Fraction | int, Fraction | int], ...]
    blows: tuple[Fraction, ...] = ()

    end = None

    @property
    def period(self) -> Fraction:
        return 1 / self.a

    def count(self, low: Any, high: Any) -> Fraction:
        """About how many breaks there are."""
        found: Fraction = (high - low) * self.a * len(self.corners)
        return found

    def _instants(self, low: Fraction, high: Fraction) -> list[tuple[Fraction, int]]:
        first, last = floor(self.a * low + self.b), ceil(self.a * high + self.b)
        found = [((turn + corner - self.b) / self.a, j) for turn in range(first - 1, last + 1)
                 for j, corner in enumerate(self.corners)]
        return [pair for pair in found if low <= pair[0] <= high]

    def breaks(self, low: Fraction, high: Fraction) -> list[Fraction]:
        return [instant for instant, _ in self._instants(low, high)]

    def line(self, at: Instant) -> tuple[Fraction, Fraction]:
        turns = self.a * at.exact_middle + self.b
        whole = floor(turns)
        j = bisect_right(self.corners, turns - whole) - 1
        whole -= j < 0
        value, slope = self.lines[j]
        from_corner = self.a * at.exact_start + self.b - whole - self.corners[j]
        return value + slope * from_corner, slope * self.a

    def impulses(self, low: Fraction, high: Fraction) -> list[tuple[Fraction, Fraction]]:
        return [(instant, self.blows[j]) for instant, j in self._instants(low, high)] if self.blows else []


class Blow(NamedTuple):
    """An impulse of one size at one instant."""

    end: Fraction
    size: Fraction

    period = None

    def count(self, low: Any, high: Any) -> int:
        return 1

    def breaks(self, low: Fraction, high: Fraction) -> list[Fraction]:
        return [self.end] if low <= self.end <= high else []

    def line(self, at: Instant) -> tuple[int, int]:
        return 0, 0

    def impulses(self, low: Fraction, high: Fraction) -> list[tuple[Fraction, Fraction]]:
        return [(self.end, self.size)] if low <= self.end <= high else []


def square(a: Fraction, b: Fraction, pi: Fraction, order: int) -> Periodic:
    """square(u), u = a·t + b, or its rate by u: impulses of 2 and −2."""
    sign, a, b = (1, a, b) if a > 0 else (-1, -a, -b)
    halves = (Fraction(0), Fraction(1, 2))
    if order:
        return Periodic(a / (2 * pi), b / (2 * pi), halves, ((0, 0), (0, 0)), (2 / a, -2 / a))
    return Periodic(a / (2 * pi), b / (2 * pi), halves, ((sign, 0), (-sign, 0)))


def sawtooth(a: Fraction, b: Fraction, pi: Fraction, order: int) -> Periodic:
    """sawtooth(u), u = a·t + b, or its rate by u: 1/π, and impulses of −2."""
    sign, a, b = (1, a, b) if a > 0 else (-1, -a, -b)
    if order:
        return Periodic(a / (2 * pi), b / (2 * pi), (Fraction(0),), ((1 / pi, 0),), (-2 / a,))
    return Periodic(a / (2 * pi), b / (2 * pi), (Fraction(0),), ((-sign, 2 * sign),))


def sign_of_sine(a: Fraction, b: Fraction, arc: Fraction, pi: Fraction, rate: Fraction | None) -> Periodic:
    """The sign of sin u + height, u = a·t + b, |height| < 1, arc = asin(height); or, as a `rate`, δ(sin u + height)."""
    rise, fall = -arc / (2 * pi), Fraction(1, 2) + arc / (2 * pi)
    corners = ((rise % 1, 1), (fall % 1, -1))
    first, second = sorted(corners)
    a, b = a / (2 * pi), b / (2 * pi)
    if rate is not None:
        return Periodic(a, b, (first[0], second[0]), ((0, 0), (0, 0)), (rate, rate))
    return Periodic(a, b, (first[0], second[0]), ((first[1], 0), (second[1], 0)))
