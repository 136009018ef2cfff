"""Zeros and maxima of a function of one unknown, each in an interval of its own, all at once: the function is given an
array of places."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import mpmath

ROUNDS, SAME = 150, 2.0**-51
NOTHING = 2.0**-80              # of an interval: a zero nearer to 0 than this is known well enough
SECTIONS, GOLDEN = 90, 0.3819660112501051


def zeros_between(function: Callable, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """The zero of a function in each of the intervals at whose ends its signs differ, to rounding.

    Chords, each third step a halving; a chord that falls near an end is moved inwards, so that both ends close in.
    """
    low, high = low.copy(), high.copy()
    at_low, at_high, least = np.array(function(low)), np.array(function(high)), NOTHING * (high - low)
    for step in range(ROUNDS):
        wide = np.flatnonzero(high - low > np.maximum(SAME * np.maximum(np.abs(low), np.abs(high)), least))
        if not len(wide):
            break
        a, b, fa, fb = (part[wide] for part in (low, high, at_low, at_high))
        trial = _trial(a, b, fa, fb, step)
        f = np.nan_to_num(np.array(function(trial)), nan=0.0)
        left = (np.sign(f) == np.sign(fa)) | (f == 0)
        right = ~left | (f == 0)
        low[wide], at_low[wide] = np.where(left, trial, a), np.where(left & (f != 0), f, fa)
        high[wide], at_high[wide] = np.where(right, trial, b), np.where(right & (f != 0), f, fb)
    return (low + high) / 2


def _trial(a, b, fa, fb, step):
    middle = (a + b) / 2
    if step % 3 == 2:
        return middle
    with np.errstate(all="ignore"):
        chord = a + (b - a) * (fa / (fa - fb))
        share = (b - a) * (0.0 if step % 3 == 0 else 1e-3)
        chord = np.where(chord - a < b - chord, np.maximum(chord + (chord - a), a + share),
                         np.minimum(chord - (b - chord), b - share)) if step % 3 else chord
    return np.where((chord > a) & (chord < b), chord, middle)


def maxima_between(function: Callable, low: Any, high: "float | mpmath.mpf", sections: int = SECTIONS):
    """Where a function is largest in each of the intervals in which it has one maximum, by golden section."""
    for _ in range(sections if len(low) else 0):
        left, right = low + GOLDEN * (high - low), high - GOLDEN * (high - low)
        falls = function(left) >= function(right)
        low, high = np.where(falls, low, left), np.where(falls, right, high)
    return 0.5 * (low + high)
