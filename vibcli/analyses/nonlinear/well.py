"""V and m(q) of one conservative degree of freedom, ½ m(q) q̇² + V(q) = E, in floats and with bounds of their rounding.

What V gains on a way is found twice: by Gauss's rule from V′, which loses nothing on short ways, and as a difference
of V, which stands powers that are broken at a kink; of the two each value takes the one with the smaller bound.
"""

from collections.abc import Callable, Mapping
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.polynomial.legendre import leggauss

from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.energies import effective_potential
from vibcli.mechanics.equations_of_motion import dynamics
from vibcli.numerics.bracketing import zeros_between
from vibcli.symbolic.compiled_arrays import Compiled
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.kinks import kinks_of
from vibcli.symbolic.running_errors import Rounded, RunningErrors, error_in

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

EPS = 2.0**-52
FINE, COARSE = leggauss(20), leggauss(10)
PLACES = 0.5 * (1 + np.concatenate((FINE[0], COARSE[0])))   # of both rules, as shares of the way
GRID = 129              # places of a range between which V′ and what bends change their sign
ROUGH = 1e-3            # of V′: two rules that differ by more do not know it
LOOKS = 2               # at ever nearer places, for where V is stationary


class Gain(NamedTuple):
    """What V gains on ways, and a bound of its error; arrays of the shape of the ways."""

    value: np.ndarray
    error: np.ndarray


