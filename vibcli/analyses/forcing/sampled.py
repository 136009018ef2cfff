"""A record as a function of time that is a straight line between its samples; its rates as steps and impulses."""

from bisect import bisect_right
from fractions import Fraction


class Sampled:
    """The record at a·t + b, or its rate by that argument of the order 1 or 2."""

    __slots__ = ("a", "b", "end", "instants", "order", "values")

    period = None

    def __init__(self, samples, a, b, order):
        self.a, self.b, self.order = a, b, order
        pairs = [((Fraction(time) - b) / a, value) for time, value in zip(samples.times, samples.values, strict=True)]
        pairs = pairs if a > 0 else pairs[::-1]
        self.instants = [instant for instant, _ in pairs]
        self.values = [value for _, value in pairs]
        self.end = self.instants[-1]

    def __eq__(self, other):
        return isinstance(other, Sampled) and self._key() == other._key()

    def __hash__(self):
        return hash((self.a, self.b, self.order, len(self.instants)))

    def _key(self):
        return self.a, self.b, self.order, self.instants, self.values

    def _slope(self, i):
        """By the time, between the samples i and i + 1; 0 outside."""
        if not 0 <= i < len(self.instants) - 1:
            return 0
        return (Fraction(self.values[i + 1]) - Fraction(self.values[i])) / (self.instants[i + 1] - self.instants[i])

    def breaks(self, low, high):
        return [instant for instant in self.instants if low <= instant <= high]

    def line(self, start, middle):
        i = bisect_right(self.instants, middle) - 1
        if self.order > 1 or not 0 <= i < len(self.instants) - 1:
            return 0, 0
        slope = self._slope(i)
        if self.order:
            return slope / self.a, 0
        return Fraction(self.values[i]) + slope * (start - self.instants[i]), slope

    def impulses(self, low, high):
        """Of the first rate at the ends of a record that jumps there, of the second one wherever the slope changes."""
        if self.order == 0:
            return []
        if self.order == 2:
            sizes = [(self._slope(i) - self._slope(i - 1)) / self.a**2 for i in range(len(self.instants))]
        else:
            sizes = [Fraction(0)] * len(self.instants)
            sizes[0] += Fraction(self.values[0]) / self.a
            sizes[-1] -= Fraction(self.values[-1]) / self.a
        return [(instant, size) for instant, size in zip(self.instants, sizes, strict=True)
                if size and low <= instant <= high]
