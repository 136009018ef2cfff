"""The motion in time of scenes with members by modes beside what loads do exactly: of beams, and of bars, shafts and
strings whose waves are not followed."""

from collections.abc import Callable, Mapping
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, cast

from vibcli.base.errors import PhysicsError
from vibcli.results.damping_of_modes import damping_of_modes
from vibcli.results.enough_modes import FINEST, enough, finest, first_modes
from vibcli.results.fields_along_pieces import given_along, over_place
from vibcli.results.not_by_modes import CoupledModes, NotByModes, ShakenSupports
from vibcli.results.response_of_members import ResponseOfMembers
from vibcli.results.resting_shape import less_rest

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.continuous.damped_transfer import DampedTransfer
    from vibcli.analyses.continuous.disturbances import Disturbances
    from vibcli.analyses.continuous.estimated_motion import EstimatedMotion
    from vibcli.analyses.continuous.exact_transfer import DrivenEnd, ExactTransfer
    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.continuous.mode_basis import ModeBasis
    from vibcli.analyses.continuous.shaken_modes import Shaking
    from vibcli.analyses.continuous.start_of_fields import FieldStart
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
    from vibcli.mechanics.initial_fields import MemberFields
    from vibcli.results.part_of_members import PartOfMembers
    from vibcli.results.problem import Problem
    from vibcli.results.responses import PartOfSignal, Terms
    from vibcli.results.signal import Signal
    from vibcli.results.wave_response import WaveResponse
    from vibcli.symbolic.node import Node

FIRST = 128         # modes
FEWEST = 32
MOST = {True: 2048, False: 512}     # modes of a uniform member by itself, and of others


