"""What is told of a key over many variants: its ends, how often it is another, the mistakes that come nearest."""

from collections.abc import Iterable, Sequence
from functools import reduce
from math import inf
from typing import Any

from vibcli.base.named_tuple import NamedTuple


class KeySummary(NamedTuple):
    """first, low, high: the first key, the least and the largest, which are the first where they are no numbers; texts:
    the keys as they are written; figures: the least and the most that are asked; widest: the widest band, relative;
    nearest: {mistake: (by how much it misses, relative to the key, ∞ of 0 and of what is no number; the key; what it
    gives)} of the first key that it misses by least."""

    first: Any
    low: Any
    high: Any
    texts: frozenset[str]
    figures: tuple[int, int]
    widest: float
    nearest: dict[str, tuple[float, Any, Any]]

    def with_later(self, other: "KeySummary") -> "KeySummary":
        """That of its keys and later ones."""
        low, high = self.low, self.high
        if self.first.value is not None:
            low, high = min(low, other.low, key=_value), max(high, other.high, key=_value)
        figures = min(self.figures[0], other.figures[0]), max(self.figures[1], other.figures[1])
        nearest = dict(self.nearest)
        for name, one in other.nearest.items():
            if name not in nearest or one[0] < nearest[name][0]:
                nearest[name] = one
        return KeySummary(self.first, low, high, self.texts | other.texts, figures, max(self.widest, other.widest),
                          nearest)


def summaries(variants: Sequence[Any]) -> list[KeySummary]:
    """The KeySummary of each key of ProblemVariants; none of no variants."""
    return [_summary(keys) for keys in zip(*(one.keys for one in variants), strict=True)]


def joined(parts: Iterable[Sequence[KeySummary]]) -> list[KeySummary]:
    """Those of variants in parts."""
    return [reduce(KeySummary.with_later, of_key) for of_key in zip(*parts, strict=True)]


def _summary(keys: Sequence[Any]) -> KeySummary:
    first, texts, nearest = keys[0], frozenset(one.written for one in keys), _nearest(keys)
    if first.value is None:
        return KeySummary(first, first, first, texts, (0, 0), 0.0, nearest)
    figures = [one.band.figures for one in keys]
    widest = max((one.band.width / abs(one.value) for one in keys if one.value), default=0.0)
    return KeySummary(first, min(keys, key=_value), max(keys, key=_value), texts, (min(figures), max(figures)), widest,
                      nearest)


def _value(key: Any) -> float:
    value: float = key.value
    return value


def _nearest(keys: Sequence[Any]) -> dict[str, tuple[float, Any, Any]]:
    found: dict[str, tuple[float, Any, Any]] = {}
    for one in keys:
        value = one.value
        for name, wrong in one.wrong:
            gap = abs((wrong - value) / value) if value else inf
            if name not in found or gap < found[name][0]:
                found[name] = gap, one, wrong
    return found
