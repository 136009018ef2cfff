"""The zeros that a search has met: each once, within the box, isolated or as a member of a family."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from vibcli.mechanics.equilibrium.families import Family, free_directions
from vibcli.mechanics.equilibrium.newton import settled
from vibcli.mechanics.equilibrium.scaled_forces import Forces, Place, TooMuch

MOST, NEAR, SAME = 200, 1e-2, 1e-9
BETWEEN = (0.31, 0.69)         # not the middle, where a third zero may lie


class Found:
    """`isolated` places and `families`; `met`: how many searches ended at one of them."""

    def __init__(self, forces: Forces, box: Sequence[np.ndarray]) -> None:
        self.forces, self.box, self.isolated, self.families, self.met = forces, box, [], [], 0

    @property
    def count(self) -> int:
        return len(self.isolated) + len(self.families)

    @property
    def full(self) -> bool:
        """Are there as many as can be listed?"""
        return self.count >= MOST

    def add(self, place: Any) -> bool:
        """Keep a zero; True if it lies in the box and is new."""
        place = self._in_box(place)
        if place is None or self.holds(place):
            return False
        rows = free_directions(self.forces, place)
        if len(rows):
            self.families.append(Family(place, rows))
        else:
            self.isolated.append(place)
        if self.full:
            raise TooMuch
        return True

    def meet(self, place: Place) -> None:
        """Keep the zero at which a search from a further start ended."""
        self.add(place)
        self.met += 1

    def holds(self, place: Place) -> bool:
        """Is a zero one of these?"""
        return any(self.same(place, other) for other in self.isolated) or any(
            family.holds(self.forces, place) for family in self.families)

    def _in_box(self, place: Place) -> Place | None:
        """The place, its periodic angles turned into the box; None if it lies outside."""
        low, high = self.box
        turns = np.where(self.forces.periodic, np.ceil((place.z - high) / math.tau - 1e-12), 0.0)
        z, slack = place.z - math.tau * turns, 1e-9 * (high - low)
        if np.any(z < low - slack) or np.any(z > high + slack):
            return None
        if not turns.any():
            return place
        turned = self.forces.at(z)
        return None if turned is None else settled(self.forces, turned)

    def same(self, place: Place, other: Place) -> bool:
        """Are two zeros one: at one place, or so near to one another that F vanishes between them too?"""
        d = self.forces.gap(place.z, other.z)
        far = float(np.abs(d).max())
        if far <= SAME or far > NEAR:
            return far <= SAME
        between = [self.forces.at(other.z + fraction * d) for fraction in BETWEEN]
        return all(place is not None and self.forces.balanced(place) for place in between)
