"""Zeros and maxima of a function of one unknown, each in an interval of its own, all at once: the function is given an
array of places."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import mpmath

ROUNDS, SAME = 150, 2.0**-51
NOTHING = 2.0**-80              # of an interval: a zero nearer to 0 than this is known well enough
SHORT, FARTHER = 4, 8        # of least steps, and how much farther the next one goes
SECTIONS, GOLDEN = 90, 0.3819660112501051


def zeros_between(function: Callable[..., np.ndarray], low: np.ndarray, high: np.ndarray, level: Any = 0.0,
                  known: Any = None) -> np.ndarray:
    """The zero of a function in each of the intervals at whose ends its signs differ, to rounding; or where it is at
    the level of each interval. known: its values at the ends, where they are.

    Inverse quadratic interpolation where three values stand for it, else halving (Chandrupatla 1997, Adv. Eng. Softw.
    28, 145); a step falls no nearer to an end than half of what is told apart, so that both ends close in, and the next
    one eight times as far where that was on the near side: as where rounding makes stairs of the function.
    """
    level, least = np.broadcast_to(level, low.shape), NOTHING * (high - low)
    a, b, found = high.copy(), low.copy(), (low + high) / 2
    fb, fa = (ends - level for ends in known or (function(b), function(a)))
    open_, share, step = np.arange(len(low)), np.full(len(low), 0.5), np.full(len(low), 0.5)
    for _ in range(ROUNDS):
        near = np.maximum(SAME * np.maximum(np.abs(a), np.abs(b)), least)
        wide = np.abs(b - a) > near
        found[open_] = (a + b) / 2
        open_, level, least, near, a, b, fa, fb, share, step = (
            part[wide] for part in (open_, level, least, near, a, b, fa, fb, share, step))
        if not len(open_):
            break
        trial = a + share * (b - a)
        f = np.nan_to_num(function(trial) - level, nan=0.0)
        same = np.sign(f) == np.sign(fa)
        c, fc = np.where(same, a, b), np.where(same, fa, fb)
        b, fb = np.where(same | (f == 0), b, a), np.where(same, fb, fa)
        a, fa, b = trial, f, np.where(f == 0, trial, b)
        share, short = _share(a, b, c, fa, fb, fc, step * near)
        step = np.where(short, FARTHER * step, step)
    result: np.ndarray = found
    return result


def _share(a: np.ndarray, b: np.ndarray, c: np.ndarray, fa: np.ndarray, fb: np.ndarray, fc: np.ndarray,
           step: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(how far from a to b the next place lies, whether that is next to one of them)."""
    with np.errstate(all="ignore"):
        place, height = (a - b) / (c - b), (fa - fb) / (fc - fb)
        share = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        smooth = (height**2 < place) & ((1 - height)**2 < 1 - place) & np.isfinite(share)
        edge = np.minimum(step / np.abs(b - a), 0.5)
    share = np.where(smooth, share, 0.5)
    return np.clip(share, edge, 1 - edge), np.minimum(share, 1 - share) < SHORT * edge


def maxima_between(function: Callable[..., np.ndarray], low: Any, high: "float | mpmath.mpf",
                   sections: int = SECTIONS) -> np.ndarray:
    """Where a function is largest in each of the intervals in which it has one maximum, by golden section."""
    for _ in range(sections if len(low) else 0):
        left, right = low + GOLDEN * (high - low), high - GOLDEN * (high - low)
        falls = function(left) >= function(right)
        low, high = np.where(falls, low, left), np.where(falls, right, high)
    found: np.ndarray = 0.5 * (low + high)
    return found
