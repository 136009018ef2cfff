"""A record as a function of time that is a straight line between its samples; its rates as steps and impulses."""

from bisect import bisect_right
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from typing import TypeVar

    from vibcli.analyses.excitation.piecewise_linear import Instant
    from vibcli.symbolic.sampled_functions import Samples

    T = TypeVar("T")


class TabulatedFunction:
    """The record at a·t + b, or its rate by that argument of the order 1 or 2. `instants` are exact, all else are
    numbers of the arithmetic: a record holds many samples, which are looked at when asked for."""

    period = None

    def __init__(self, samples: "Samples", a: Fraction | int, b: Fraction | int, order: int,
                 numbers: type[Any]) -> None:
        self.samples, self.a, self.b, self.order, self.numbers = samples, a, b, order, numbers
        self.number = numbers.number

    def __eq__(self, other: Any) -> bool:
        return isinstance(other, TabulatedFunction) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> tuple[int, Fraction | int, Fraction | int, int]:
        return id(self.samples), self.a, self.b, self.order

    def __len__(self) -> int:
        return len(self.samples.times)

    @cached_property
    def instants(self) -> list[Fraction]:
        return self._upwards([self._instant(time) for time in self.samples.times])

    @cached_property
    def places(self) -> list[Any]:
        return [self.number(instant) for instant in self.instants]

    @cached_property
    def values(self) -> list[float]:
        return self._upwards(list(self.samples.values))

    @cached_property
    def slopes(self) -> list[Any]:
        times, values, real = self.samples.times, self.samples.values, self.numbers.real
        steep = self.number(self.a)
        return self._upwards([(real(values[i + 1]) - values[i]) / (real(times[i + 1]) - times[i]) * steep
                              for i in range(len(times) - 1)])

    @cached_property
    def end(self) -> Fraction:
        return self._instant(self.samples.times[-1 if self.a > 0 else 0])

    def _instant(self, time: float) -> Fraction:
        return (Fraction(time) - self.b) / self.a if self.b or self.a != 1 else Fraction(time)

    def _upwards(self, row: "list[T]") -> "list[T]":
        """In order of the time."""
        if self.a < 0:
            row.reverse()
        return row

    def count(self, low: Any, high: Any) -> int:
        return len(self)

    def breaks(self, low: Fraction, high: Fraction) -> list[Fraction]:
        return [instant for instant in self.instants if low <= instant <= high]

    def line(self, at: "Instant") -> tuple[float, float]:
        i = bisect_right(self.places, at.middle) - 1
        if self.order > 1 or not 0 <= i < len(self.slopes):
            return 0, 0
        slope = self.slopes[i]
        if self.order:
            return slope / self.number(self.a), 0
        late = at.exact_start - self.instants[i]
        return self.values[i] + slope * self.number(late) if late else self.values[i], slope

    def impulses(self, low: Fraction, high: Fraction) -> list[tuple[Fraction, float]]:
        """Of the first rate at the ends of a record that jumps there, of the second one wherever the slope changes."""
        if self.order == 0:
            return []
        if self.order == 2:
            square = self.number(self.a**2)
            sizes = [(after - before) / square for before, after in zip([0, *self.slopes], [*self.slopes, 0],
                                                                        strict=True)]
        else:
            sizes = [0] * len(self.values)
            sizes[0] += self.values[0] / self.number(self.a)
            sizes[-1] -= self.values[-1] / self.number(self.a)
        return [(instant, size) for instant, size in zip(self.instants, sizes, strict=True)
                if size and low <= instant <= high]
