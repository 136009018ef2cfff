"""A motion followed by Taylor series of high order, in fixed-point numbers of as many bits as are asked for.

A step goes as far as the last coefficients are below 2^−bits of the motion; with an order of 1.4 digits that is about
a fifth of the radius of convergence, which costs least (Jorba & Zou, Experimental Mathematics 14 (2005), 99). Steps
end where what drives the motion bends or jumps.
"""

from bisect import bisect_right
from collections.abc import Callable, Sequence
from math import ceil, inf, log2, log10
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.fixed_point import shifted

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.analyses.time_integration.motion_series import Coefficients, Computed

GUARD_BITS = 48         # for the rounding of the coefficients
ORDER = 1.4             # terms of a series for each digit
LAST = 4                # coefficients by which it is seen how far a series reaches
GROWTH_BITS = 12        # by which a longer step than was planned may enlarge rounding
CHECKS, SLACK = 16, 24   # places in a step at which the equations are checked; bits by which they may be off there
NOISE = 8               # bits of a coefficient that are rounding
SAFETY = 0.1            # of a binary order
FIRST_ORDER, ROUNDS = 12, 60
LOG_2 = log10(2)
SHORTEST, LONG = -200.0, 40     # log2 of a step [s]; to begin with


class Step(NamedTuple):
    """The series in s = (t − start)/scale of the motion for start ≤ t ≤ end, all of them fixed-point numbers."""

    start: int
    end: int
    scale: int
    series: "Coefficients"


