"""The mechanical system of a scene: its expressions, which hold wherever it rests and whatever values it is given."""

from collections.abc import Callable, Mapping
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Kinked, PhysicsError, defined_as_drawn
from vibcli.base.stage import Costs, SharedPart, Stage
from vibcli.base.work import Work

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.language.spec import Spec
    from vibcli.mechanics.compiled_statics import StaticsCode
    from vibcli.mechanics.equilibrium.dry_friction import Sticking
    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.mechanics.settled_tensions import Settled
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.watched_numbers import WatchedValues

SENSES = ("sign", "abs", "min", "max")      # functions by which dry friction acts


def nothing_moves(members: Mapping[str, str] = MappingProxyType({})) -> PhysicsError:
    """What is said of a scene without coordinates; members: {name: section} of those that it has, none with a mass."""
    if not members:
        hint = "give a body a motion, as in bodies: {block: {mass: 2 kg, slide: x}}"
    else:
        name, section = next(iter(members.items()))
        what, attached = ("inertia", "inertia: 2 kg*m^2") if section == "shafts" else ("mass", "mass: 2 kg")
        hint = (f"'{name}' has no {what} of its own: give it one along its length, or attach one, as in "
                f"attached: [{{at: 0.5 m, {attached}}}]")
    return PhysicsError("nothing moves in this scene: it has no coordinates", hint)


