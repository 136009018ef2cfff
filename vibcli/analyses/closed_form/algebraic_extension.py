"""Arithmetic with a root λ of a polynomial: elements u₀ + u₁λ + … are lists of coefficients."""

from collections.abc import Callable, Sequence
from math import prod
from typing import Any

from vibcli.symbolic.normal_form import TooLong

MOST = 1e8      # numbers by which common factors of two elements are looked for


class Extension:
    """F[λ]/(p) for an irreducible p over a field F. `modulus`: [p₀, …, p_d] with p_d ≠ 0; `zero` of F."""

    def __init__(self, field: Any, modulus: Sequence[Any]) -> None:
        self.field, self.zero, self.one = field, field(0), field(1)
        lead = modulus[-1]
        self.modulus = [c / lead for c in modulus]

    def reduced(self, element: list[Any]) -> list[Any]:
        element = list(element)
        d = len(self.modulus) - 1
        while len(element) > d:
            top = element.pop()
            if top:
                for i in range(d):
                    element[len(element) - d + i] -= top * self.modulus[i]
        return _trimmed(element)

    def times(self, a: Sequence[Any], b: Any) -> list[Any]:
        return self.reduced(self._product(a, b))

    def minus(self, a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
        _require_short(a, b)
        n = max(len(a), len(b))
        a, b = (list(x) + [self.zero] * (n - len(x)) for x in (a, b))
        return _trimmed([x - y for x, y in zip(a, b, strict=True)])

    def quotient(self, a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
        return self.times(self.reduced(list(a)), self.inverse(self.reduced(list(b))))

    def inverse(self, a: Sequence[Any]) -> list[Any]:
        """1/a by Euclid's algorithm on (p, a)."""
        r: tuple[Sequence[Any], Sequence[Any]] = list(self.modulus), a
        s: tuple[list[Any], list[Any]] = [], [self.one]
        while len(r[1]) > 1:
            quotient, rest = self._divided(r[0], r[1])
            r = r[1], rest
            s = s[1], self.minus(s[0], self._product(quotient, s[1]))
        return self.reduced([c / r[1][0] for c in s[1]])

    def _product(self, a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
        _require_short(a, b)
        found = [self.zero] * (len(a) + len(b) - 1)
        for i, x in enumerate(a):
            for j, y in enumerate(b):
                found[i + j] += x * y
        return found

    def _divided(self, a: Sequence[Any], b: Sequence[Any]) -> tuple[list[Any], list[Any]]:
        a, quotient = list(a), [self.zero] * max(0, len(a) - len(b) + 1)
        while len(a) >= len(b):
            _require_short(a, b, a[-1:])
            factor, shift = a[-1] / b[-1], len(a) - len(b)
            quotient[shift] = factor
            a = _trimmed([x - factor * b[i - shift] if i >= shift else x for i, x in enumerate(a)][:-1])
        return quotient, a

    def null_vectors(self, rows: Sequence[list[list[Any]]]) -> list[list[list[Any]]]:
        """A basis of the solutions of A x = 0; in each vector the first free coordinate is 1."""
        n, work, pivots = len(rows[0]), [list(row) for row in rows], []
        for column in reversed(range(n)):
            row = next((i for i in range(len(pivots), len(work)) if work[i][column]), None)
            if row is None:
                continue
            at = len(pivots)
            work[at], work[row] = work[row], work[at]
            inverse = self.inverse(work[at][column])
            work[at] = [self.times(inverse, x) for x in work[at]]
            for i, other in enumerate(work):
                if i != at and other[column]:
                    factor = other[column]
                    work[i] = [self.minus(x, self.times(factor, y)) for x, y in zip(other, work[at], strict=True)]
            pivots.append(column)
        return [self._solution(n, work, pivots, free) for free in range(n) if free not in pivots]

    def _solution(self, n: int, work: Sequence[list[list[Any]]], pivots: Sequence[int], free: int) -> list[list[Any]]:
        vector = [[] for _ in range(n)]
        vector[free] = [self.one]
        for row, column in zip(work, pivots, strict=False):
            vector[column] = self.minus([], row[free])
        return vector


def unless_long(work: Callable[..., Any], *args: Any) -> Any:
    """What work gives; None where it is TooLong."""
    try:
        return work(*args)
    except TooLong:
        return None


def _require_short(*elements: Sequence[Any]) -> None:
    """TooLong where sums or products of their coefficients have. SymPy puts a number for one letter after the
    other, each as many times longer as that letter's degree (Char, Geddes & Gonnet, GCDHEU, 1989), so that the product
    of all degrees tells how long they become."""
    degrees = [[max(column) for column in zip(*(part.degrees() for c in element if c for part in (c.numer, c.denom)),
                                             strict=True)] for element in elements]
    if prod(1 + sum(column) for column in zip(*filter(None, degrees), strict=True)) > MOST:
        raise TooLong


def _trimmed(element: list[Any]) -> list[Any]:
    while element and not element[-1]:
        element.pop()
    return element
