"""The family of free motions of one conservative degree of freedom about an equilibrium, one for each amplitude.

The amplitude of a signal is half its range in the motion. The family ends at the separatrix, where the motion comes
to rest on a top of V.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.nonlinear.turning_points import TurningPoint, turning_point
from vibcli.analyses.nonlinear.well import EPS, GRID, Well
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.bracketing import maxima_between

if TYPE_CHECKING:
    from vibcli.symbolic.compiled_arrays import Compiled
    from vibcli.symbolic.node import Node

STEPS, DOUBLINGS = 60, 60
SMALL = 2.0**-20        # of the scale of a place: so far the forces next to an equilibrium are looked at
TOUCHES = 2.0**-40      # of the largest force: less is none


class MotionOfFamily(NamedTuple):
    """A motion by its turning points, and the range of a signal in it; `at_ends`: is an extreme of the signal reached
    at the left one, and at the right one?"""

    ends: tuple[TurningPoint, TurningPoint]
    size: float
    at_ends: tuple[bool, bool]


class NoSuchAmplitude(PhysicsError):
    """No motion of a family has an amplitude; `largest`: what the amplitudes tend to, None where it is not known."""

    def __init__(self, largest: float | None) -> None:
        super().__init__("no free motion about this equilibrium has this amplitude", "ask for a smaller one")
        self.largest = largest


class FamilyOfMotions:
    """`bottom`: the equilibrium; unit: a length of the size of the scene."""

    def __init__(self, well: Well, bottom: float, unit: float) -> None:
        self.well, self.bottom = well, bottom
        self.unit = max(abs(bottom), unit)
        for side in (-1, 1):
            place = bottom + side * SMALL * self.unit
            force, size = well.force_at(place), well.rounding(place)[1]
            if side * force < -size:
                raise PhysicsError("this equilibrium is not stable: there are no free vibrations about it",
                                   "ask about another one, by its number as last index")

    def motion(self, signal: Callable[[np.ndarray], np.ndarray], amplitude: float) -> MotionOfFamily:
        """The motion in which a signal, a function of arrays of places, has an amplitude; NoSuchAmplitude where none
        has."""
        wanted = 2 * amplitude
        low, high, place, found = self.bottom, None, None, None
        step = min(self.unit, amplitude) if amplitude < self.unit else self.unit
        for _ in range(DOUBLINGS):
            place = self.bottom + step
            found = self._range(signal, place)
            if found is None or found.size >= wanted:
                high = place
                break
            low, step = place, 2 * step
        if high is None:
            raise NoSuchAmplitude(None)
        return self._solved(signal, wanted, low, high, found)

    def _solved(self, signal: Callable[[np.ndarray], np.ndarray], wanted: float, low: float, high: float,
                found: MotionOfFamily | None) -> MotionOfFamily:
        """The motion between two right ends, by Newton's steps that halve where they leave the bracket."""
        place = high
        for _ in range(STEPS):
            if found is None or found.size > wanted:
                high = place
            else:
                low = place
            trial = 0.5 * (low + high)
            if found is not None:
                slope = self._growth(signal, found)
                newton = place - (found.size - wanted) / slope if slope else trial
                if found.size == wanted or (slope and abs(newton - place) <= 2 * EPS * abs(newton - self.bottom)):
                    return self._known(signal, found, wanted)
                trial = newton if low < newton < high else trial
            if trial in (low, high):
                break
            place, found = trial, self._range(signal, trial)
        last = self._range(signal, low) if found is None else found
        noise = last and float(self._slopes(signal, last)[0]) * last.ends[0].error
        if last is None or abs(last.size - wanted) > 1e-12 * wanted + noise:
            raise NoSuchAmplitude(last and last.size / 2)
        return self._known(signal, last, wanted)

    def energy(self, motion: MotionOfFamily) -> float:
        """E − V at the equilibrium."""
        right = motion.ends[1].q
        stops = np.array([self.bottom, *self.well.breaks(self.bottom, right), right])
        return float(self.well.gain(stops[:-1], np.diff(stops), self.well.rounding(right)).value.sum())

    def _range(self, signal: Callable[[np.ndarray], np.ndarray], right: float) -> MotionOfFamily | None:
        """That of the motion that comes to rest there; None where it is none of the family."""
        if not self._climbs(self.bottom, right, 1):
            return None
        try:
            left = turning_point(self.well, right, 0.0, -1)
        except PhysicsError:
            return None
        if left.q >= self.bottom or not self._climbs(left.q, self.bottom, -1):
            return None
        most, least = (_most(signal, left.q, right, sense) for sense in (1, -1))
        return MotionOfFamily((left, TurningPoint(right, 0.0)), most[0] + least[0],
                     (-1 in (most[1], least[1]), 1 in (most[1], least[1])))

    def _climbs(self, low: float, high: float, side: int) -> bool:
        """Does V only rise as it leaves the bottom, where the force itself may jump?"""
        places = np.linspace(low, high, GRID)
        force = side * self.well.force(places[1:] if side > 0 else places[:-1])
        return bool(np.all(force >= -TOUCHES * np.abs(force).max())) and bool(force[0 if side < 0 else -1] > 0)

    def _known(self, signal: Callable[[np.ndarray], np.ndarray], found: MotionOfFamily,
               wanted: float) -> MotionOfFamily:
        """Its ends as well as the amplitude tells them."""
        (left, right), missing = found.ends, abs(found.size - wanted)
        at_right = 2 * EPS * (right.q - left.q) + (missing / self._growth(signal, found) if missing else 0.0)
        at_left = at_right * max(1.0, self._follows(found))
        return found._replace(ends=(left._replace(error=left.error + at_left), right._replace(error=at_right)))

    def _growth(self, signal: Callable[[np.ndarray], np.ndarray], found: MotionOfFamily) -> float:
        """How the range grows with the right end."""
        at_left, at_right = self._slopes(signal, found)
        return float(at_right + at_left * self._follows(found))

    def _follows(self, found: MotionOfFamily) -> float:
        """How far the left end goes as the right one does."""
        at_left, at_right = (abs(self.well.force_at(end.q)) for end in found.ends)
        return at_right / at_left if at_left else 0.0

    def _slopes(self, signal: Callable[[np.ndarray], np.ndarray], found: MotionOfFamily) -> np.ndarray:
        """Those of the signal at the ends that count, without signs."""
        left, right = (end.q for end in found.ends)
        step = 1e-6 * (right - left)
        values = signal(np.array([left, left + step, right - step, right]))
        return np.abs([values[1] - values[0], values[3] - values[2]]) / step * found.at_ends


