"""The motion in time of scenes with members whose modes `damping:` damps while dampers couple them: by the modes
without damping, as many as are counted, beside what loads do exactly."""

from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.mechanics.factored_system import summed
from vibcli.results.modal_response import ModalResponse
from vibcli.results.not_by_modes import NotByModes

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy import ndarray

    from vibcli.analyses.continuous.coupled_left_out import CoupledLeftOut
    from vibcli.analyses.continuous.coupled_modes import TiedModes
    from vibcli.analyses.continuous.coupled_transfer import CoupledTransfer, Dampers
    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.analyses.continuous.member_damping import MemberDamping
    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.continuous.mode_basis import ModeBasis
    from vibcli.mechanics.factored_system import FactoredSystem

FEWEST, MOST = 32, 256      # modes
ALIKE = 1e-14       # relative difference of rates that are one
BELOW = 1 - 1e-9    # of a frequency: surely below it
NOISE = 1e-8        # rounding of eigenvalues, of the lowest: a sum over all modes is not better
EPSILON = 2.0**-52


class CoupledModalResponse(ModalResponse):
    """Small oscillations about the equilibrium. NotByModes where more than dampers at coordinates couples the modes."""

    WORDS = "small oscillations about the equilibrium, by coupled modes"
    estimated = True

    @cached_property
    def most(self) -> int:
        count = FEWEST
        while count < MOST and self._noise(2 * count) <= NOISE:
            count *= 2
        return count

    @property
    def limit(self) -> int:
        return 0

    @property
    def _first(self) -> int:
        return self.most if self.most < 2 * FEWEST else 2 * FEWEST

    def _noise(self, count: int) -> float:
        """What rounding leaves of the lowest of so many coupled modes."""
        vibrating = [mode for mode in self.problem.modal.modes.first(count) if mode.omega]
        if not vibrating:
            return 0.0
        last, omega = vibrating[-1], float(vibrating[0].omega)
        return EPSILON * max(float(last.omega), float(self._given.rate(last))) / omega

    @cached_property
    def _elements(self) -> "FactoredSystem":
        """Element data without `damping:`."""
        found = self.configuration.without_given_damping()
        if found.G:
            raise NotByModes("gyroscopic terms couple the modes of members", "ask for steady(…)")
        if found.circulatory:
            raise NotByModes("forces that no potential gives couple the modes of members", "ask for steady(…)")
        if self._inputs:
            raise NotByModes("supports are driven beside dampers and `damping:` of members",
                             "ask for steady(…), or write `proportional: [alpha, 0 s]`")
        return _without_drag(found, self._drag) if self._drag else found

    @cached_property
    def _drag(self) -> float:
        """c/μ of all members: drag in proportion to their mass."""
        pieces = self.configuration.without_given_damping().pieces
        rates = [float(placed.piece.drag / placed.piece.inertia) if placed.piece.inertia else 0.0 for placed in pieces]
        if max(rates) - min(rates) > ALIKE * max(rates):
            raise NotByModes("damping in proportion to stiffness stands beside drag that is not everywhere in "
                             "proportion to the mass of members: modes without end creep",
                             "ask for steady(…), or write `proportional: [alpha, 0 s]`")
        return max(rates)

    @cached_property
    def _exact(self) -> "ExactTransfer":
        import numpy as np

        from vibcli.analyses.continuous.exact_transfer import ExactTransfer

        M, C, _, K = self._elements.with_parts(pieces=()).arrays()
        pieces = [one._replace(piece=one.piece._make(float(x) for x in one.piece)) for one in self._elements.pieces]
        if not all(one.piece.inertia for one in pieces):
            raise NotByModes("a piece of a member without mass has drag", "give it mass, or take the drag out")
        return ExactTransfer(np.array([K, 0 * C, M]), pieces, (), self.spread_drives)

    @cached_property
    def _dampers(self) -> "Dampers":
        from vibcli.analyses.continuous.coupled_transfer import Dampers

        return Dampers(self._elements.with_parts(pieces=()).arrays()[1])

    @cached_property
    def _given(self) -> "MemberDamping":
        """The MemberDamping, drag among what is in proportion to mass."""
        from vibcli.analyses.continuous.member_damping import member_damping
        from vibcli.symbolic.evaluation import Floats

        found = member_damping(self.configuration, self.problem.modal.modes, Floats)
        return found._replace(series=(found.series[0] + self._drag, *found.series[1:])) if self._drag else found

    @cached_property
    def _transfer(self) -> "CoupledTransfer":
        from vibcli.analyses.continuous.coupled_transfer import CoupledTransfer
        from vibcli.analyses.continuous.damped_transfer import DampedTransfer

        return CoupledTransfer(DampedTransfer(self._exact, self.problem.modal.modes, self._given), self._dampers)

    def apart_from_dampers(self, s: complex) -> "tuple[ndarray, ndarray]":
        """(what coordinates answer to unit loads e^{st} on them without dampers, C of these)."""
        import numpy as np

        from vibcli.analyses.excitation.linear_output import LinearOutput

        n, rows = len(self.matrices[0]), self._dampers.rows
        H = [self._transfer.given.at(LinearOutput(0.0, q={i: 1.0}), np.array([s]))[:n, 0] for i in range(n)]
        return np.array(H), (rows * self._dampers.rates) @ rows.T

    def _found(self, count: int) -> "ModalMotion":
        from vibcli.analyses.continuous.estimated_motion import EstimatedMotion
        from vibcli.analyses.continuous.modal_motion import ModalMotion

        parts = self._transfer, self._forces, self.problem.work
        return EstimatedMotion(self._modes(count), *parts, half=lambda: ModalMotion(self._modes(count // 2), *parts))

    @property
    def _natural_elements(self) -> "FactoredSystem":
        return self._elements

    def _modes(self, count: int) -> "TiedModes":
        """The TiedModes of so many."""
        import numpy as np

        from vibcli.analyses.continuous.coupled_modes import FollowingShapes, TiedModes

        modes, given, basis = self.problem.modal.modes.first(count), self._given, self._basis(count)
        inputs = self._felt(basis)
        damping = np.array([float(given.rate(mode)) for mode in modes])
        following = FollowingShapes(basis, inputs, self._exact, self._dampers)
        return TiedModes(basis, inputs, self._start(basis), (damping, given.of_squares), following, given.creeps,
                         self._left_out(basis, inputs, damping))

    def _left_out(self, basis: "ModeBasis", inputs: "ndarray",
                  damping: "ndarray") -> "Callable[[TiedModes, Any], CoupledLeftOut] | None":
        """What gives the CoupledLeftOut under segments of the loads; None where none is known."""
        from vibcli.analyses.continuous.coupled_left_out import CoupledLeftOut
        from vibcli.analyses.continuous.given_denominators import denominators

        count = len(basis.squares)
        omega = BELOW * float(self.problem.modal.modes.first(count + 1)[-1].omega or 0.0)
        beyond = denominators(self._given, count, omega)
        if beyond is None or not (basis.squares > 0).all() or (self._dampers.rates < 0).any() or self.let_go:
            return None
        disturbed = self._disturbed(basis, inputs, damping)[1]
        return lambda modes, segments: CoupledLeftOut(modes, self._transfer, beyond, disturbed(segments), segments)


def _without_drag(elements: "FactoredSystem", rate: float) -> "FactoredSystem":
    """Element data whose members do not drag, where all mass does at this rate: dampers of masses take theirs back."""
    pieces = [placed._replace(piece=placed.piece._replace(drag=0.0)) for placed in elements.pieces]
    taken = [(-rate * mass, row) for mass, row in elements.inertias]
    C = summed(elements.C, {pair: -rate * mass for pair, mass in elements.M.items()})
    return elements.with_parts(pieces=pieces, dampers=(*elements.dampers, *taken), C=C)
