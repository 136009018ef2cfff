"""The conditions of equilibrium r(q) = 0 as a function to be searched, in coordinates without dimension.

z = q/D, D being 1 for angles and the size of the figure for lengths; F = D r/E and J = ∂F/∂z = D K D/E, E an energy
typical of the scene. So the search does not depend on units.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from operator import mul
from statistics import median
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.linearisation import residual_terms
from vibcli.numerics.few_unknowns import shortest_solution

if TYPE_CHECKING:
    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.mechanics.system import MechanicalSystem

HUGE, MOST_CLOSED, JUMP = 1e140, 1000, 1.5
BALANCED, QUIET = 1e-14, 1e-9      # of the terms that make r; of the forces elsewhere
FAINT, SHORT, TINY = 2.0**-49, 1e-3, 1e-9      # of the forces elsewhere; of the size of the figure, both


class Place:
    """A position `where` with F, J, and the magnitudes of the terms that each row of F was added from, all in lists of
    floats: of few coordinates arrays take several times as long. z: the position as an array."""

    __slots__ = ("F", "J", "_z", "size", "where")

    def __init__(self, where: list[float], F: list[float], J: list[list[float]], size: list[float]) -> None:
        self.where, self.F, self.J, self.size = where, F, J, size
        self._z: np.ndarray | None = None

    @property
    def z(self) -> np.ndarray:
        if self._z is None:
            self._z = np.array(self.where)
        return self._z

    @property
    def largest(self) -> float:
        """The largest |Fᵢ|."""
        return max(map(abs, self.F))

    @property
    def residual(self) -> float:
        """The largest |Fᵢ| relative to its terms: the forces, and what moving q by its own rounding makes of them."""
        return _largest(self.F, self.size)

    def step(self, rank: float = 1e-14) -> list[float]:
        """The step of Newton's method, the shortest of all that do where J is singular to `rank`."""
        return shortest_solution(self.J, [-f for f in self.F], rank)


def _largest(F: Sequence[float], size: Iterator[Any] | Sequence[float]) -> float:
    return max((abs(f) / s for f, s in zip(F, size, strict=True) if s > 0), default=0.0)


class TooMuch(Exception):
    """The search has found more than can be listed."""


