"""Halton's sequence of points (Halton 1960)."""

from collections.abc import Iterator
from itertools import count


def halton(dimensions: int, first: int = 1) -> Iterator[list[float]]:
    """Points spread evenly over the unit cube, the same at every run, from that of a number on."""
    bases = _primes(dimensions)
    for number in count(first):
        yield [_radical_inverse(number, base) for base in bases]


def _radical_inverse(number: int, base: int) -> float:
    """The digits of a number mirrored at the point."""
    value, place = 0.0, 1.0 / base
    while number:
        number, digit = divmod(number, base)
        value += digit * place
        place /= base
    return value


def _primes(n: int) -> list[int]:
    found, candidate = [], 2
    while len(found) < n:
        if all(candidate % p for p in found):
            found.append(candidate)
        candidate += 1
    return found