class ModalResponse(ResponseOfMembers):
    """Small oscillations about the equilibrium. NotByModes where what damps couples the modes."""

    KIND, WORDS = "modes", "small oscillations about the equilibrium, by modes"
    _first = FIRST      # so many are counted at first
    _waves: "WaveResponse | None"

    def __init__(self, problem: "Problem", waves: Any = None, part: "PartOfMembers | None" = None) -> None:
        super().__init__(problem, waves, part)
        self._motions: dict[int, ModalMotion | PhysicsError] = {}

    @cached_property
    def natural(self) -> "Modes":
        """Its modes without dampers."""
        if self.part is None:
            return cast("Modes", self.problem.modal.modes)
        from vibcli.analyses.modal.mode_sequence import Modes
        from vibcli.analyses.modal.modes import natural_modes

        precise, elements = self.configuration.sources[0], self.part.elements
        found = natural_modes(self.linear, precise and (lambda digits: elements(precise(digits))))
        return Modes((), found, self.problem.modal.solved)

    @cached_property
    def linear(self) -> "FactoredSystem":
        """Its element data."""
        found = self.configuration.linear_system
        return found if self.part is None else self.part.elements(found)

    @cached_property
    def alone(self) -> "ModalMotion | EstimatedMotion":
        """The ModalMotion of the first modes under the excitation."""
        count = FEWEST if self.rests else self._first
        while True:
            try:
                return self.motion(count)
            except NotByModes:
                raise
            except PhysicsError:        # frequencies that digits do not tell stand among so many
                count //= 2
                if count < FEWEST:
                    raise

    @cached_property
    def _graded(self) -> bool:
        """Does the tension vary along what moves? Each mode costs much then."""
        return any(one.piece.gradient for one in self.placed)

    @cached_property
    def most(self) -> int:
        """So many modes are counted at most."""
        return FIRST if self._graded else MOST[self.closed]

    @cached_property
    def closed(self) -> bool:
        """Is it a uniform member by itself, whose modes are known in closed form?"""
        return (not self._graded and self.natural.first(1)[0].motion.system is not None and len(self.placed) == 1
                and not any(part.any() for part in self.matrices))

    @property
    def limit(self) -> int:
        """By so many modes what is asked to many digits is read at most."""
        return 0 if self._graded else 2 * FINEST[self.closed] // max(2, len(self.placed))

    def motion(self, count: int) -> "ModalMotion":
        """That of so many modes; a refusal is kept as a motion is."""
        if count not in self._motions:
            try:
                self._motions[count] = self._found(count)
            except PhysicsError as refusal:
                self._motions[count] = refusal
        found = self._motions[count]
        if isinstance(found, PhysicsError):
            raise found.told()
        return found

    def _found(self, count: int) -> "ModalMotion":
        from vibcli.analyses.continuous.modal_motion import ModalMotion
        from vibcli.analyses.continuous.real_modes import RealModes

        given, (basis, inputs, damping, begun) = self.problem.modal.member_damping, self.apart(count)
        creeping = given is not None and given.creeps
        starts, disturbed = self._disturbed(basis, inputs, damping)
        start = [one.of_modes(basis.squares, plain) for one, plain in zip(starts, begun, strict=True)]
        shaking = self._shaking(basis)
        modes = RealModes(basis, inputs, start, damping, creeping, disturbed if shaking is None else None, shaking)
        return ModalMotion(modes, self._transfer, self._forces, self.problem.work)

    def apart(self, count: int) -> "tuple[ModeBasis, np.ndarray, np.ndarray, tuple[np.ndarray, np.ndarray]]":
        """(the ModeBasis of the first modes, what each feels of each channel of `loaded`, c of each, (η, η̇) at t = 0);
        NotByModes where what damps couples them."""
        damping = damping_of_modes(self, self._transfer.pieces, count)
        basis = self._basis(count)
        return basis, self._felt(basis), damping, self._start(basis)

    def _basis(self, count: int) -> "ModeBasis":
        """The ModeBasis of the first modes, shapes of near ones orthogonal."""
        from vibcli.analyses.continuous.mode_basis import ModeBasis
        from vibcli.analyses.continuous.near_modes import orthogonal
        from vibcli.analyses.continuous.system import continuous_system

        linear = self._natural_elements
        modes, numbers = orthogonal(first_modes(self.natural, count + 1), lambda: continuous_system(linear))
        return ModeBasis(modes[:count], linear.pieces, numbers[:count])

    @property
    def _natural_elements(self) -> "FactoredSystem":
        """The element data that its modes without dampers are of."""
        return self.linear

    def _felt(self, basis: "ModeBasis") -> "np.ndarray":
        """What each mode feels of each channel."""
        import numpy as np

        from vibcli.analyses.continuous.modal_start import of_drive

        columns = [basis.shapes.T, *(-basis.end_forces(*drive)[:, None] for drive in self._driven_ends),
                   *(of_drive(basis, drive)[:, None] for drive in self.spread_drives)]
        return np.concatenate(columns, axis=1)

    def _disturbed(self, basis: "ModeBasis", inputs: "np.ndarray",
                   damping: "np.ndarray") -> "tuple[list[FieldStart], Callable[[Any], Disturbances]]":
        """The FieldStarts of displacements and rates, and what gives the Disturbances of the modes that are left
        out."""
        import numpy as np

        from vibcli.analyses.continuous.disturbances import Disturbances, Start
        from vibcli.analyses.continuous.start_of_fields import StartOfNodes, start_of_field
        from vibcli.analyses.continuous.uncounted_modes import UncountedModes

        M, _, K = self.matrices
        uncounted = UncountedModes(basis, K, M, self._driven_ends, self.spread_drives, inputs, damping)
        found = [start_of_field(uncounted, [given[rate] for given in self.fields], StartOfNodes(*nodes), not rate,
                                () if rate else self.let_go)
                 for rate, nodes in enumerate(zip(self.deviations, self.sizes, strict=True))]
        start = Start(np.array([one.held for one in found]), np.array([one.spread for one in found]))
        given = self.problem.modal.member_damping
        creeping = given.series if given is not None and given.creeps else ()
        return found, lambda segments: Disturbances(uncounted, start, segments, creeping)

    @cached_property
    def _driven_ends(self) -> "list[DrivenEnd]":
        """DrivenEnds of all ends that the time moves."""
        from vibcli.analyses.continuous.exact_transfer import DrivenEnd

        ends = [(p, end) for p, placed in enumerate(self.placed) for end in range(len(placed.rows))]
        return [DrivenEnd(*at) for at, (_, node) in zip(ends, self.ends_of_pieces, strict=True) if node is not None]

    @cached_property
    def _exact(self) -> "ExactTransfer":
        """The ExactTransfer of all but `damping:`."""
        import numpy as np

        from vibcli.analyses.continuous.exact_transfer import ExactTransfer

        (M, C, K), linear = self.matrices, self.linear
        if linear.G:
            raise NotByModes("gyroscopic terms couple the modes of members", "ask for steady(…)")
        pieces = [one._replace(piece=one.piece._make(float(x) for x in one.piece)) for one in linear.pieces]
        if not all(one.piece.inertia for one in pieces):
            raise NotByModes("a piece of a member without mass has drag", "give it mass, or take the drag out")
        return ExactTransfer(np.array([K, C, M]), pieces, self._driven_ends, self.spread_drives)

    @cached_property
    def _transfer(self) -> "DampedTransfer | ExactTransfer":
        found, damping = self._exact, self.problem.modal.member_damping
        if self.matrices[1].any():
            raise CoupledModes("dampers couple the modes of members", "ask for steady(…)")
        if damping is None:
            return found
        from vibcli.analyses.continuous.damped_transfer import DampedTransfer

        if self._inputs:
            raise ShakenSupports("supports are driven beside `damping:` of members", "ask for steady(…)")
        return DampedTransfer(found, self.natural, damping)

    @cached_property
    def _forces(self) -> "Forcing":
        """The Forcing of all channels."""
        from vibcli.analyses.excitation.decompose import forcing_of
        from vibcli.notation.plain import plain

        nodes, channels = self.loaded
        return forcing_of(nodes, self.problem.scene.time, self.problem.numeric.floats, channels, write=plain,
                          work=self.problem.work)

    @property
    def loaded(self) -> "tuple[dict[int, Node], int]":
        """{channel: node of the time} of coordinates, driven ends and loads along members, and how many there are."""
        driven = [*(node for _, node in self.ends_of_pieces if node is not None),
                  *(force.weight for force in self.spread_forces),
                  *(self.problem.scene.table.zero for _ in self.let_go)]
        n = len(self.matrices[0])
        return self.loads | dict(enumerate(driven, n)), n + len(driven)

    def _shaking(self, basis: "ModeBasis") -> "Shaking | None":
        """The Shaking of supports that are channels of their own; None where ends of pieces are."""

    def _start(self, basis: "ModeBasis") -> "tuple[np.ndarray, np.ndarray]":
        """η and η̇ at t = 0."""
        from vibcli.analyses.continuous.modal_start import of_field

        (q, v), M = self.deviations, self.matrices[0]
        eta, rate = basis.shapes.T @ (M @ q), basis.shapes.T @ (M @ v)
        for number, (_, speed) in enumerate(self.fields):
            eta, rate = eta + self._displaced(basis, number), rate + (
                0.0 if speed is None else of_field(basis, number, speed, 0))
        return eta, rate

    def _displaced(self, basis: "ModeBasis", number: int) -> "np.ndarray":
        """μ ∫ φ u dx over one piece at t = 0."""
        import numpy as np

        from vibcli.analyses.continuous.modal_start import at_rest, of_field

        shape = self.fields[number][0]
        if shape is not None:
            return of_field(basis, number, shape, 0)
        found = at_rest(basis, number, self.deviations[0], self.let_go)
        if not np.isfinite(found).all():
            raise NotByModes("a load along what nothing holds lets go", "let a force at a point of it go")
        return found

    def _field(self, piece: "PlacedPiece", given: "MemberFields | None") -> "tuple[Forcing | None, Forcing | None]":
        """(u, u̇) over one piece as Forcings; None of a u that is the shape at rest between its ends, and of no u̇."""
        nodes, orders = given_along(self.problem.scene, piece, given), (piece.piece.order, 0)
        u, speed = (over_place(self.problem, piece, {0: nodes[rate]}, [orders[rate]]) if rate in nodes else None
                    for rate in range(2))
        if u is not None:
            u = less_rest(u, self.configuration, piece, 4)
            if u is None:
                raise NotByModes(f"'{piece.owner}' rests in a shape that is no polynomial on each of a few parts of it",
                                 "take its tension out, or what turns or ends sharply along it")
        return u, speed

    def moved(self, direct: Any = ()) -> "ModalMotion | EstimatedMotion":
        """The same motion, read with nodes of the time on further channels."""
        return self.alone.under(self.forcing(direct)) if direct else self.alone

    def _linear(self, constant: float, terms: "Terms", source: tuple[Any, ...] = ()) -> "Signal":
        from vibcli.results.modal_signals import ModalSignal

        motion, output = self._driven(constant, terms)
        told = self._waves is None or not source or motion.is_bounded(output, self.until)
        found = None if told else self._waves.without_bound(constant, terms, motion, source)
        return found or ModalSignal(enough(self, motion, output), output, source, partial(finest, self))

    def _composed(self, node: "Node", parts: "Mapping[Node, PartOfSignal]", source: tuple[Any, ...] = ()) -> "Signal":
        return self.composed_of({symbol.name: self._one(part) for symbol, part in parts.items()}, node, source)

    def composed_of(self, signals: "dict[str, Any]", node: "Node", source: tuple[Any, ...] = ()) -> "Signal":
        """A function of signals."""
        from vibcli.results.composed_of_modes import ComposedOfModes

        if self._closing(node) is not None:
            raise PhysicsError("signals of loops that close are not found by modes", "ask for coordinates")
        return ComposedOfModes(node, signals, self.values, self.problem.scene.time, self.problem.work, source)
