"""Taylor series of a motion y' = f(t, y) in integers: numbers are multiples of 2**-BITS, some 45 decimals of them.

A Tape holds the operations of f, and finds their coefficients one order after the other. Between events f is smooth;
at an event its instant is found to all digits, and another f goes on. Nothing here knows of vibcli.
"""

from fractions import Fraction
from math import isqrt
from operator import mul

import mpmath

BITS, ORDER = 150, 38
ONE = 1 << BITS
SMALL, NEGLIGIBLE = ONE >> 92, ONE >> 102     # the last coefficients of a step, and those of one that may be longer
SAMPLES = 24


def fixed(value):
    """A number: ints, fractions and decimals exactly but for the last bit."""
    if isinstance(value, mpmath.mpf):
        return int(mpmath.nint(mpmath.ldexp(value, BITS)))
    value = Fraction(value)
    return round(value * ONE)


def real(value):
    """The mpmath number of an integer."""
    return mpmath.ldexp(mpmath.mpf(value), -BITS)


class Series:
    """What a tape computes; c: its coefficients."""

    __slots__ = ("c", "tape")

    def __init__(self, tape, rule=None):
        self.tape, self.c = tape, []
        tape.all.append(self)
        if rule:
            tape.rules.append((self.c, rule))

    def _other(self, other):
        return other if isinstance(other, Series) else self.tape.constant(other)

    def __add__(self, other):
        a, b = self.c, self._other(other).c
        return Series(self.tape, lambda k, c: a[k] + b[k])

    __radd__ = __add__

    def __neg__(self):
        a = self.c
        return Series(self.tape, lambda k, c: -a[k])

    def __sub__(self, other):
        a, b = self.c, self._other(other).c
        return Series(self.tape, lambda k, c: a[k] - b[k])

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        a = self.c
        if not isinstance(other, Series):
            factor = fixed(other)
            return Series(self.tape, lambda k, c: a[k] * factor >> BITS)
        b = other.c
        return Series(self.tape, lambda k, c: sum(map(mul, a[:k + 1], b[k::-1])) >> BITS)

    __rmul__ = __mul__

    def __truediv__(self, other):
        a, b = self.c, self._other(other).c
        return Series(self.tape, lambda k, c: ((a[k] << BITS) - sum(map(mul, b[1:k + 1], c[::-1]))) // b[0])

    def __rtruediv__(self, other):
        return self._other(other) / self

    def __pow__(self, n):
        return self if n == 1 else self * self ** (n - 1)

    def sqrt(self):
        a = self.c

        def rule(k, c):
            if not k:
                return isqrt(a[0] << BITS)
            return ((a[k] << BITS) - sum(map(mul, c[1:k], c[k - 1:0:-1]))) // (2 * c[0])

        return Series(self.tape, rule)

    def sin_cos(self):
        """(sin, cos)."""
        u, weighted = self.c, []
        sine, cosine = Series(self.tape), Series(self.tape)

        def rule(k, c):
            if not k:
                weighted.clear()
                weighted.append(0)
                x = real(u[0])
                cosine.c.append(fixed(mpmath.cos(x)))
                return fixed(mpmath.sin(x))
            weighted.append(k * u[k])
            found = sum(map(mul, weighted[1:], cosine.c[::-1])) // k >> BITS
            cosine.c.append(-(sum(map(mul, weighted[1:], c[::-1])) // k >> BITS))
            return found

        self.tape.rules.append((sine.c, rule))
        return sine, cosine


class Tape:
    """f as written by build(tape, t, y), which returns (y' as a list, {name: what vanishes at an event}, {name: what
    else is wanted})."""

    def __init__(self, build, count):
        self.all, self.rules = [], []
        self.constants = []
        self.t, self.y = Series(self), [Series(self) for _ in range(count)]
        self.rates, self.events, self.signals = build(self, self.t, self.y)

    def constant(self, value):
        found, number = Series(self), fixed(value)
        self.constants.append((found, number))
        return found

    def expand(self, t, y, h):
        """Find all coefficients at (t, y), of powers of the part of a step h that is gone."""
        for one in self.all:
            one.c.clear()
        self.t.c += [t, h, *[0] * (ORDER - 1)]
        for one, number in self.constants:
            one.c += [number, *[0] * ORDER]
        for one, start in zip(self.y, y, strict=True):
            one.c.append(start)
        for k in range(ORDER + 1):
            for c, rule in self.rules:
                c.append(rule(k, c))
            if k < ORDER:
                for one, rate in zip(self.y, self.rates, strict=True):
                    one.c.append((h * rate.c[k] >> BITS) // (k + 1))

    def last(self):
        return max(abs(x) for one in self.y for x in one.c[-2:])


def at(c, x):
    """The value of a series at the part x of its step."""
    total = 0
    for one in reversed(c):
        total = (total * x >> BITS) + one
    return total


def roots(c, below=ONE):
    """Where a series vanishes in (0, below], ascending: found where it changes its sign between samples, of which the
    ends do where its first term or that of its slope outweighs the others."""
    sizes = [abs(x) for x in c[1:]]
    if abs(c[0]) > sum(sizes):
        return []
    steady = sizes[0] > sum(map(mul, sizes[1:], range(2, len(c))))
    found, count = [], 1 if steady else SAMPLES
    places = [below * i // count for i in range(count + 1)]
    values = [at(c, x) for x in places]
    for low, high, a, b in zip(places, places[1:], values, values[1:], strict=False):
        if (a < 0) != (b < 0) and a and b:
            found.append(_root(c, low, high, a, b))
    return found


def _root(c, low, high, a, b):
    for _ in range(200):
        middle = (low * b - high * a) // (b - a) if _ % 3 else (low + high) // 2
        middle = min(max(middle, low + 1), high - 1)
        value = at(c, middle)
        if high - low <= 2 or not value:
            break
        if (value < 0) == (a < 0):
            low, a = middle, value
        else:
            high, b = middle, value
    return middle
