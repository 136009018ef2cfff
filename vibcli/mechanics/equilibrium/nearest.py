"""The equilibrium nearest to a place that is named, stable or not, in the scaled coordinates z of the forces.

Newton's method and the way down from the place give a first one; within its distance others are searched: one
coordinate is scanned, of several Newton's method starts from further points of a box that shrinks with each nearer one.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.equilibrium import multistart, one_coordinate
from vibcli.mechanics.equilibrium.distinct_roots import Found
from vibcli.mechanics.equilibrium.equilibrium import Equilibrium, find_equilibrium
from vibcli.mechanics.equilibrium.families import SINGULAR, free_directions, null_directions
from vibcli.mechanics.equilibrium.newton import settled, zero_from
from vibcli.mechanics.equilibrium.scaled_forces import Forces, Place
from vibcli.mechanics.nonsmooth import KINKED

if TYPE_CHECKING:
    from vibcli.mechanics.numeric_system import NumericSystem

WORK, STARTS, SAMPLES = 20_000, 24, 12         # evaluations; starts and samples for each coordinate
FIRST, WIDEST, FAR, FINEST = 1.0, 16.0, 1e6, 1 / 16
SAME = 1e-9


def nearest_equilibrium(numeric: Any, start: Any) -> Equilibrium:
    """The Equilibrium nearest to `start` ({coordinate: float}); PhysicsError where none is found."""
    if numeric.system.is_linear and not numeric.scene.table.called.intersection(KINKED):
        return _of_linear_forces(numeric, start)._replace(start=start)
    search = _Nearest(numeric, start)
    refusal, fallen = None, None
    try:
        fallen = find_equilibrium(numeric, start)
    except PhysicsError as error:
        refusal = error
    with numeric.work.task("the search for the nearest equilibrium", WORK) as task, task.kept():
        search.run(fallen)
    if search.best is None and fallen is None:
        raise refusal
    return search.found(fallen)


def _of_linear_forces(numeric: "NumericSystem", start: dict[str, float]) -> Equilibrium:
    try:
        return find_equilibrium(numeric, start)
    except PhysicsError:
        from vibcli.mechanics.equilibrium.rest_in_digits import rest_in_digits

        place = rest_in_digits(numeric, held=False)
        if place is None:
            raise
        return Equilibrium(place, False, 0.0)


class _Nearest:
    """The nearest place in equilibrium met so far, `best`."""

    def __init__(self, numeric: "NumericSystem", start: dict[str, float]) -> None:
        self.numeric, self.start = numeric, start
        self.forces = forces = Forces(numeric, numeric.scene.coordinates)
        self.origin = forces.vector(start)
        forces.know(start)
        forces.learn_periods()
        n = len(self.origin)
        forces.learn_sizes(self.origin + 2 * fractions - 1 for fractions in multistart.spread(n, SAMPLES * n))
        self.best: Any = None

    def found(self, fallen: Equilibrium) -> Equilibrium:
        """The Equilibrium at the nearest place, `fallen` where there is none; the drawn position to the last digit
        where it is that."""
        forces, place = self.forces, self.best
        if place is None:
            return fallen._replace(start=self.start)
        if self.numeric.drawn_numbers is not None:
            drawn = forces.at(forces.vector(self.numeric.drawn_floats))
            if drawn is not None and Found(forces, ()).same(place, drawn):
                return Equilibrium(self.numeric.drawn_floats, True, forces.residual(drawn), start=self.start)
        return Equilibrium(forces.position(place.z), False, forces.residual(place), start=self.start)

    def run(self, fallen: Equilibrium) -> None:
        """Search; `fallen`: the Equilibrium further down, or None."""
        here = self.forces.at(self.origin)
        if here is not None and self.forces.balanced(here):
            self.best = here
            return
        self.take(zero_from(self.forces, self.origin, (self.origin - FAR, self.origin + FAR)))
        if fallen is not None:
            place = self.forces.at(self.forces.vector(fallen.values))
            self.take(None if place is None else settled(self.forces, place))
        radius = FIRST if self.best is None else self.away(self.best)
        while radius <= max(WIDEST, FIRST if self.best is None else self.away(self.best)):
            (self.scan if len(self.origin) == 1 else self.sow)(radius)
            if self.best is not None:
                return
            radius *= 2

    def away(self, place: Place) -> float:
        return float(np.linalg.norm(place.z - self.origin))

    def take(self, place: Any) -> None:
        """Keep a place in equilibrium if it is nearer than what is known, moved along its line if it lies on one."""
        if place is None:
            return
        z = self.origin + self.forces.gap(place.z, self.origin)
        if not np.array_equal(z, place.z):
            turned = self.forces.at(z)
            place = None if turned is None else settled(self.forces, turned)
        place = None if place is None else self.along(place)
        if place is not None and (self.best is None or self.away(place) < self.away(self.best)):
            self.best = place

    def along(self, place: Place) -> Place:
        """The nearest place of the line of equilibria to which a place belongs; itself where it stands alone."""
        if not len(free_directions(self.forces, place)):
            return place
        for _ in range(STARTS):
            rows = null_directions(place)
            step = rows.T @ (rows @ (self.origin - place.z))
            there = self.forces.at(place.z + step)
            there = None if there is None else settled(self.forces, there, SINGULAR)
            if there is None or not self.away(there) < self.away(place) - SAME:
                break
            place = there
        return place

    def scan(self, radius: float) -> None:
        """All places of one coordinate within a distance."""
        (z,) = self.origin
        for place, stretch in one_coordinate.zeros(self.forces, z - radius, z + radius, FINEST):
            self.take(place if stretch is None else self.forces.at(np.clip(self.origin, *stretch)))

    def sow(self, radius: float) -> None:
        """Newton's method from points of a box about the start that is as wide as the nearest place is far."""
        n = len(self.origin)
        for fractions in multistart.spread(n, STARTS * n):
            if self.best is not None:
                radius = min(radius, self.away(self.best))
            self.take(zero_from(self.forces, self.origin + radius * (2 * fractions - 1),
                                (self.origin - 2 * radius, self.origin + 2 * radius)))
