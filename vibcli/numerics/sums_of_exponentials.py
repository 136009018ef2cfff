"""Re Σ c e^{λt} of many λ at many instants: of equidistant ones t + (im + j) h as Σ (c e^{λ(t + imh)}) (e^{λjh}), the
product of two matrices whose sides are the root of how many instants there are."""

from collections.abc import Iterator
from math import isqrt

import numpy as np

AT_ONCE = 2_000_000     # exponentials at a time
FEWEST = 64             # instants that are worth a product
EVEN = 2.0**-51         # of the last instant: how far even ones lie off at most


def sum_of_exponentials(c: np.ndarray, rates: np.ndarray, t: np.ndarray) -> np.ndarray:
    """At instants (n,), in order: long runs of equidistant ones by products, and those between one by one."""
    found, at = np.empty(len(t)), 0
    for begin, end in _runs(t):
        found[at:begin] = _one_by_one(c, rates, t[at:begin])
        found[begin:end] = _even(c, rates, t[begin:end])
        at = end
    found[at:] = _one_by_one(c, rates, t[at:])
    return found


def _runs(t: np.ndarray) -> Iterator[tuple[int, int]]:
    """(begin, end) of the runs of equidistant instants that are worth a product."""
    if len(t) < FEWEST:
        return
    bent, at = np.abs(np.diff(t, 2)) > 4 * EVEN * abs(t[-1]), 0
    edges = np.flatnonzero(np.concatenate([[True], bent, [True]]))      # of the steps that are alike
    for first, last in zip(edges[:-1].tolist(), edges[1:].tolist(), strict=True):
        begin, end = max(at, first), last + 1
        if end - begin >= FEWEST and _is_even(t[begin:end]):
            yield begin, end
            at = end


def _is_even(t: np.ndarray) -> bool:
    step = (t[-1] - t[0]) / (len(t) - 1)
    found: bool = np.abs(t - (t[0] + step * np.arange(len(t)))).max() <= EVEN * abs(t[-1])
    return found


def _even(c: np.ndarray, rates: np.ndarray, t: np.ndarray) -> np.ndarray:
    wide = isqrt(len(t) - 1) + 1
    step, found = (t[-1] - t[0]) / (len(t) - 1), np.zeros(wide * wide)
    for i in range(0, len(rates), max(1, AT_ONCE // wide)):
        part = slice(i, i + max(1, AT_ONCE // wide))
        first = c[part] * np.exp(np.outer(t[0] + step * wide * np.arange(wide), rates[part]))
        then = np.exp(np.outer(step * np.arange(wide), rates[part]))
        found += (first.real @ then.real.T - first.imag @ then.imag.T).ravel()
    return found[:len(t)]


def _one_by_one(c: np.ndarray, rates: np.ndarray, t: np.ndarray) -> np.ndarray:
    found, step = np.zeros(len(t)), max(1, AT_ONCE // max(1, len(rates)))
    for i in range(0, len(t), step):
        found[i:i + step] = np.real(np.exp(np.outer(t[i:i + step], rates)) @ c)
    return found
