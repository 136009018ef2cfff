"""T = 2 ∫ √(m/(2(E − V))) dq between two turning points, in floats, with a bound of its error.

The way is cut where V bends or is stationary. On each piece from a to b the double exponential rule (Takahasi & Mori
1974) stands roots at the ends and broken powers at kinks:

    q = b − (b − a)/(1 + e^{π sinh u})          dq/du = (b − a) (π/4) cosh u / cosh²(½π sinh u)

E − V is added up from the nearer turning point, where a difference would lose its digits. The step is halved until
nothing changes.
"""

import math
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.nonlinear.well import EPS, Well
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.nonlinear.turning_points import TurningPoint

FARTHEST, STEP, ROUGH, FINEST = 3.9, 0.5, 0.25, 1 / 64
ENOUGH = 4 * EPS
SAMPLES = 20                # places at which the rounding of V is found
SHIFT = 1e-7                # of the reach: by so much the ends are moved to see what that does to the period


class PiecesOfWell(NamedTuple):
    """A row for each motion: the ends `a`, `b` of its pieces, E − V there with bounds of their errors; columns: the
    rounding of V and V′. Pieces that a motion does not reach have no length."""

    a: np.ndarray
    b: np.ndarray
    drop: np.ndarray
    error: np.ndarray
    rounding: np.ndarray

    def of(self, rows: np.ndarray) -> "PiecesOfWell":
        """Those of some motions."""
        return PiecesOfWell(self.a[rows], self.b[rows], self.drop[:, rows], self.error[:, rows], self.rounding[:, rows])


def period_between(well: Well, left: "TurningPoint", right: "TurningPoint") -> tuple[float, float]:
    """(period [s], bound of its error) of the motion between its turning points."""
    periods, errors = periods_between(well, *(np.array([[end.q], [end.error]]) for end in (left, right)))
    return float(periods[0]), float(errors[0])


def periods_between(well: Well, left: np.ndarray, right: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The same of many motions in one well, their turning points as rows q and bounds of their errors."""
    breaks = np.array(well.breaks(left[0].min(), right[0].max()))
    rounding = _rounding(well, left[0], right[0], breaks)
    time, error, roughly = _times(well, _pieces(well, left[0], right[0], breaks, rounding), FINEST)
    shift = SHIFT * (right[0] - left[0])
    for ends, end in (((left[0] - shift, right[0]), left), ((left[0], right[0] + shift), right)):
        if end[1].any():
            *_, moved = _times(well, _pieces(well, *ends, breaks, rounding), ROUGH)
            error += np.where(end[1] > 0, np.abs(moved - roughly) / shift * end[1], 0.0)
    return 2 * time, 2 * error


def _rounding(well: Well, left: np.ndarray, right: np.ndarray, breaks: np.ndarray) -> np.ndarray:
    """The largest that of V, and of V′, in each motion; columns."""
    at_ends = np.maximum(_rounding_at(well, left), _rounding_at(well, right))
    at_breaks = np.array([well.rounding(q) for q in breaks.tolist()]).reshape(-1, 2)
    within = (breaks > left[:, None]) & (breaks < right[:, None])
    most = np.where(within[..., None], at_breaks, 0.0).max(axis=1, initial=0.0)
    found: np.ndarray = np.maximum(at_ends, most).T[..., None]
    return found


def _rounding_at(well: Well, places: np.ndarray) -> np.ndarray:
    """(of V, of V′) at many places in rows: the larger one of those at the nearest of some on either side."""
    some = np.unique(np.append(np.sort(places)[::1 + len(places) // SAMPLES], places.max()))
    known = np.array([well.rounding(q) for q in some.tolist()])
    i = np.searchsorted(some, places)
    return np.asarray(np.maximum(known[i], known[np.maximum(i - 1, 0)]))


def _pieces(well: Well, left: np.ndarray, right: np.ndarray, breaks: np.ndarray, rounding: np.ndarray) -> PiecesOfWell:
    places = np.column_stack((left, np.clip(breaks, left[:, None], right[:, None]), right))
    gain = well.gain(places[:, :-1], np.diff(places), rounding)
    from_left = _added_up(-gain.value, gain.error)
    from_right = _added_up(gain.value[:, ::-1], gain.error[:, ::-1])[..., ::-1]
    drop, error = np.where(from_left[1] <= from_right[1], from_left, from_right)
    return PiecesOfWell(places[:, :-1], places[:, 1:], np.array((drop[:, :-1], drop[:, 1:])),
                        np.array((error[:, :-1], error[:, 1:])), rounding)


def _added_up(steps: np.ndarray, errors: np.ndarray) -> np.ndarray:
    """(sums from 0, bounds)."""
    def total(parts: np.ndarray) -> np.ndarray:
        return np.pad(np.cumsum(parts, axis=1), ((0, 0), (1, 0)))

    sums = total(steps)
    return np.array((sums, total(errors + EPS * np.abs(sums[:, 1:]))))


def _times(well: Well, pieces: PiecesOfWell, finest: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(∫ √(m/(2(E − V))) dq, bound, the same by the step ROUGH) of each motion."""
    total, error, bound = np.zeros((3, len(pieces.a)))
    found, left, roughly = np.full(len(pieces.a), np.inf), np.arange(len(pieces.a)), None
    step, first, apart = STEP, 0.0, STEP
    while left.size:
        value, lost = _sums(well, pieces.of(left), first, apart)
        total[left] += value
        error[left] += lost
        before, now = found[left], total[left] * step
        found[left] = now
        with np.errstate(invalid="ignore"):
            change = np.abs(now - before)
        bound[left] = change + error[left] * step + 8 * EPS * now
        left = left[~((change <= ENOUGH * now) | (step <= finest) | ~np.isfinite(now))]
        roughly = found.copy() if step == ROUGH else roughly
        first, apart, step = step / 2, step, step / 2
    return found, bound, found if roughly is None else roughly


def _sums(well: Well, pieces: PiecesOfWell, first: float, apart: float) -> tuple[np.ndarray, np.ndarray]:
    """Sums of the integrand at u = ±first, ±(first + apart) …, and of its error, over all pieces of each motion."""
    share, weight, from_left = (row[:, None, None] for row in _nodes(first, apart))
    way = pieces.b - pieces.a
    start = np.where(from_left, pieces.a, pieces.b)
    inward = np.where(from_left, share, -share) * way
    gain = well.gain(start, inward, pieces.rounding)
    drop = np.where(from_left, *pieces.drop) - gain.value
    lost = np.where(from_left, *pieces.error) + gain.error
    m = well.inertia(start + inward)
    with np.errstate(all="ignore"):
        values = np.where(drop > 0, weight * way * np.sqrt(m / (2 * drop)), 0.0)
        errors = np.where(drop > lost, values * lost / (2 * drop), np.where(way > 0, np.inf, 0.0))
    return values.sum(axis=(0, 2)), errors.sum(axis=(0, 2))


@cache
def _nodes(first: float, apart: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(share of the way between the place and the nearer end, dq/du over the way, is the left end the nearer?)"""
    count = int((FARTHEST - first) / apart + 1e-9) + 1
    u = first + apart * np.arange(count)
    u = np.concatenate((-u[::-1], u[1:] if not first else u))
    far = np.exp(-math.pi * np.sinh(np.abs(u)))
    return far / (1 + far), math.pi * np.cosh(u) * far / (1 + far) ** 2, u < 0
