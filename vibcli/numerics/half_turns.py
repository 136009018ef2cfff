"""Angles m π x/l of many half-turns m, reduced without loss: m x/l with its rounding, less whole turns.

A product of doubles is a sum of two (Veltkamp, Dekker 1971): a b = p + r with p = fl(a b).
"""

from typing import Any

import numpy as np

SPLIT = 2.0 ** 27 + 1


def half_turns(m: Any, x: Any, length: Any, mirrored: bool) -> tuple[Any, Any, Any]:
    """(t, rest, x/l): m x/l = t + rest + a multiple of 2, |t| ≤ 1, |rest| of the order m eps; mirrored: of l − x."""
    place = length - x if mirrored else x
    lost = (length - place) - x if mirrored else 0.0
    share = place / length
    product, rest = _product(share, length)
    lost = (((place - product) - rest) + lost) / length
    turns, rest = _product(m, share)
    return turns - 2 * np.rint(turns / 2), rest + m * lost, share


def _product(a, b):
    """a b as (fl(a b), what rounding took)."""
    product = a * b
    (high, low), (other, rest) = _halves(a), _halves(b)
    return product, ((high * other - product) + high * rest + low * other) + low * rest


def _halves(a):
    """A double as the sum of two of 26 digits."""
    large = SPLIT * a
    high = large - (large - a)
    return high, a - high
