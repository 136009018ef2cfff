"""Integrals of a function along straight sides in the complex plane, of f′/f around a rectangle the argument principle:
Gauss's rule, on parts that are halved until both halves tell what the whole does."""

from collections.abc import Callable, Sequence
from functools import lru_cache

import numpy as np

from vibcli.base.named_tuple import NamedTuple

POINTS, PARTS, DEEPEST = 10, 1, 18      # of a rule, parts of a side to begin with, how often they are halved
CLOSE = 1e-5        # how closely halves agree
OPEN = 16           # parts of a side at once whose halves do not agree: near so many poles, or lost in rounding


class SideSamples(NamedTuple):
    """Points s and the weighted values there whose sum is the integral."""

    s: np.ndarray
    values: np.ndarray


@lru_cache
def _rule() -> tuple[np.ndarray, np.ndarray]:
    at, weights = np.polynomial.legendre.leggauss(POINTS)
    return (at + 1) / 2, weights / 2


def along(function: Callable[[np.ndarray], np.ndarray],
          sides: Sequence[tuple[complex, complex]]) -> list[SideSamples | None]:
    """The SideSamples on each side (from, to), all evaluated together; None of a side next to a pole, or where the
    function is not finite."""
    at, weights = _rule()
    number = np.repeat(np.arange(len(sides)), PARTS)
    start = np.array([a + (b - a) * k / PARTS for a, b in sides for k in range(PARTS)])
    width = np.array([(b - a) / PARTS for a, b in sides for _ in range(PARTS)])
    kept: list[list[SideSamples]] = [[] for _ in sides]

    def sampled(start: np.ndarray, width: np.ndarray) -> "tuple[np.ndarray, np.ndarray]":
        s = start[:, None] + width[:, None] * at
        with np.errstate(invalid="ignore"):
            return s, function(s.ravel()).reshape(s.shape) * weights * width[:, None]

    s, values = sampled(start, width)
    lost = set()
    for _ in range(DEEPEST):
        half = np.repeat(width / 2, 2)
        begins = np.stack([start, start + width / 2], axis=1).ravel()
        s, finer = sampled(begins, half)
        with np.errstate(invalid="ignore"):
            apart = np.abs(finer.sum(axis=1).reshape(-1, 2).sum(axis=1) - values.sum(axis=1))
        good = np.repeat(apart <= CLOSE, 2)
        for k in np.unique(number[good[::2]]):
            mine = good & np.repeat(number == k, 2)
            kept[k].append(SideSamples(s[mine].ravel(), finer[mine].ravel()))
        number, start, width, values = np.repeat(number, 2)[~good], begins[~good], half[~good], finer[~good]
        crowded = np.bincount(number, minlength=len(sides)) > OPEN
        crowded[number[~np.isfinite(values).all(axis=1)]] = True
        lost.update(np.flatnonzero(crowded).tolist())
        number, start, width, values = (part[~crowded[number]] for part in (number, start, width, values))
        if not len(number):
            break
    lost.update(number.tolist())
    return [None if k in lost else SideSamples(*(np.concatenate(part) for part in zip(*own, strict=True)))
            for k, own in enumerate(kept)]