class Well:
    """A scene of one coordinate with numbers for its parameters. `bends`: the arguments of |u|, sign u, min … in V and
    m, as nodes; `V`: what stands for the potential, where that is not the one of the scene at rest."""

    def __init__(self, scene: "Scene", floats: Mapping[str, float], V: "Node | None" = None) -> None:
        self.q, M = scene.q[0], dynamics(scene).M[0, 0]
        V = effective_potential(scene) if V is None else V
        self.nodes, self.floats = (V, M), floats
        self.slope = gradient(V).get(self.q, scene.table.zero)
        self.bends = kinks_of((V, M, self.slope), self.q)
        slopes = [gradient(u)[self.q] for u in self.bends]
        self.ending = scene.endings(floats)
        self._potential = Compiled(scene, floats, None, [V])
        self._bends = Compiled(scene, floats, None, [self.slope, *self.bends, *slopes]) if self.bends else None
        self._errors = RunningErrors(Floats)
        self._rounded = {name: Rounded(value, EPS / 2 * abs(value)) for name, value in floats.items()}
        self._slope, self._inertia = (Compiled(scene, floats, None, [node]) for node in (self.slope, M))

    def inertia(self, q: np.ndarray) -> np.ndarray:
        """m."""
        return self._values(self._inertia, q)[0]

    def force(self, q: np.ndarray) -> np.ndarray:
        """V′."""
        return self._values(self._slope, q)[0]

    def force_at(self, q: float) -> float:
        return float(self.force(np.array([q]))[0])

    def rounding(self, q: float) -> tuple[float, float]:
        """Bounds of the errors of V and V′ there, those of the numbers of the parameters included."""
        try:
            found = evaluate([self.nodes[0], self.slope], self._errors, {**self._rounded, self.q.name: q})
        except (ZeroDivisionError, OverflowError, ValueError):
            return np.inf, np.inf
        return float(error_in(found[0])), float(error_in(found[1]))

    @np.errstate(invalid="ignore")      # where V is infinite nothing is known of what it gains
    def gain(self, start: np.ndarray, way: np.ndarray, rounding: tuple[float, float] | np.ndarray) -> Gain:
        """V(start + way) − V(start) where nothing bends between."""
        mean, change = self._mean_force(start, way)
        value = way * mean
        error = np.abs(way) * (change + rounding[1]) + 4 * EPS * np.abs(value)
        if np.all(error <= 2 * rounding[0]):
            return Gain(value, error)
        before, after = (self._values(self._potential, q)[0] for q in (start, start + way))
        difference = after - before
        direct = 2 * rounding[0] + EPS * np.abs(difference)
        known = ~(error <= direct)
        return Gain(np.where(known, difference, value), np.where(known, direct, error))

    def _mean_force(self, start: np.ndarray, way: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """By the finer rule, and its difference from that by the coarser one."""
        forces = self.force(start[..., None] + way[..., None] * PLACES)
        mean = forces[..., :FINE[0].size] @ (0.5 * FINE[1])
        return mean, np.abs(mean - forces[..., FINE[0].size:] @ (0.5 * COARSE[1]))

    def is_smooth(self, start: np.ndarray, way: np.ndarray) -> np.ndarray:
        """On which ways does nothing bend, jump or tend to infinity, as far as two rules for V′ agree?"""
        with np.errstate(all="ignore"):
            mean, change = self._mean_force(start, way)
            size = np.abs(self.force(start)) + np.abs(self.force(start + way))
            found: np.ndarray = change <= ROUGH * (np.abs(mean) + size)
            return found

    def breaks(self, low: float, high: float) -> list[float]:
        """The places between two others where V or m bends or jumps, or V is about stationary, ascending."""
        kinks = self.kinks(low, high)
        found = set(kinks)
        for a, b in pairwise([low, *kinks, high]):
            places = np.linspace(a, b, GRID)[1:-1]
            found.update(self._extremes(places))
        return sorted(q for q in found if low < q < high)

    def _extremes(self, places: np.ndarray) -> list[float]:
        """Where V is stationary, as far as chords of V′ between near places know it."""
        for _ in range(LOOKS):
            near = []
            for a, b in self._turns(places):
                near.append(np.linspace(a, b, GRID))
            places = np.concatenate(near) if near else np.empty(0)
        force = self.force(np.array(found := self._turns(places)).reshape(-1, 2))
        return [a if not f else a + (b - a) * f / (f - g) for (a, b), (f, g) in zip(found, force.tolist(), strict=True)]

    def _turns(self, places: np.ndarray) -> list[tuple[float, float]]:
        """[(a, b)] of neighbouring places between which V′ changes its sign, or is nothing at the first."""
        sign = np.sign(self.force(places))
        i = np.flatnonzero((sign[1:] != sign[:-1]) & (sign[1:] != 0) & (places[1:] > places[:-1]))
        return list(zip(places[i].tolist(), places[i + 1].tolist(), strict=True))

    def kinks(self, low: float, high: float) -> list[float]:
        """The places between two others where V or m bends or jumps, ascending."""
        if not self.bends:
            return []
        n = len(self.bends)

        def values(q: np.ndarray) -> "list[np.ndarray]":
            return self._values(self._bends, q)[1:n + 1]

        def slopes(q: np.ndarray) -> "list[np.ndarray]":
            return self._values(self._bends, q)[n + 1:]

        places = np.linspace(low, high, GRID)
        turns = self._changes(slopes, places)       # where an argument may touch zero between two places
        places = np.unique(np.concatenate((places, turns)))
        return sorted(set(self._changes(values, places)))

    def _changes(self, functions: Callable[[np.ndarray], list[np.ndarray]], places: np.ndarray) -> list[float]:
        """Where functions of q change their sign, to the last digit."""
        found = []
        for k, row in enumerate(functions(places)):
            sign = np.sign(row)
            found += [float(q) for q in places[sign == 0]]
            changes = np.flatnonzero(sign[1:] * sign[:-1] < 0)
            if changes.size:
                def one(q: Any, k: int = k) -> Any:
                    return functions(q)[k]

                found += map(float, zeros_between(one, places[changes], places[changes + 1]))
        return found

    def _values(self, compiled: Compiled, q: np.ndarray) -> list[np.ndarray]:
        flat = q.ravel()
        with np.errstate(all="ignore"):
            rows = compiled(np.zeros(flat.size), flat.reshape(1, -1), np.zeros((1, flat.size)))
        return [np.reshape(row, q.shape) if np.shape(row) == flat.shape else np.full(q.shape, row) for row in rows]
