"""The phase plane of a Problem with one degree of freedom: its equilibria, each of its kind, and what is drawn."""

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.nonlinear.damped_portrait import of_motion
from vibcli.analyses.nonlinear.energy_levels import EnergyLevels
from vibcli.analyses.nonlinear.equilibrium_kinds import StateEquilibrium
from vibcli.analyses.nonlinear.integrated_orbits import NEAR, PhaseFrame
from vibcli.analyses.nonlinear.limit_cycles import limit_cycles
from vibcli.analyses.nonlinear.period import exact_period, has_dampers, has_potential
from vibcli.analyses.nonlinear.period_in_floats import period_between
from vibcli.analyses.nonlinear.phase_portrait import (
    OWN,
    Portrait,
    StatePath,
    base_of,
    kinetic_energy,
    of_levels,
    through,
)
from vibcli.analyses.nonlinear.state_field import StateField
from vibcli.analyses.nonlinear.turning_points import TurningPoint
from vibcli.analyses.nonlinear.well import Well
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.energies import relative_potential
from vibcli.mechanics.equilibrium.all_equilibria import find_equilibria
from vibcli.mechanics.equilibrium.scaled_forces import typical_length
from vibcli.results.phase_frame import bounds_of, heights_of, range_of, speed_of
from vibcli.results.state_equilibria import StateEquilibria

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.equilibrium.all_equilibria import Equilibria
    from vibcli.results.problem import Problem
    from vibcli.scene.scene import Scene


MARGIN_ABOVE = 1.5      # of the speed on a limit cycle
LOOKED_AT, SAME = np.linspace(-0.9, 1.0, 7), 1e-12      # of the unit; of forces


class OwnMotion(NamedTuple):
    """The motion from the start (q, q̇): the places at which it turns, and its period [s] with the bound of its relative
    error, where it comes back; `reason`: why it does not, as far as that is known; energy: over the lowest
    equilibrium; end: the equilibrium in which a damped motion is seen to end."""

    q: float
    v: float
    turns: tuple[float, float] | None = None
    period: tuple[float, float] | None = None
    reason: str | None = None
    energy: float | None = None
    end: StateEquilibrium | None = None


