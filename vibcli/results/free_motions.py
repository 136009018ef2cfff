"""Families of free motions about the equilibrium of a Problem that nothing drives, dampers left out."""

from collections.abc import Callable, Sequence
from functools import cached_property
from math import tau
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.nonlinear.backbone import Backbone, BackbonePoint
from vibcli.analyses.nonlinear.family import FamilyOfMotions, NoSuchAmplitude, function_of_place, rests_between
from vibcli.analyses.nonlinear.motions_by_amplitude import motions_by_amplitude
from vibcli.analyses.nonlinear.period import periods_of
from vibcli.analyses.nonlinear.well import Well
from vibcli.base.errors import Kinked, NotInLetters, PhysicsError
from vibcli.results.motion_signals import amplitude_told, node_of, require_changing, require_families, require_positive
from vibcli.symbolic.compiled_arrays import Compiled
from vibcli.symbolic.evaluation import multiprecision

if TYPE_CHECKING:
    from vibcli.analyses.nonlinear.motions_by_amplitude import MotionsOfFamily
    from vibcli.results.families_of_modes import FamiliesOfModes
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import NameRef, Product


class FreeMotions:
    """Those of scenes whose forces have a potential; PhysicsError of others."""

    def __init__(self, problem: "Problem") -> None:
        self.problem, self.scene = problem, problem.scene.resting
        require_families(problem)

    @cached_property
    def several(self) -> "FamiliesOfModes | None":
        """Those of several degrees of freedom; None of one."""
        if len(self.scene.q) == 1:
            return None
        from vibcli.results.families_of_modes import FamiliesOfModes

        return FamiliesOfModes(self.problem)

    @cached_property
    def family(self) -> FamilyOfMotions:
        """About the equilibrium."""
        well = Well(self.scene, self.problem.numeric.floats)
        return FamilyOfMotions(well, self._bottom(well), self.scene.unit_of(self.scene.coordinates[0]))

    def _bottom(self, well: Well) -> float:
        """The place of the equilibrium; where the slope of a force is infinite there, it is as drawn."""
        name = self.scene.q[0].name
        try:
            return self.problem.configuration.at_rest[name]
        except Kinked:
            place = self.problem.numeric.drawn_floats[name]
            if not rests_between(well, place):
                raise
            return place

    def omega(self, number: int, tree: Any, amplitude: float) -> tuple[float, float]:
        """(angular frequency [rad/s], relative error) of the motion in which a signal has an amplitude."""
        if self.several is not None:
            point = self.several.curve(number, tree, [amplitude]).points[-1]
            return point.omega, point.error
        _require_first(number)
        require_positive(amplitude)
        point, = self.curve(number, tree, [amplitude]).points
        return point.omega, point.error

    def require_alone(self, number: int) -> None:
        """NotInLetters of several degrees of freedom; PhysicsError of another family than the first."""
        if self.several is not None:
            raise NotInLetters("how ω begins to hang on the amplitude is found in letters of one degree of freedom",
                               "give the parameters values")
        _require_first(number)

    def kappa(self, number: int, name: str, digits: int | None, unit: float) -> Any:
        """κ of ω ≈ ω₀(1 + κA²), A being the amplitude of a coordinate, with the bound of its error."""
        if self.several is not None:
            return self.several.kappa(number, name)
        from vibcli.analyses.nonlinear.small_amplitudes import kappa_in_numbers

        _require_first(number)
        return kappa_in_numbers(self.problem.configuration, digits, unit)

    def kappa_in_letters(self, number: int) -> "Node":
        """The same in letters."""
        from vibcli.analyses.nonlinear.small_amplitudes import kappa_in_letters

        self.require_alone(number)
        return kappa_in_letters(self.problem.symbolic)

    def curve(self, number: int, tree: Any, amplitudes: "Sequence[float]") -> Backbone:
        """Those of a family, counted from 1, with these amplitudes."""
        if self.several is not None:
            return self.several.curve(number, tree, amplitudes)
        _require_first(number)
        node = node_of(self.problem, tree)
        motions = self._motions(tree, node, np.array(amplitudes))
        with_digits = self.problem.numeric.values(multiprecision())
        periods = periods_of(self.family.well, self.scene, with_digits, node, motions, amplitudes)
        return Backbone([BackbonePoint(amplitude, tau / period, energy, error + 2.0**-52)
                         for amplitude, energy, (period, error) in zip(amplitudes, motions.energy.tolist(), periods,
                                                                       strict=True)], None)

    def turning_places(self, tree: Any, amplitude: float) -> tuple[float, float]:
        """Where the motion of one degree of freedom turns in which a signal has an amplitude."""
        require_positive(amplitude)
        found = self._motions(tree, node_of(self.problem, tree), np.array([amplitude]))
        return float(found.left[0, 0]), float(found.right[0, 0])

    def _motions(self, tree: "NameRef | Product", node: "Node", amplitudes: np.ndarray) -> "MotionsOfFamily":
        require_changing(node)
        try:
            return motions_by_amplitude(self.family, self._signal(node), amplitudes)
        except NoSuchAmplitude as error:
            if error.largest is None:
                raise
            raise PhysicsError(f"{error.message}: they end at {amplitude_told(self.problem, tree, error.largest)}",
                               "beyond that a motion passes a top of V, or nothing turns it round") from None

    def _signal(self, node: "Node") -> Callable[[np.ndarray], np.ndarray]:
        compiled = Compiled(self.scene, self.problem.numeric.floats, None, [node])
        return function_of_place(self.family.well, compiled, node)


def _require_first(number: int) -> None:
    if number != 1:
        raise PhysicsError(f"one degree of freedom has one family of free motions, found the index {number}",
                           "write backbone[1]")