class TaylorMarch:
    """The motion from [q, q̇] at t = 0, mpmath numbers; series(t, bits): (its series from an instant on, the instant at
    which others begin, the longest step), as `SmoothPieces` gives them; sizes: of the figure along each
    coordinate; spent(): told of each step."""

    def __init__(self, series: "Callable[[int, int], tuple[Computed, int | None, int | None]]",
                 start: "Callable[[int], Sequence[int]]", sizes: Sequence[float], digits: int, extra: int = 0,
                 spent: Callable[..., None] | None = None) -> None:
        self.digits, self.order = digits, ceil(ORDER * digits) + extra
        self.accuracy = ceil(digits * log2(10))
        self.bits = self.accuracy + GUARD_BITS
        self.steps: list[Step] = []
        self._series, self._spent = series, spent or (lambda march: None)
        self._state, self._t = list(start(self.bits)), 0
        self._scale: int | None = None
        self._sizes = [*(int(size * 2**53) << self.bits - 53 for size in sizes), *(0 for _ in sizes)]

    @property
    def end(self) -> int:
        """The instant that was reached."""
        return self._t

    def reach(self, instant: int) -> None:
        """March up to an instant at least."""
        while self._t < instant:
            self._advance()

    def at(self, time: "Fraction") -> list[list[int]]:
        """[q], [q̇], [q̈] at an instant."""
        step, s = self.step_at(time)
        return [[summed(row, s, self.bits) for row in rows] for rows in step.series]

    def shared_digits(self, other: "TaylorMarch", time: "Fraction") -> float:
        """How many digits of the motion until then, of each place and velocity, two marches share at an instant."""
        states = [[*q, *v] for q, v, _ in (self.at(time), other.at(time))]
        gaps = [x - shifted(y, self.bits - other.bits) for x, y in zip(*states, strict=True)]
        return min((LOG_2 * (size.bit_length() - gap.bit_length())
                    for gap, size in zip(gaps, self._scales(self._sizes), strict=True) if gap), default=inf)

    def step_at(self, time: "Fraction") -> tuple[Step, int]:
        """(the Step that holds an instant, s there)."""
        instant = (time.numerator << self.bits) // time.denominator
        self.reach(max(instant, 1))
        number = bisect_right(self.steps, instant, key=lambda step: step.start)
        step = self.steps[max(number - 1, 0)]
        return step, ((instant - step.start) << self.bits) // step.scale

    def _advance(self) -> None:
        compute, limit, longest = self._series(self._t, self.bits)
        try:
            if self._scale is None:
                first = self._first_scale(compute)
                self._scale = min(first, longest) if longest else first
            series = compute(self._t, self._scale, self._state, self.order)
        except ArithmeticError:
            raise self._undefined() from None
        reach = min(self._reach(series, self.accuracy), GROWTH_BITS / self.order)
        length = shifted(int(2.0 ** (reach % 1) * 2**30), int(reach // 1) - 30 + self.bits) * self._scale >> self.bits
        places: Sequence[int] = range(1, CHECKS + 1)
        if longest is None:
            places, longest = (CHECKS,), length if limit is None else limit - self._t
        length = self._checked(compute, series, min(length, longest), places)
        if self._is_none(length):
            raise self._undefined()
        end = self._t + length if limit is None else min(self._t + length, limit)
        self.steps.append(Step(self._t, end, self._scale, series))
        self._state = self._within(series, ((end - self._t) << self.bits) // self._scale)
        self._t, self._scale = end, None if end == limit else length
        self._spent(self)

    def _within(self, series: "Coefficients", s: int) -> list[int]:
        """[q, q̇] in a step."""
        return [summed(row, s, self.bits) for row in (*series.q, *series.v)]

    def _checked(self, compute: "Computed", series: "Coefficients",
                 length: int, places: Sequence[int]) -> int:
        """A length within which the series obeys the equations at its end, so that nothing grows unseen, as what a
        hyperbolic tangent lacks of 1, and at all `places` where a pulse of the time may be stepped over."""
        scale, bits = self._scale, self.bits
        sizes = self._scales([0] * len(self._sizes))[:len(series.q)]
        while not self._is_none(length):
            for k in places:
                t = length * k // CHECKS
                s = (t << bits) // scale
                found = compute(self._t + t, scale, self._within(series, s), 0).a
                gaps = (abs(row[0] - summed(mine, s, bits)) * length >> bits for row, mine in
                        zip(found, series.a, strict=True))
                if any((gap * length >> bits) >> SLACK > size >> self.accuracy
                       for gap, size in zip(gaps, sizes, strict=True)):
                    break
            else:
                break
            length //= 2
        return length

    def _is_none(self, length: int) -> bool:
        """Is a step too short to be one?"""
        return not length or log2(length) - self.bits < SHORTEST

    def _first_scale(self, compute: "Computed") -> int:
        """A time in which the motion changes, to begin with."""
        scale = 1 << self.bits
        for _ in range(ROUNDS):
            reach = self._reach(compute(self._t, scale, self._state, FIRST_ORDER), FIRST_ORDER)
            if abs(reach) < 1 or scale.bit_length() > self.bits + LONG:
                break
            scale = max(shifted(scale, int(max(-16.0, min(16.0, reach)))), 1)
        return scale

    def _reach(self, series: Any, accuracy: int) -> float:
        """log2 of how far the series reaches, s = 1 being 0, to so many bits of the motion."""
        rows = [*series.q, *series.v]
        self._sizes = [max(size, abs(row[0])) for size, row in zip(self._sizes, rows, strict=True)]
        found = inf
        for size, row in zip(self._scales([max(map(abs, row[:LAST])) for row in rows]), rows, strict=True):
            spare = max(size.bit_length() - accuracy, NOISE)
            found = min([found, *((spare - row[k].bit_length()) / k for k in range(len(row) - LAST, len(row))
                                  if row[k])])
        return min(found - SAFETY, 16.0)

    def _scales(self, now: Sequence[int]) -> list[int]:
        """What errors of each place and velocity are relative to: the motion so far and `now`; of a velocity also that
        of its place in the time of a step; nothing is smaller than rounding of the largest."""
        sizes, n, step = list(map(max, self._sizes, now)), len(now) // 2, self._scale or 1 << self.bits
        speeds = [max(v, (q << self.bits) // step) for q, v in zip(sizes[:n], sizes[n:], strict=True)]
        least = max(sizes) >> self.accuracy
        return [max(size, least) for size in (*sizes[:n], *speeds)]

    def _undefined(self) -> PhysicsError:
        t = self._t / 2**self.bits
        return PhysicsError(f"the series of this motion end at t = {t:.6g} s: a force or a linkage is singular there",
                            "leave --digits out, or ask for an earlier instant")


def summed(row: Sequence[int], s: int, bits: int) -> int:
    """Σ row[k] sᵏ"""
    total = 0
    for coefficient in reversed(row):
        total = (total * s >> bits) + coefficient
    return total