def _most(signal: Callable[[np.ndarray], np.ndarray], low: float, high: float, sense: int) -> tuple[float, int]:
    """(the largest value of a signal, or of its negative, between two places, -1, 0 or 1: at the left one, on the way,
    at the right one)."""
    places = np.linspace(low, high, GRID)
    values = sense * signal(places)
    i = int(values.argmax())
    if 0 < i < GRID - 1:
        top = maxima_between(lambda q: sense * signal(q), places[i - 1:i], places[i + 1:i + 2])
        return float(sense * signal(np.atleast_1d(top))[0]), 0
    return float(values[i]), 1 if i else -1


def rests_between(well: Well, place: float) -> bool:
    """Do the forces beside a place drive back to it from both sides?"""
    step = SMALL * (abs(place) or 1.0)
    left, right = well.force(np.array([place - step, place + step]))
    return bool(left < 0 < right)


def function_of_place(well: Well, compiled: "Compiled", node: "Node") -> Callable[[np.ndarray], np.ndarray]:
    """The signal of an expression of the coordinate, as a function of arrays of places; PhysicsError where the speed is
    in it."""
    if node.mask & ~well.q.mask:
        raise PhysicsError("the amplitude of a family of free motions is that of a displacement or a spring's force",
                           "ask for a function of the places alone, without rates")

    def values(q: np.ndarray) -> np.ndarray:
        flat = q.ravel()
        found, = compiled(np.zeros(flat.size), flat.reshape(1, -1), np.zeros((1, flat.size)))
        return np.broadcast_to(found, flat.shape).reshape(q.shape)

    return values
