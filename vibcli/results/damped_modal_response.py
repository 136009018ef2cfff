"""The motion in time of scenes with members whose modes dampers couple: as a sum over damped modes."""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, cast

from vibcli.base.errors import PhysicsError
from vibcli.results.modal_response import FEWEST, ModalResponse
from vibcli.results.not_by_modes import NotByModes
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.continuous.complex_modes import ComplexModes, DampedBasis
    from vibcli.analyses.continuous.damped_series import DampedSeries, Known
    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.analyses.continuous.left_out_energy import LeftOutEnergy
    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.symbolic.node import Node

LOW = 12            # damped modes that are looked for one by one
LONGEST = 1_000     # steps of a million products
MANY, MOST, SMALL = 2400, 600, 8        # modes at most of systems of few coordinates, and of others
BLOCK, FURTHER = 4_096, 4       # modes that are found together at first, and times as many as are known
FINEST, LEAST = 81_920, 12_288      # modes of few coordinates for values to many digits; of more pieces not so many


class DampedModalResponse(ModalResponse):
    """Small oscillations about the equilibrium. NotByModes where damped modes are not all that moves."""

    WORDS = "small oscillations about the equilibrium, by damped modes"
    estimated = True
    _reached = 0

    def require(self) -> None:
        """NotByModes where the motion is not one of damped modes."""
        import numpy as np

        from vibcli.analyses.continuous.damped_series import swallowed

        matrix = self._transfer.matrix
        if self.linear.circulatory:
            raise NotByModes("forces that no potential gives couple the modes of members", "ask for steady(…)")
        self.natural.first(1)
        if swallowed(matrix, max(float(np.abs(mode.omega or 0.0)) for mode in self.natural.shown())):
            raise NotByModes("a damper is as √(Nμ) of what vibrates at it, so that no wave comes back from it: damped "
                             "modes are not all that moves", "give it a little more or less")

    @cached_property
    def damped(self) -> "Modes":
        """Its damped modes."""
        modal = self.problem.modal
        if self.part is None:
            return cast("Modes", modal.damped)
        from vibcli.analyses.modal.mode_sequence import Modes
        from vibcli.analyses.modal.modes import damped_modes

        return Modes((), modal.solved(damped_modes, self.linear, lambda: self.natural), modal.solved)

    @property
    def drive(self) -> "dict[int, Node]":
        """With what `damping:` does with displacements that drive the scene."""
        found, configuration = dict(super().drive), self.configuration
        if not configuration.coupled:
            return found
        scene, opened = self.problem.scene, configuration.with_inputs
        own = opened.numbers.elements.matrices()[1]
        for (i, j), c in opened.elements.matrices()[1].items():
            more = c - own.get((i, j), 0.0)
            if i < opened.n and j in self._inputs and more:
                rate = scene.table.number(fraction_of(float(more))) * scene.rate(self._inputs[j])
                found[i] = found.get(i, scene.table.zero) - rate
        return found

    @property
    def _transfer(self) -> "ExactTransfer":
        return self._exact

    @property
    def _first(self) -> int:
        return FEWEST if self._graded else super()._first

    @property
    def most(self) -> int:
        if self._graded:
            return 2 * FEWEST
        return MANY if len(self.matrices[0]) <= SMALL else MOST

    @property
    def limit(self) -> int:
        return max(2 * FINEST // max(2, len(self.placed)), LEAST) if self.most == MANY else 0

    def _found(self, count: int) -> "ModalMotion":
        import numpy as np

        from vibcli.analyses.continuous.complex_modes import ComplexModes, DampedBasis
        from vibcli.analyses.continuous.damped_series import damped_series
        from vibcli.analyses.continuous.modal_motion import ModalMotion

        matrix = self._transfer.matrix
        with self.problem.work.task("the search for damped modes", LONGEST):
            while self._reached < count:
                reached = min(max(FURTHER * self._reached, BLOCK), count)
                self._known.append(damped_series(self._known[-1], reached))
                self._reached = reached
        series = cast("DampedSeries", self._known[-1])        # as many as are counted are
        rigid = [[float(x) for x in mode.shape] for mode in self.natural.shown() if mode.rigid]
        basis = DampedBasis(series, matrix, np.array(rigid).reshape(len(rigid), matrix.n), self._transfer.pieces)
        if series.resting != basis.at_rest:
            raise PhysicsError("motions that nothing holds are not told from those that creep",
                               "hold them, or damp them more")
        modes = ComplexModes(basis, self._felt(basis), (*self._start(basis), *self._dragged(basis)),
                             None if self.let_go else self._left_out)
        return ModalMotion(modes, self._transfer, self._forces, self.problem.work)

    def _left_out(self, modes: "ComplexModes") -> "LeftOutEnergy":
        """The LeftOutEnergy."""
        from vibcli.analyses.continuous.field_start import FieldStart
        from vibcli.analyses.continuous.left_out_energy import LeftOutEnergy

        in_fields = any(part is not None for given in self.fields for part in given)
        start = FieldStart(self._transfer, self.deviations, self.fields) if in_fields else None
        return LeftOutEnergy(modes, self._transfer, self.deviations, start)

    @cached_property
    def _known(self) -> "list[Known | DampedSeries]":
        """What is known of the λ, ever more."""
        from vibcli.analyses.continuous.damped_series import within_region

        damped = self.damped
        try:
            damped.first(LOW)
        except PhysicsError as error:
            raise PhysicsError(f"the motion in time of this scene is not found: {error}", "ask for steady(…)") from None
        return [within_region(damped.region)]

    def _dragged(self, basis: "DampedBasis") -> "tuple[np.ndarray, np.ndarray]":
        """φᵀ C u and φᵀ C v at t = 0."""
        from vibcli.analyses.continuous.modal_start import of_field

        place, speed = (basis.shapes.T @ (self.matrices[1] @ part) for part in self.deviations)
        for number, one in enumerate(basis.placed):
            if one.piece.drag:
                rate, given = one.piece.drag / one.piece.inertia, self.fields[number][1]
                place = place + rate * self._displaced(basis, number)
                speed = speed + rate * (0.0 if given is None else of_field(basis, number, given, 0))
        return place, speed

    @property
    def _dying(self) -> "Sequence[DampedMode]":
        return self.damped.shown()
