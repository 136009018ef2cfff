"""What all motions in time of scenes with members share: pieces between stations, what moves their ends, the fields
that they start with, and signals of places between stations."""

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np

from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
from vibcli.base.errors import PhysicsError
from vibcli.results.fields_along_pieces import given_along, over_place
from vibcli.results.responses import SmallResponse
from vibcli.results.resting_shape import ROUNDING, less_rest, polynomial_at_rest, with_polynomials
from vibcli.results.unloaded_ends import is_unloaded
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    from vibcli.analyses.continuous.spread_drives import SpreadDrive
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.mechanics.initial_fields import MemberFields
    from vibcli.results.long_after import LongAfter
    from vibcli.results.part_of_members import PartOfMembers
    from vibcli.results.parted_response import PartedResponse
    from vibcli.results.problem import Problem
    from vibcli.results.responses import PartOfSignal
    from vibcli.results.signal import Signal
    from vibcli.results.steady_response import SteadyResponse
    from vibcli.results.wave_response import WaveResponse
    from vibcli.scene.spread_forces import SpreadForce
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import SyntaxTree

EARLY = "; values at instants by travelling waves as long as their fronts stay few"


class ResponseOfMembers(SmallResponse):
    """Small oscillations of a scene whose members vibrate. `moved(direct)` gives its motion, read by LinearOutputs with
    FieldPoints; `matrices` leave the pieces out. part: what of the scene it is the motion of, alone; None of all."""

    def __init__(self, problem: "Problem", waves: "WaveResponse | PartedResponse | None" = None,
                 part: "PartOfMembers | None" = None) -> None:
        super().__init__(problem)
        self._waves, self.part = waves, part

    @property
    def words(self) -> str:
        return self.WORDS + (EARLY if self._waves is not None else "")

    def by_waves(self, tree: Any, t: float) -> "Signal | None":
        """The signal of a tree by waves that are followed up to an instant; None where their fronts are too many."""
        if self._waves is None:
            return None
        try:
            self._waves.reach(t)
            return self._waves.signal(tree)
        except NotByWaves:
            return None

    @property
    def start(self) -> tuple[dict[str, float], dict[str, float]]:
        return self.problem.initial.start

    @cached_property
    def matrices(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """M, C + G, K without the pieces."""
        M, C, G, K = self.configuration.linear_system.with_parts(pieces=()).arrays()
        M, C, K = (M, C + G, K) if self.part is None else map(self.part.block, (M, C + G, K))
        return M, C, K

    @cached_property
    def placed(self) -> "Sequence[PlacedPiece]":
        """The PlacedPieces, their rows over coordinates and, behind them, inputs."""
        found = self.configuration.with_inputs.elements.pieces
        return found if self.part is None else [found[p] for p in self.part.pieces]

    @cached_property
    def deviations(self) -> tuple[np.ndarray, np.ndarray]:
        q, v = super().deviations
        q = np.where(np.abs(q) > ROUNDING * self._subtracted, q, 0.0)
        return self._among(q), self._among(v)

    @property
    def sizes(self) -> "tuple[np.ndarray, np.ndarray]":
        """What the deviations are rounded from."""
        q, v = self.deviations
        return np.maximum(np.abs(q), self._among(self._subtracted)), np.abs(v)

    def _among(self, values: np.ndarray) -> np.ndarray:
        return values if self.part is None else values[self.part.coordinates]

    @cached_property
    def _subtracted(self) -> np.ndarray:
        """How large the coordinates are, both at the start and at rest, of which the deviations are the differences:
        the largest of each unit."""
        names, unit = self.problem.scene.coordinates, self.problem.spec.dimensions.of
        return np.array([min(max(abs(one[other]) for other in names if unit(other) == unit(name)) for one in (
            self.problem.initial.start[0], self.problem.configuration.equilibrium.values)) for name in names])

    @cached_property
    def drive(self) -> "dict[int, Node]":
        found = super().drive
        return found if self.part is None else self.part.row(found)

    @cached_property
    def _inputs(self) -> "dict[int, Node]":
        """{number of an input: what moves it, a node of the time} of displacements that drive the scene."""
        from vibcli.symbolic.transfer_between_tables import copied

        opened = self.configuration.with_inputs
        nodes = {i: one.node for i, one in enumerate(opened.scene.inputs.values(), opened.n) if one.node is not None}
        return dict(zip(nodes, copied(list(nodes.values()), self.problem.scene.table), strict=True))

    def _driven_by(self, row: Mapping[int, float]) -> "Node | None":
        """What moves the end of a piece beside the coordinates, a node of the time, or None."""
        table, n = self.problem.scene.table, self.configuration.with_inputs.n
        terms = [self._inputs[i] * table.number(fraction_of(x)) for i, x in row.items() if i >= n and x]
        return sum(terms[1:], terms[0]) if terms else None

    @cached_property
    def ends_of_pieces(self) -> "list[tuple[dict[int, float], Node | None]]":
        """[(row over coordinates, node of the time or None)] of all ends of pieces, from left to right."""
        n = self.configuration.with_inputs.n
        return [(self._own({i: float(x) for i, x in row.items() if i < n and x}), self._driven_by(row))
                for piece in self.placed for row in piece.rows]

    def _own(self, row: dict[int, float]) -> dict[int, float]:
        return row if self.part is None else self.part.row(row)

    @cached_property
    def loads(self) -> "dict[int, Node]":
        """{i: node of the time}: what drives the coordinates, less what driven ends bring by springs of pieces."""
        table, n, found = self.problem.scene.table, self.configuration.with_inputs.n, dict(self.drive)
        for piece in self.placed:
            for weight, row in piece.springs:
                driven = self._driven_by(row)
                for i, x in self._own(row).items() if driven is not None else ():
                    if i < n:
                        found[i] = found.get(i, table.zero) + driven * table.number(fraction_of(weight * x))
        return found

    @property
    def spread_forces(self) -> "list[SpreadForce]":
        """The SpreadForces that vary in time."""
        members = {placed.owner for placed in self.placed}
        return [force for force in self.problem.scene.spread_forces
                if not force.weight.is_zero and force.member in members]

    @cached_property
    def spread_drives(self) -> "list[SpreadDrive]":
        """The SpreadDrives of loads along members in time, and behind them of what lets go, none from then on."""
        from vibcli.analyses.continuous.spread_drives import spread_drive
        from vibcli.symbolic.evaluation import Floats

        place = self.configuration.at_rest
        return [*(spread_drive(force, place, Floats) for force in self.spread_forces), *self.let_go]

    @cached_property
    def let_go(self) -> "list[SpreadDrive]":
        """The SpreadDrives of a load along members that lets go."""
        from vibcli.analyses.continuous.spread_drives import spread_drive
        from vibcli.symbolic.evaluation import Floats

        held, name = self.configuration.preloaded, self.problem.spec.let_go
        forces = [] if held is None else [force for force in held.scene.spread_forces if force.owner == name]
        return [spread_drive(force, held.at_rest, Floats) for force in forces]

    @cached_property
    def fields(self) -> list[Any]:
        """What each piece starts with, counted from the equilibrium; None of those at rest, straight between ends."""
        from vibcli.mechanics.initial_fields import member_fields

        given = member_fields(self.problem.scene)
        return [self._field(piece, given.get(piece.owner)) for piece in self.placed]

    @property
    def rests(self) -> bool:
        """Does nothing move it, neither loads nor what it starts with?"""
        started = any(part.any() for part in self.deviations) or any(
            part is not None for given in self.fields for part in given or ())
        driven = any(node is not None for _, node in self.ends_of_pieces)
        return not (started or driven or self.let_go or self.spread_forces or self.loads)

    def _field(self, piece: "PlacedPiece", given: "MemberFields | None") -> "Forcing | None":
        """u and u̇ over one piece, channels of the place along it; None of what rests straight between its ends."""
        scene, held = self.problem.scene, self.configuration.preloaded
        nodes = given_along(scene, piece, given)
        if 0 in nodes:
            field = over_place(self.problem, piece, nodes, [piece.piece.order, 0])
            found = less_rest(field, self.configuration, piece, 2)
            return found or self._no_polynomial(piece)
        if held is not None and (given is not None or scene.gravity or held.scene.spread_loads):
            added = [self._resting(held, piece), -self._resting(self.configuration, piece)]
        elif given is not None:
            added = [self._straight(piece)]
        else:
            return None
        field = over_place(self.problem, piece, nodes, [piece.piece.order, 0])
        return with_polynomials(field, 0, added, float(piece.piece.length))

    def _straight(self, piece: "PlacedPiece") -> np.ndarray:
        """u of a piece straight between its ends as they start."""
        q = self.deviations[0]
        left, right = (sum(x * q[i] for i, x in self._own(row).items() if i < len(q)) for row in piece.rows)
        return np.array([left, (right - left) / float(piece.piece.length)])

    def _resting(self, configuration: "Configuration", piece: "PlacedPiece") -> np.ndarray:
        """u of a piece in the equilibrium of a Configuration: a parabola, as weight may lengthen it."""
        found = polynomial_at_rest(configuration, piece, 2)
        return self._no_polynomial(piece) if found is None else found

    def _no_polynomial(self, piece: "PlacedPiece") -> NoReturn:
        raise NotByWaves(f"'{piece.owner}' rests under a load that varies along it")

    @cached_property
    def kept_up(self) -> "SteadyResponse":
        """The response of which the steady state alone is asked."""
        from vibcli.results.steady_response import SteadyResponse

        return SteadyResponse(self.problem, PhysicsError(f"this is not found of {self.WORDS}",
                                                         "ask for max(x), min(x) or values in time"))

    def long_after(self, tree: Any) -> "LongAfter":
        """What a signal comes to."""
        from vibcli.results.long_after import LongAfter

        return LongAfter(self, tree)

    def _one(self, part: "PartOfSignal", source: tuple[Any, ...] = ()) -> Any:
        if len(part) == 1 and part[0].head == "steady":
            return self.kept_up.signal(part[0])
        return super()._one(part, source)

    def lasting(self) -> float:
        from vibcli.analyses.transient.duration import duration, fading

        forces = self._forces
        last = forces.last.start if forces.listed else 0.0
        return duration(self.problem.modal.modes.shown(), self._dying, last, sorted(forces.speeds), fading(forces))

    @property
    def drawn_out(self) -> bool:
        """Do loads swing or die out, so that they may last longer than what vibrates?"""
        from vibcli.analyses.transient.duration import fading

        return bool(self._forces.speeds or fading(self._forces))

    @property
    def _dying(self) -> "Sequence[DampedMode] | None":
        """The damped modes that tell when it has died out; None where those without dampers tell how long it lasts."""

    @cached_property
    def _forces(self) -> "Forcing":
        """The Forcing of all channels."""
        raise NotImplementedError

    def _part(self, parts: "dict[Node, PartOfSignal]", name: str, primes: int,
              part: "SyntaxTree | tuple[str]") -> "Node":
        from vibcli.mechanics.inputs_outputs.place_signals import place_output

        found = place_output(self.configuration, name + "'" * primes) if isinstance(name, str) else None
        if found is None:
            return super()._part(parts, name, primes, part)
        length = float(self.placed[found.piece].piece.length)
        point = FieldPoint(found.piece, float(found.share) * length, found.order, found.primes)
        output = LinearOutput(0.0 if primes else self._at_rest(name),
                              places={} if is_unloaded(self, found) else {point: float(found.factor)})
        return self._named(parts, f"signal {name}" + "'" * primes, (output, None))

    def _at_rest(self, name: str) -> float:
        """A signal in equilibrium."""
        from vibcli.mechanics.rest_curves import value_at_rest

        return value_at_rest(self.configuration, name)

    def state_signal(self, node: "Node") -> NoReturn:
        """Energies of members are spread along them: they are not found."""
        raise PhysicsError("energies of scenes with members that vibrate are not found in time",
                           "ask for displacements, forces and stresses")