class MechanicalSystem:
    """A scene and what follows from it in letters. `given`: exact values for parameters that the file leaves as
    symbols, by which signs in the geometry are read off; `work`: what counts its long work; `released`: the system
    whose motion starts under the force that lets go, where this one is held by it; `tensions`: {member: [N of each
    piece]} that are not those of statics alone, None where they are sought; `watched`: as what the numbers are that are
    read off its drawing; `known`: {part: what it is}, and `shared(part)`, None where that is to be found here; `like`:
    one of the same expressions."""

    def __init__(self, spec: "Spec", given: "Mapping[str, Fraction] | None" = None, work: Work | None = None,
                released: "MechanicalSystem | None" = None, tensions: "Mapping[str, list[Fraction]] | None" = None,
                 watched: "Callable[..., WatchedValues] | None" = None, known: Mapping[str, Any] | None = None,
                 shared: Callable[..., Any] | None = None, like: "MechanicalSystem | None" = None) -> None:
        self.spec, self.given, self.work, self.released = spec, dict(given or {}), work or Work(), released
        self.tensions, self._watched, self._shared, self.like, self.costs = tensions, watched, shared, like, Costs()
        self.__dict__.update(known or {})

    def with_values(self, given: "Mapping[str, Fraction]") -> "MechanicalSystem":
        """The same scene drawn anew with these values alone for its symbols."""
        return MechanicalSystem(self.spec, given, self.work, self.released)

    def under(self, tensions: "Mapping[str, list[Fraction]]") -> "MechanicalSystem":
        """The same scene under tensions of its members."""
        return MechanicalSystem(self.spec, self.given, self.work, tensions=tensions, watched=self._watched)

    @cached_property
    def preloaded(self) -> "MechanicalSystem | None":
        """The system under the force that lets go at t = 0; None where none does."""
        if self.spec.let_go is None or self.released is not None:
            return None
        return MechanicalSystem(self.spec, self.given, self.work, self)

    @cached_property
    def settled(self) -> "Settled | None":
        """The same as it rests under tensions of its own, whose parts are those of this one; None where nothing has
        tensions to be found, or they are given."""
        from vibcli.scene.build import has_tensions

        if self.tensions is not None or self.released is not None or not has_tensions(self.spec):
            return None
        from vibcli.mechanics.settled_tensions import settled

        return settled(self)

    @property
    def members_under(self) -> "Mapping[str, list[Fraction]] | None":
        """{member: [N of each piece]} that are not those of statics alone."""
        return self._itself.tensions

    @property
    def _itself(self) -> "MechanicalSystem":
        """What has its parts."""
        return self if self.settled is None else self.settled.configuration.system

    def dimension(self, coordinate: str) -> "Mapping[str, Fraction | int]":
        """The dimension of a coordinate; a length where nothing settles it."""
        from vibcli.base.units import LENGTH

        found = self.spec.dimensions.of(coordinate)
        return LENGTH if any(base.startswith("?") for base in found) else found

    @Stage
    def scene(self) -> "Scene":
        from vibcli.scene.build import build_preloaded, build_scene

        if self.settled is not None:
            self.preloads: dict[str, Node] = self._itself.preloads
            return self._itself.scene
        if self.released is None:
            scene = build_scene(self.spec, self.given, self.tensions, self._watched)
        else:
            scene = build_preloaded(self.spec, self.given, self.released.members_under)
        if any(name not in self.given for name in scene.parameters.free):
            from vibcli.mechanics.symbolic_equilibrium_linear import drawn_stable

            scene = drawn_stable(scene)
        self.preloads = {}
        if scene.static_preloads and self.released is not None:
            from vibcli.mechanics.static_preload import take_over

            scene = take_over(scene, self.released.preloads)
        elif scene.static_preloads:
            from vibcli.mechanics.static_preload import settle_static_preloads

            scene, self.preloads = defined_as_drawn(settle_static_preloads, scene)
        return scene

    @cached_property
    def scene_with_multipliers(self) -> "Scene":
        """The scene with all its coordinates, its closed loops held by multipliers; itself where it has none."""
        return self.scene if self.scene.loops is None else self.scene.with_multipliers()

    @cached_property
    def with_inputs(self) -> "tuple[Scene, Linearisation, Linearisation, bool]":
        """(scene with inputs, Linearisation, that without excitation, may its matrices depend on the time?)."""
        return (self._shared and self._shared("with_inputs")) or self._with_loads_alone() or self._with_inputs(
            self.scene.with_inputs())

    @cached_property
    def released_with_inputs(self) -> "tuple[Scene, Linearisation, Linearisation, bool]":
        """The same where supports give way."""
        return (self._shared and self._shared("released_with_inputs")) or self._with_inputs(
            self.scene.with_released_supports().with_inputs())

    def _with_inputs(self, scene: "Scene") -> "tuple[Scene, Linearisation, Linearisation, bool]":
        from vibcli.mechanics.autonomous import steady
        from vibcli.mechanics.linearisation import hangs_on
        from vibcli.mechanics.linearise import linearise
        from vibcli.mechanics.static_preload import take_over

        scene = take_over(scene, self.preloads)
        form = linearise(scene)
        return scene, form, steady(scene, form), hangs_on(form, scene.time)

    def _with_loads_alone(self) -> "tuple[Scene, Linearisation, Linearisation, bool] | None":
        """The same of a scene that only loads drive, its own Linearisation with rows of these; None of others."""
        from vibcli.mechanics.linearisation import joined
        from vibcli.mechanics.linearise import linearised_loads
        from vibcli.scene.inputs import with_loads_alone

        scene = with_loads_alone(self.scene) if self.scene.q else None
        if scene is None:
            return None
        loads = scene.forces[len(self.scene.forces):]
        if any(term.s.mask & scene.time.mask for term in loads):
            return None
        added, timed, form = linearised_loads(scene, loads), self.time_dependent_linearisation, self.linearisation
        return scene, joined(timed, added), joined(form, added), self.hangs_on_time

    @Stage
    def linearisation(self) -> "Linearisation":
        """The Linearisation of the scene, its excitation left out."""
        if self.settled is not None:
            return self._itself.linearisation
        if not self.scene.vibrating.timed:
            return self.time_dependent_linearisation
        from vibcli.mechanics.autonomous import steady

        return steady(self.scene.vibrating, self.time_dependent_linearisation)

    @SharedPart
    def statics(self) -> "Linearisation":
        """The Linearisation of forces alone: what conditions of equilibrium and K are made of."""
        return self.linearisation._replace(inertias=[], dampers=[], M={}, C={}, G={}, drag={})

    @SharedPart
    def statics_code(self) -> "StaticsCode":
        from vibcli.mechanics.compiled_statics import StaticsCode

        return StaticsCode(self.statics)

    @cached_property
    def time_dependent_linearisation(self) -> "Linearisation":
        """The Linearisation of the scene with what drives it."""
        if self.settled is not None:
            return self._itself.time_dependent_linearisation
        from vibcli.mechanics.linearise import linearise

        self._require_coordinates()
        return defined_as_drawn(linearise, self.scene.vibrating)

    @cached_property
    def excitation_as_drawn(self) -> "dict[int, Node]":
        """{i: Q(t)} that drives the small oscillations about the drawn position, in letters."""
        from vibcli.mechanics.autonomous import excitation

        scene = self.scene.vibrating
        return excitation(scene, self.time_dependent_linearisation, scene.drawn_position)

    @SharedPart
    def hangs_on_time(self) -> bool:
        """May M, C, G and K depend on the time?"""
        from vibcli.mechanics.linearisation import hangs_on

        vibrating = self.scene.vibrating
        return vibrating.loops is not None or hangs_on(self.time_dependent_linearisation, vibrating.time)

    def _require_coordinates(self) -> None:
        if not self.scene.q and not self.scene.pieces and any(body.moves for body in self.scene.bodies.values()):
            from vibcli.scene.constraints import words_of_locked

            hint = "take a constraint out, or let one more body move"
            if self.scene.held:
                hint = "ask for its forces alone, find: [reactions], or " + hint
            in_time = f", or ask for its motion in time: find: [{{response: {{until: {self.spec.example('2 s')}}}}}]"
            raise PhysicsError(words_of_locked(self.scene), hint + in_time * self.scene.timed)
        if not self.scene.q and not self.scene.pieces:
            raise nothing_moves(self.spec.members)

    @cached_property
    def linearisation_at_reference(self) -> "Linearisation":
        """The Linearisation in the drawn position, in letters: what vanishes there by structure is exactly zero."""
        if self.settled is not None:
            return self._itself.linearisation_at_reference
        from vibcli.mechanics.linearisation import at_position

        try:
            return at_position(self.linearisation, self.scene.vibrating.drawn_position)
        except ZeroDivisionError:
            from vibcli.mechanics.nonsmooth import without_slope

            return defined_as_drawn(without_slope, self.linearisation, self.scene.vibrating)

    @cached_property
    def is_steep_as_drawn(self) -> bool:
        """Is the slope of a force infinite in the drawn position?"""
        try:
            self.linearisation_at_reference  # noqa: B018
        except Kinked:
            return True
        return False

    @cached_property
    def is_linear(self) -> bool:
        """Do the equations not depend on where the scene is linearised?"""
        form = self.linearisation
        rows = [node for _, row in (*form.inertias, *form.springs, *form.dampers) for node in row.values()]
        parts = [node for part in (form.M, form.C, form.G, form.drag, *form.K) for node in part.values()]
        return not any(node.mask for node in rows + parts) and not any(curvature for _, curvature, _ in form.curved)

    @cached_property
    def drawn_residual(self) -> "list[list[Node]]":
        """The terms of each condition of equilibrium as drawn; the slopes of forces may be infinite there."""
        from vibcli.mechanics.linearisation import residual_terms

        try:
            return residual_terms(self.linearisation_at_reference)
        except Kinked:
            from vibcli.mechanics.nonsmooth import residual_as_drawn

            return residual_as_drawn(self.linearisation, self.scene.vibrating)

    @SharedPart
    def potential(self) -> "Node":
        """V of the whole scene less the kinetic energy at rest, as an expression."""
        from vibcli.mechanics.energies import effective_potential

        return defined_as_drawn(effective_potential, self.scene.vibrating)

    @cached_property
    def conservative(self) -> bool:
        """Have all loads a potential: constant forces alone, and no driven motion?"""
        scene = self.scene.vibrating
        return not scene.timed and not any(term.weight.mask for term in scene.forces)

    @cached_property
    def sticking(self) -> "Sticking | None":
        """Where dry friction holds the scene at rest; None where nothing does, or loops are closed numerically."""
        if self.scene.loops is not None or not self.scene.table.called.intersection(SENSES):
            return None
        from vibcli.mechanics.equilibrium.dry_friction import sticking

        return sticking(self)

    @SharedPart
    def named_start(self) -> "dict[str, Node]":
        """{coordinate: expression} of the place that `equilibrium:` names, empty where it names none."""
        start = self.spec.get("equilibrium") or {}
        for name, expression in start.items():
            if name not in self.scene.coordinates:
                raise PhysicsError(f"'{name}' follows from the other coordinates by the constraints", "start "
                                   + " or ".join(f"'{other}'" for other in self.scene.coordinates), expression.where)
        return {name: self.scene.lower(expression) for name, expression in start.items()}