class Forces:
    """r(q) and K(q) of a scene along n of its coordinates, the others left as drawn, at places z of the shape (n,).
    `periodic`: flags of the angles after a turn of which nothing has changed; `work`: what counts the places that are
    looked at."""

    def __init__(self, numeric: "NumericSystem", names: Sequence[str]) -> None:
        self.numeric, self.names, self.work = numeric, list(names), numeric.work
        self.rows = [numeric.scene.coordinates.index(name) for name in self.names]
        self.angle = np.array([not numeric.system.dimension(name) for name in self.names], bool)
        self.open = np.array([any(base.startswith("?") for base in numeric.spec.dimensions.of(name))
                              for name in self.names], bool)
        self.D = np.where(self.angle | self.open, 1.0, typical_length(numeric) or 1.0)
        self.scale: list[float] = self.D.tolist()
        self._scaled = list(zip(self.rows, self.scale, strict=True))
        self.E, self.typical = 1.0, [0.0] * len(self.names)
        self.periodic = np.zeros(len(self.names), bool)
        self.looped = numeric.scene.resting.loops is not None
        self.jumps = {name: JUMP * (1.0 if not numeric.system.dimension(name) else typical_length(numeric) or 1.0)
                      for name in numeric.drawn_floats} if self.looped else {}
        self.closed, self.closed_at = [], np.zeros((MOST_CLOSED, len(self.names)))
        self.know(numeric.drawn_floats)

    def know(self, position: Mapping[str, float]) -> None:
        """Keep a position ({coordinate: float}) whose loops are closed."""
        if len(self.closed) < MOST_CLOSED:
            self.closed_at[len(self.closed)] = self.vector(position)
            self.closed.append(position)

    def vector(self, values: Mapping[str, float]) -> np.ndarray:
        """z of {coordinate: number}: an array of one number for each coordinate."""
        return np.array([values[name] for name in self.names], dtype=float) / self.D

    def position(self, z: Sequence[float] | np.ndarray) -> dict[str, float]:
        """{coordinate: float} of z, loops closed on the way there from the nearest position known to be closed."""
        moved = {name: float(x * d) + 0.0 for name, x, d in zip(self.names, z, self.scale, strict=True)}
        drawn = self.numeric.drawn_floats
        if not self.looped:
            return {**drawn, **moved}
        start = self.closed[int(np.argmin(np.abs(self.closed_at[:len(self.closed)] - z).max(axis=1)))]
        found = self.numeric.closed(start, {**drawn, **moved})
        if any(abs(found[name] - start[name]) > size for name, size in self.jumps.items()):
            raise PhysicsError("the loops of this scene jump to another way of closing")
        self.know(found)
        return found

    def at(self, z: Sequence[float] | np.ndarray) -> Place:
        """The Place at z, None where the forces are not defined."""
        self.work.step()
        try:
            r, sizes, K = self.numeric.static_forces.at(self.position(z))
        except (PhysicsError, ArithmeticError, ValueError):
            return None
        rows, E, place = self._scaled, self.E, list(map(float, z))
        F = [r[i] * d for i, d in rows]
        J = [[K[i][j] * (d * e) for j, e in rows] for i, d in rows]
        if not all(sum(map(abs, part)) < HUGE for part in (F, *J)):       # NaN is not
            return None
        moved = [1.0 + abs(x) for x in place]
        size = [sizes[i] * d + sum(map(mul, map(abs, row), moved)) for (i, d), row in zip(rows, J, strict=True)]
        return Place(place, [f / E for f in F], [[x / E for x in row] for row in J], [s / E for s in size])

    def balanced(self, place: Place) -> bool:
        """Is the residual that of rounding, and small beside the forces elsewhere (at a pole of F it is not)?

        Of its own terms; or of the forces elsewhere, where Newton's step tells a zero from a force that fades away: the
        terms of a potential written out are not known apart, and at a multiple zero they vanish too.
        """
        if not place.largest <= QUIET:
            return False
        if place.residual <= self.rounding:
            return True
        faint = _largest(place.F, self.typical)
        return faint <= self.rounding and max(map(abs, place.step())) <= (SHORT if faint <= FAINT else TINY)

    def residual(self, place: Place) -> float:
        """The largest |Fᵢ| relative to its terms there or at other places, whichever are larger."""
        return _largest(place.F, map(max, place.size, self.typical))

    @property
    def rounding(self) -> float:
        return max(BALANCED, 4 * len(self.D) * 2.0**-52)

    def learn_periods(self) -> None:
        """Set which angles are periodic, from two places near the drawn one; in a scene without units what has a period
        is taken for an angle."""
        places = [place for place in map(self.at, near_drawn(self, 2)) if place is not None]
        for i in np.flatnonzero(self.angle | self.open):
            turned = np.zeros(len(self.D))
            turned[i] = math.tau
            self.periodic[i] = bool(places) and all(self._same(place, turned) for place in places)
        self.angle |= self.open & self.periodic

    def _same(self, place: Place, step: np.ndarray) -> bool:
        other = self.at(place.z + step)
        return other is not None and all(
            abs(f - g) <= 1e-12 * size for f, g, size in zip(other.F, place.F, place.size, strict=True))

    def learn_sizes(self, points: Iterable[np.ndarray]) -> None:
        """Set E and the typical size of the terms of each row, from places at some points."""
        known = [place for place in map(self.at, points) if place is not None]
        largest = [max(abs(x) for part in (place.F, *place.J) for x in part) for place in known]
        if any(largest):
            self.E = median(largest) or max(largest)
            self.typical = [median(sizes) / self.E for sizes in zip(*(place.size for place in known), strict=True)]

    def gap(self, one: np.ndarray, other: np.ndarray) -> np.ndarray:
        """one − other, of periodic angles the shorter way round."""
        d = one - other
        found: np.ndarray = np.where(self.periodic, d - math.tau * np.round(d / math.tau), d)
        return found


def near_drawn(forces: Forces, count: int) -> list[np.ndarray]:
    """Some points z near the drawn position, the same at every run."""
    generator = np.random.default_rng(3)
    z = forces.vector(forces.numeric.drawn_floats)
    return [z + generator.uniform(-0.9, 0.9, len(z)) for _ in range(count)]


def idle(numeric: "NumericSystem") -> list[str]:
    """The coordinates on which no force depends and along which none acts: near the drawn position, and anywhere (a
    force with a clearance may begin farther off)."""
    forces = Forces(numeric, numeric.scene.coordinates)
    found = np.array([not _is_felt(numeric.system, row) for row in range(len(forces.names))], bool)
    for place in map(forces.at, near_drawn(forces, 4)):
        if place is not None:
            found &= ~np.any(place.J, axis=0) & (np.array(place.size) == 0)
    return [name for name, free in zip(forces.names, found, strict=True) if free]


def _is_felt(system: "MechanicalSystem", row: int) -> bool:
    """Does a coordinate stand in a condition of equilibrium, or has it one of its own? Of linear equations, and where
    loops are closed, places near the drawn one tell."""
    if system.scene.loops is not None or (system.is_linear and not system.scene.table.called):
        return False
    terms = residual_terms(system.linearisation)
    return any(not term.is_zero for term in terms[row]) or any(
        term.mask & system.scene.q[row].mask for row_terms in terms for term in row_terms)


def typical_length(numeric: "NumericSystem") -> float:
    """The size of the figure in metres, or where nothing has a place the largest length given; 0 if there is none."""
    from vibcli.base.units import LENGTH

    given = [abs(numeric.floats[name]) for name in numeric.spec.parameters
             if numeric.spec.dimensions.of(name) == LENGTH and name in numeric.floats]
    return numeric.figure_size or max(given, default=0.0)