class PhasePlane:
    """PhysicsError of scenes that have none."""

    def __init__(self, problem: "Problem") -> None:
        require_plane(problem)
        self.problem = problem
        self.configuration = _configuration(problem)
        self.scene, self.floats = self.configuration.scene, self.configuration.numeric.floats
        self.name, = self.scene.coordinates
        self.unit = self.scene.unit_of(self.name)
        self.field = StateField(self.scene, self.floats)
        if self.field.driven:
            raise PhysicsError("what drives this scene depends on the time: its orbits cross in the phase plane",
                               "leave loads in time and drives out, or ask for its motion in time")
        self.well = _well(self.scene, self.floats, self.field, self.unit)
        self.conservative = self.well is not None and not has_dampers(self.scene)

    @property
    def title(self) -> str:
        """That of the scene, with the equations where they are not the full ones."""
        title = self.problem.spec.get("title") or ""
        if not self.problem.spec.expanded:
            return title
        from vibcli.results.expanded_response import THIRD_ORDER

        return f"{title} ({THIRD_ORDER})".strip()

    @cached_property
    def start(self) -> tuple[float, float] | None:
        """(q, q̇) at t = 0; None where the file says nothing of it."""
        if not self.problem.initial.given:
            return None
        (q,), (v,) = (part.values() for part in self.problem.initial.start)
        return float(q), float(v)

    @cached_property
    def equilibria(self) -> StateEquilibria:
        """Those of what is shown."""
        return StateEquilibria(self.configuration, self._search, self.field, self.well, self._is_reversible,
                               lambda search: range_of(search, self.well, self.start, self.unit, self.cycles))

    @cached_property
    def cycles(self) -> list[StatePath]:
        """Limit cycles about unstable equilibria."""
        if self._is_reversible or not self._search.forces.names:
            return []
        places = [item.equilibrium.values[self.name] for item in self._search.items]
        return limit_cycles(self.field, places, self.unit)

    @property
    def _is_reversible(self) -> bool:
        q = self.start[0] if self.start is not None else self.configuration.numeric.drawn_floats[self.name]
        return self.conservative or self.field.is_reversible(q - self.unit, q + self.unit, self.unit)

    @cached_property
    def _search(self) -> "Equilibria":
        """All equilibria within the bounds of the file; else within default ones, and as far as the motion goes and the
        forces are bent."""
        found = self._by_default
        asked = self.problem.spec.get("find")
        if found is not None and (self.well is None or (asked and self.name in asked.within)):
            return found
        if found is not None and (found.linear or found.forces.periodic[0] or self.name not in found.bounds):
            return found
        middle = self.configuration.numeric.drawn_floats[self.name]
        if found is None or not found.items:
            middle = middle if self.start is None else self.start[0]
        else:
            middle = found.items[0].equilibrium.values[self.name]
        low, high = bounds_of(self.well, middle, self.start, self.unit)
        known = (low, high) if found is None else found.bounds[self.name]
        if found is not None and known[0] <= low and high <= known[1]:
            return found
        return find_equilibria(self.configuration, {self.name: (min(low, known[0]), max(high, known[1]))})

    @property
    def _by_default(self) -> "Equilibria | None":
        """None where no figure says how far equilibria are searched."""
        try:
            own = self.configuration is self.problem.configuration
            return self.problem.equilibria if own else find_equilibria(self.configuration)
        except PhysicsError:
            if self.well is None or typical_length(self.configuration.numeric):
                raise
            return None

    @cached_property
    def levels(self) -> EnergyLevels | None:
        """The levels of its energy; None where the forces have no potential."""
        if self.well is None:
            return None
        places = [one.q for one in self.equilibria.items]
        return EnergyLevels(self.well, *self.equilibria.range, places if self.start is None else
                            [*places, self.start[0]])

    @cached_property
    def frame(self) -> PhaseFrame:
        """What is shown."""
        low, high = self.equilibria.range
        speed = max(speed_of(self.field, self.levels, self.equilibria.items, self._moving, (low, high)),
                    *(MARGIN_ABOVE * float(one.v.max()) for one in self.cycles), 0.0)
        if self.field.jumps_with_speed(low, high, speed):
            raise PhysicsError("a force of this scene jumps with the sense of the motion, as dry friction does: it "
                               "rests in whole ranges of places, which are no points of the phase plane",
                               "leave the friction out, or ask for its motion in time")
        return PhaseFrame((low, high), (-speed, speed))

    @property
    def _moving(self) -> tuple[float, float] | None:
        """The start, unless the scene rests there."""
        return None if self.start is None or (not self.start[1] and self.rests) else self.start

    @property
    def rests(self) -> bool:
        """Is the start an equilibrium?"""
        low, high = self.equilibria.range
        return self.start is not None and not self.start[1] and any(
            abs(self.start[0] - one.q) <= 1e-12 * (high - low) for one in self.equilibria.items)

    @cached_property
    def portrait(self) -> Portrait:
        frame, items = self.frame, self.equilibria.items
        if self.conservative:
            drawn = of_levels(self.levels, items, self._moving, frame.v[1])
        else:
            drawn = of_motion(self.field, list(zip(items, self.equilibria.around, strict=True)), self._moving, frame)
            drawn += self.cycles
        inside = [one for one in drawn if _is_seen(one, frame)]
        return Portrait(items, inside, None if self.levels is None else heights_of(self.levels, items))

    @cached_property
    def own(self) -> OwnMotion | None:
        """The motion from the start; None where the file gives none."""
        if self.start is None:
            return None
        found = OwnMotion(*self.start, energy=self._energy())
        if self._moving is None:
            return found._replace(reason="it rests in this equilibrium")
        if not self.conservative:
            return found._replace(end=self._end())
        rests = [self.levels.index(one.q) for one in self.equilibria.items]
        orbit, = through(self.levels, self.start, rests) or [None]
        ends = () if orbit is None else [q for q, ended in zip((orbit.q[0], orbit.q[-1]), orbit.ends, strict=True)
                                         if ended]
        if any(q == self.levels.stops[k] for q in ends for k in rests):
            return found._replace(reason="it is on a separatrix and tends to a saddle")
        if len(ends) == 2:
            return self._closed(found, (float(orbit.q[0]), float(orbit.q[-1])))
        return found._replace(reason="it leaves what is shown")

    def _end(self) -> StateEquilibrium | None:
        """The equilibrium near which the orbit of the damped motion stops."""
        for path in self.portrait.branches:
            for one in self.portrait.equilibria if path.role == OWN else ():
                apart = np.array([path.q[-1] - one.q, path.v[-1]]) / self.frame.size[:, 0]
                if one.attracts and np.linalg.norm(apart) < 2 * NEAR:
                    return one
        return None

    def _closed(self, found: OwnMotion, turns: tuple[float, float]) -> OwnMotion:
        if self.scene.timed:        # the energy is that of the frame, whose period more digits do not know
            period, error = period_between(self.well, *(TurningPoint(q, 2**-52 * abs(q)) for q in turns))
            return found._replace(turns=turns, period=(period, error / period))
        try:
            return found._replace(turns=turns, period=exact_period(self.scene, self.floats, *self.start))
        except PhysicsError as error:
            return found._replace(turns=turns, reason=error.message)

    def _energy(self) -> float | None:
        if self.levels is None:
            return None
        numbers = [self.levels.index(one.q) for one in self.equilibria.items]
        if not numbers:
            return None
        base = base_of(self.levels, numbers)
        climb = self.levels.climbs(base)[self.levels.index(self.start[0])]
        return float(climb) + kinetic_energy(self.levels, self.start)


