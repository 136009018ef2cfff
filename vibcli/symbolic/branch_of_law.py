"""Where a law F(d) has a given force on its branch through d = 0: the first d at which it is reached while F rises all
the way. The place is bracketed on a grid of ratios, and found by Newton's steps with halvings to rounding."""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable

    Law = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]

GRID = 2.0 ** (np.arange(-256, 257) / 4)    # metres or radians
INNER, STEPS = 65, 200                      # places within a cell; halvings
LEVEL, JUMP = 1e-12, 1e-6                   # relative: a smaller fall is rounding; more between neighbours


class Reached(NamedTuple):
    """The place d, NaN where there is none; `most`: the largest force on the branch, and `where` (inf: in the limit)
    it has that; `jumps`: does F jump past the force there? `ends`: has it no value beyond?"""

    d: float
    most: float = np.inf
    where: float = np.inf
    jumps: bool = False
    ends: bool = False


def reached(law: "Law", force: float) -> Reached:
    """law(d): (F, F′) at an array d."""
    start = float(_values(law, np.zeros(1))[0][0])
    sense = 1.0 if force > start else -1.0
    if force == start:
        return Reached(0.0)

    def rising(d: np.ndarray) -> "tuple[np.ndarray, np.ndarray]":
        F, slope = _values(law, sense * d)
        return sense * F, slope

    found = _first(rising, np.concatenate(([0.0], GRID)), sense * force)
    return found._replace(d=sense * found.d, where=sense * found.where, most=sense * found.most)


def _values(law: "Law", d: np.ndarray) -> tuple[np.ndarray, ...]:
    with np.errstate(all="ignore"):
        return tuple(np.broadcast_to(part, d.shape) for part in law(d))


def _first(rising: "Law", places: np.ndarray, force: float) -> Reached:
    """Between the places, the first of which has less than the force."""
    cell, end = _cell(rising, places, force)
    if cell is not None:
        cell, end = _cell(rising, np.linspace(cell[0], cell[1], INNER), force)
    if cell is not None:
        return _zero(rising, *cell, force)
    if end is None:
        F, _ = rising(places)
        known = F[np.isfinite(F)]
        return Reached(np.nan, float(known.max()))
    top, most = _top(rising, *end)
    if most >= force:
        return _zero(rising, end[0], top, force)
    return Reached(np.nan, most, top, ends=not np.isfinite(rising(np.array([end[1]]))[0][0]))


def _cell(rising: "Law", places: np.ndarray,
          force: float) -> tuple[tuple[float, float] | None, tuple[float, float] | None]:
    """((a, b) with F(a) < force ≤ F(b), None), or (None, the first cell after which F falls or is not defined, if there
    is one)."""
    F, slope = rising(places)
    with np.errstate(invalid="ignore"):
        falls = ~(F[1:] - F[:-1] >= -LEVEL * np.abs(F[1:])) | (slope[1:] < 0)
    over, ends = np.flatnonzero(F[1:] >= force), np.flatnonzero(falls)
    if over.size and not (ends.size and ends[0] < over[0]):
        return (float(places[over[0]]), float(places[over[0] + 1])), None
    if not ends.size:
        return None, None
    return None, (float(places[max(ends[0] - 1, 0)]), float(places[ends[0] + 1]))


def _top(rising: "Law", low: float, high: float) -> tuple[float, float]:
    """(place, force) of the maximum in a cell, or of the last place where F is defined."""
    for _ in range(STEPS):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        F, slope = rising(np.array([middle]))
        rises = np.isfinite(F[0]) and slope[0] > 0
        low, high = (middle, high) if rises else (low, middle)
    return low, float(rising(np.array([low]))[0][0])


def _zero(rising: "Law", low: float, high: float, force: float) -> Reached:
    """Where F has the force, F(low) < force ≤ F(high)."""
    d = high
    for _ in range(STEPS):
        F, slope = (float(part[0]) for part in rising(np.array([d])))
        if force == F:
            return Reached(d)
        low, high = (d, high) if force > F else (low, d)
        trial = d - (F - force) / slope if slope > 0 else np.nan
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        d = trial if low < trial < high else middle
    ends = np.array([low, high])
    F, _ = rising(ends)
    best = int(np.argmin(np.abs(F - force)))
    return Reached(float(ends[best]), jumps=bool(abs(F[1] - F[0]) > JUMP * abs(force)))
