"""What is drawn in the phase plane of one degree of freedom: its equilibria, separatrices and orbits, and the motion
from the start of the scene. Of conservative scenes by level curves of the energy."""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.nonlinear.energy_levels import EnergyLevels, Orbit
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.nonlinear.equilibrium_kinds import StateEquilibrium

ORBIT, SEPARATRIX, INTO, OUT_OF, OWN, CYCLE = "orbit", "separatrix", "into", "out of", "own", "cycle"
SHELLS = 7              # of levels from the lowest equilibrium to the edge, about
BELOW = 2               # so much farther are they apart below all equilibria
TOO_NEAR = 0.3          # of the way from one shell to the next: a level so near to the own motion is left out


class StatePath(NamedTuple):
    """A line in the phase plane, in the order of time; `role`: what it is."""

    q: np.ndarray
    v: np.ndarray
    role: str


class Portrait(NamedTuple):
    """All of it; energies: those of the equilibria, over the lowest one, None where the forces have no potential."""

    equilibria: "Sequence[StateEquilibrium]"
    branches: Sequence[StatePath]
    energies: list[float] | None


def of_levels(levels: EnergyLevels, equilibria: "Sequence[StateEquilibrium]", start: tuple[float, float] | None,
              speed: float) -> list[StatePath]:
    """Of a conservative scene: level curves up to a speed at the lowest place."""
    rests = [levels.index(one.q) for one in equilibria]
    own = () if start is None else through(levels, start, rests)
    tops = [one.q for one in equilibria if one.is_top]
    found = [part for orbit in separatrices(levels, tops) for part in branches(orbit, SEPARATRIX)]
    found += [part for orbit in own for part in branches(orbit, OWN)]
    energy = None if start is None else levels.heights[levels.index(start[0])] + kinetic_energy(levels, start)
    base = base_of(levels, rests)
    for height in _shells(levels, base, rests, speed, energy):
        for orbit in levels.level(base, height - levels.heights[base]):
            found += branches(orbit, ORBIT)
    return found


def separatrices(levels: EnergyLevels, tops: Sequence[float]) -> list[Orbit]:
    """Those of the levels of places that end in one of these."""
    rests = [levels.index(q) for q in tops]
    found, left = [], list(rests)
    while left:
        i = left.pop(0)
        climbs, slack = levels.climbs(i), levels.slack(i)
        same = [k for k in rests if k == i or abs(climbs[k]) <= slack[k]]
        left = [k for k in left if k not in same]
        places = {float(levels.stops[k]) for k in same}
        found += [orbit for orbit in levels.level(i, 0.0, same) if places & {float(orbit.q[0]), float(orbit.q[-1])}]
    return found


def through(levels: EnergyLevels, start: tuple[float, float], rests: Sequence[int] = ()) -> list[Orbit]:
    """The orbit through a state; none where it rests. One that passes over the place at which it starts, and on its
    way a saddle, ends there."""
    i = levels.index(start[0])
    orbits = levels.level(i, kinetic_energy(levels, start), [k for k in rests if k != i])
    return [one for one in orbits if one.q[0] <= levels.stops[i] <= one.q[-1]]


def base_of(levels: EnergyLevels, rests: Sequence[int]) -> int:
    """The number of the stop that energies are counted from: the lowest equilibrium, else a low place."""
    if rests:
        return min(rests, key=lambda k: levels.heights[k])
    return int(np.argsort(levels.heights)[levels.heights.size // 20])


def kinetic_energy(levels: EnergyLevels, start: tuple[float, float]) -> float:
    """½ m q̇² at the start."""
    return 0.5 * float(levels.well.inertia(np.array(start[:1]))[0]) * start[1] ** 2


def branches(orbit: Orbit, role: str) -> list[StatePath]:
    """Both halves in the order of time, joined where the orbit turns."""
    q, v, back, low = orbit.q, orbit.v, orbit.q[::-1], -orbit.v[::-1]
    at_left, at_right = orbit.ends
    if at_right:
        return [StatePath(np.concatenate((q, back[1:])), np.concatenate((v, low[1:])), role)]
    if at_left:
        return [StatePath(np.concatenate((back, q[1:])), np.concatenate((low, v[1:])), role)]
    return [StatePath(q, v, role), StatePath(back, low, role)]


def _shells(levels: EnergyLevels, base: int, rests: Sequence[int], speed: float, own: float | None) -> list[float]:
    """Energies of the other orbits, counted as the heights are: between those of equilibria evenly in √E, as far below
    as above."""
    heights, ground = levels.heights, levels.heights[base]

    def root(energy: float) -> float:
        return math.copysign(math.sqrt(abs(energy - ground)), energy - ground)

    top = root(ground + 0.5 * float(levels.well.inertia(levels.stops[base:base + 1])[0]) * speed**2)
    marks = sorted({max(root(heights.min()), -top), *(root(heights[k]) for k in rests), top})
    marks = [a for a, b in zip(marks, [*marks[1:], math.inf], strict=True) if b - a > 1e-6 * top and a <= top]
    step = top / SHELLS
    found = []
    for a, b in pairwise(marks):
        count = max(1, round((b - a) / (step if b > 0 else BELOW * step)) - 1)
        found += [a + (b - a) * k / (count + 1) for k in range(1, count + 1)]
    if own is not None:
        found = [r for r in found if abs(r - root(own)) > TOO_NEAR * step]
    return [ground + math.copysign(r * r, r) for r in found]