def _well(scene: "Scene", floats: dict[str, Any], field: StateField, unit: float) -> Well | None:
    """That of a scene whose forces have a potential, in a frame that turns steadily too; None of others."""
    if has_potential(scene):
        return Well(scene, floats)
    V = relative_potential(scene) if scene.timed and scene.loops is None else None
    if V is None:
        return None
    found = Well(scene, floats, V)
    q = unit * LOOKED_AT
    forces = -found.inertia(q) * field.acceleration(q, np.zeros(q.size))
    return found if np.allclose(found.force(q), forces, rtol=SAME, atol=SAME * np.abs(forces).max()) else None


def _is_seen(branch: StatePath, frame: PhaseFrame) -> bool:
    """Is it more than what a frame cuts off?"""
    return bool((~frame.beyond(np.stack((branch.q, branch.v)))).any())


def require_plane(problem: "Problem") -> None:
    """PhysicsError where a scene has no phase plane."""
    if problem.spec.members:
        raise PhysicsError("members have modes without end: a phase plane is that of one degree of freedom",
                           "ask for its motion in time")
    names = problem.scene.coordinates
    if len(names) != 1:
        raise PhysicsError(f"a phase plane is that of one degree of freedom, and this scene has {len(names)}"
                           + (": " + ", ".join(names[:6]) if names else ""), "take coordinates out, or ask for its "
                           "motion in time" if names else "let something move in it")
    if problem.numeric.has_free_symbols:
        from vibcli.language.parameters import require_values

        require_values(problem.scene.parameters, "a phase plane")
    _require_free(problem)


def _require_free(problem: "Problem") -> None:
    """PhysicsError of what is not drawn yet, or not true of wide motions."""
    spec, scene = problem.spec, problem.scene
    if spec.get("damping") is not None:
        raise PhysicsError("`damping:` of the whole is that of small oscillations about the equilibrium, which a phase "
                           "plane goes beyond", "give dampers in its place")
    if scene.loops is not None:
        raise PhysicsError("loops of this scene are closed numerically: its orbits are not drawn in a phase plane",
                           "ask for its motion in time")
    rope = next((tie.name for tie in scene.constraints if tie.form == "rope"), None)
    if rope is not None:
        raise PhysicsError(f"the rope '{rope}' goes slack where it would have to push: orbits on which it does are not "
                           "those of this coordinate", "hold it by a link, or ask for the motion in time, which tells "
                           "when that is")
    if problem.system.sticking is not None:
        raise PhysicsError("dry friction holds this scene in whole ranges of places, which are no points of the phase "
                           "plane", "leave it out, or ask for its motion in time")


def _configuration(problem: "Problem") -> "Configuration":
    """Of the equations whose motion it is."""
    if not problem.spec.expanded:
        return problem.configuration
    from vibcli.results.expanded_response import ExpandedResponse

    return ExpandedResponse(problem).expanded
