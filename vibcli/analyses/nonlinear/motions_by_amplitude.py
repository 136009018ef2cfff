"""Many motions of a family at once, by their amplitudes: V and the signal are tabulated along the largest of them, and
the turning points l < r of the others follow by Newton's steps from the table, all together:

    V(l) = V(r)          max s − min s over l … r = 2A
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.nonlinear.family import FamilyOfMotions
from vibcli.analyses.nonlinear.well import EPS, GRID, Gain
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.bracketing import maxima_between

if TYPE_CHECKING:
    from vibcli.analyses.nonlinear.family import MotionOfFamily
    from vibcli.analyses.nonlinear.well import Well

STEPS = 20
NEAR = 1e-6         # of the reach: the slope of the signal is taken over it
SAME, ENOUGH = 4 * EPS, 1e-12       # of the reach: by so much the last step may move an end, the amplitude may differ


class _Side:
    """What V gains on one side of an equilibrium; `end`: the farthest place."""

    def __init__(self, well: "Well", bottom: float, end: float) -> None:
        places = {float(q) for q in np.linspace(bottom, end, GRID)} | set(well.breaks(*sorted((bottom, end))))
        self.well, self.sense = well, 1 if end > bottom else -1
        self.places = np.array(sorted(places))[::self.sense]
        self.rounding = well.rounding(end)
        gain = well.gain(self.places[:-1], np.diff(self.places), self.rounding)
        self.heights = np.concatenate(([0.0], np.cumsum(gain.value)))
        self.errors = np.concatenate(([0.0], np.cumsum(gain.error + EPS * np.abs(self.heights[1:]))))

    def rises(self) -> bool:
        """Does V grow all the way?"""
        return bool(np.all(np.diff(self.heights) > 0))

    def gain(self, q: np.ndarray) -> Gain:
        """V(q) − V(bottom)."""
        i = np.searchsorted(self.sense * self.places, self.sense * q, side="right") - 1
        last = self.well.gain(self.places[i], q - self.places[i], self.rounding)
        return Gain(self.heights[i] + last.value, self.errors[i] + last.error)

    def place(self, height: np.ndarray) -> np.ndarray:
        """About where V has gained so much."""
        found: np.ndarray = np.interp(np.sqrt(height), np.sqrt(self.heights), self.places)
        return found

    def inside(self, q: np.ndarray) -> np.ndarray:
        """The same places, moved to between the first one and the last."""
        found: np.ndarray = np.clip(q, *sorted((self.places[0], self.places[-1])))
        return found


class _Reach(NamedTuple):
    """How far a signal goes between two places, and by how much more as the left one, the right one grows."""

    size: np.ndarray
    by_left: np.ndarray
    by_right: np.ndarray


class _Signal:
    """`tops`: where it has a maximum or minimum between the ends of the largest motion."""

    def __init__(self, function: Callable[[np.ndarray], np.ndarray], left: float, right: float) -> None:
        self.function = function
        self.tops = np.concatenate([self._tops(sense, np.linspace(left, right, 2 * GRID)) for sense in (1, -1)])
        self.at_tops = self.function(self.tops)

    def _tops(self, sense: int, places: np.ndarray) -> np.ndarray:
        rises = sense * np.sign(np.diff(self.function(places)))
        moves = np.flatnonzero(rises)
        turns = np.flatnonzero((rises[moves[:-1]] > 0) & (rises[moves[1:]] < 0))
        return maxima_between(lambda q: sense * self.function(q), places[moves[turns]], places[moves[turns + 1] + 1])

    @np.errstate(invalid="ignore")      # where both are the same
    def reach(self, left: np.ndarray, right: np.ndarray) -> _Reach:
        """Between places l and r."""
        step = NEAR * (right - left)
        at_left, near_left, near_right, at_right = self.function(np.array([left, left + step, right - step, right]))
        within = (self.tops > left[:, None]) & (self.tops < right[:, None])
        most, least = (sense * np.max(np.column_stack((
            sense * at_left, sense * at_right, np.where(within, sense * self.at_tops, -np.inf))), axis=1)
            for sense in (1, -1))
        counts = np.zeros((2, len(left)))           # of both ends, shared where both are about the extreme
        for sense, extreme in ((1, most), (-1, least)):
            near = np.abs(np.array((at_left, at_right)) - extreme) <= NEAR * (most - least)
            counts += sense * near / np.maximum(1, near.sum(axis=0))
        slopes = counts * np.array((near_left - at_left, at_right - near_right)) / step
        return _Reach(most - least, *slopes)


class MotionsOfFamily(NamedTuple):
    """Their turning points, as rows q and bounds of its errors, and E − V at the equilibrium."""

    left: np.ndarray
    right: np.ndarray
    energy: np.ndarray


def motions_by_amplitude(family: FamilyOfMotions, signal: Callable[[np.ndarray], np.ndarray],
                         amplitudes: np.ndarray) -> MotionsOfFamily:
    """The motions in which a signal, a function of arrays of places, has these amplitudes; NoSuchAmplitude where none
    has."""
    i = int(np.argmax(amplitudes))
    largest = family.motion(signal, float(amplitudes[i]))
    ends, energies = _turning_points(family, signal, largest, amplitudes)
    for k in np.flatnonzero(np.isnan(ends).any(axis=(0, 1)) | (np.arange(len(amplitudes)) == i)):
        motion = largest if k == i else family.motion(signal, float(amplitudes[k]))
        ends[..., k], energies[k] = motion.ends, family.energy(motion)
    return MotionsOfFamily(*ends, energies)


def _turning_points(family: FamilyOfMotions, signal: Callable[[np.ndarray], np.ndarray], largest: "MotionOfFamily",
                    amplitudes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """([[l, bounds of its errors], [r, bounds]], E − V at the equilibrium); NaN where they are not found."""
    nothing = np.full((2, 2, len(amplitudes)), np.nan), np.full(len(amplitudes), np.nan)
    if len(amplitudes) == 1:
        return nothing
    sides = [_Side(family.well, family.bottom, end.q) for end in largest.ends]
    signal = _Signal(signal, *(end.q for end in largest.ends))
    top = min(side.heights[-1] for side in sides)
    levels = np.unique(np.concatenate([side.heights[side.heights <= top] for side in sides]))
    ends = [side.place(levels) for side in sides]
    sizes = signal.reach(*ends).size
    if not (all(side.rises() for side in sides) and np.all(np.diff(sizes) >= -NEAR * sizes[-1])):
        return nothing
    wanted = 2 * amplitudes
    ends = [np.interp(wanted, np.maximum.accumulate(sizes), row) for row in ends]
    for _ in range(STEPS):
        steps = _residual(sides, signal, wanted, ends).steps
        ends = [side.inside(q + step) for side, q, step in zip(sides, ends, steps, strict=True)]
        if not np.any(np.abs(steps) > SAME * (ends[1] - ends[0])):
            break
    return np.stack((ends, _residual(sides, signal, wanted, ends).errors), axis=1), sides[1].gain(ends[1]).value


class _Residual(NamedTuple):
    """Newton's steps of both turning points, and how well these are known."""

    steps: np.ndarray
    errors: np.ndarray


@np.errstate(all="ignore")          # what is not defined is not known
def _residual(sides: Sequence[_Side], signal: _Signal, wanted: np.ndarray, ends: list[np.ndarray]) -> _Residual:
    (fall, rise), (left, right) = (side.gain(q) for side, q in zip(sides, ends, strict=True)), ends
    reach, at_left, at_right = signal.reach(left, right), *(sides[0].well.force(q) for q in ends)
    apart, missing = fall.value - rise.value, wanted - reach.size
    size = at_left * reach.by_right + at_right * reach.by_left
    along = np.array((at_right, at_left)) * missing / size          # the family, to the amplitude wanted
    steps = along + np.array((-reach.by_right, reach.by_left)) * apart / size
    known = np.where(np.abs(missing) <= ENOUGH * wanted, 2 * EPS * (right - left), np.nan)
    errors = np.abs(along) + known
    errors[0] += (np.abs(apart) + fall.error + rise.error) / np.abs(at_left)
    return _Residual(steps, errors)
