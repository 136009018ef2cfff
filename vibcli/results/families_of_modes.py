"""Families of free motions of several degrees of freedom, each from a mode of small vibrations."""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.nonlinear.backbone import Backbone, BackbonePoint
from vibcli.analyses.nonlinear.family_of_mode import EndOfFamily, FamilyOfMode
from vibcli.analyses.nonlinear.free_equations import FreeEquations
from vibcli.analyses.nonlinear.harmonics import AmplitudeOfCombination, AmplitudeOfSignal
from vibcli.analyses.nonlinear.small_amplitudes_of_modes import kappa_of_mode, near_resonance
from vibcli.base.errors import PhysicsError
from vibcli.results.motion_signals import amplitude_told, node_of, require_changing, require_positive
from vibcli.symbolic.compiled_arrays import Compiled
from vibcli.symbolic.derivatives import gradient

if TYPE_CHECKING:
    from vibcli.analyses.nonlinear.family_of_mode import MotionOfAmplitude
    from vibcli.results.problem import Problem
    from vibcli.symbolic.running_errors import Rounded
    from vibcli.symbolic.syntax import NameRef


class FamiliesOfModes:
    """About the equilibrium of a Problem; PhysicsError where motions do not run backwards as well."""

    def __init__(self, problem: "Problem") -> None:
        self.problem, self.scene = problem, problem.scene.resting

    @cached_property
    def equations(self) -> FreeEquations:
        at_rest = self.problem.configuration.at_rest
        rest = np.array([at_rest[q.name] for q in self.scene.q])
        found = FreeEquations(self.scene, self.problem.numeric.floats, rest)
        found.require_reversible()
        return found

    def curve(self, number: int, tree: Any, amplitudes: Sequence[float]) -> Backbone:
        """The motions of the family of a mode, counted from 1, with these amplitudes of a signal."""
        self._require_number(number)
        require_positive(min(amplitudes))
        family = FamilyOfMode(self.equations, number - 1, self._range(tree))
        try:
            found = family.motions(amplitudes)
        except EndOfFamily as error:
            raise PhysicsError(f"{error.message}: family {number} is followed up to "
                                f"{amplitude_told(self.problem, tree, error.largest)}", error.hint) from None
        except KeyboardInterrupt:
            if not family.found:
                raise
            self.problem.work.interrupt()
            found = family.found
        points = [BackbonePoint(one.amplitude, one.motion.w * family.balance.scale, family.balance.energy(one.motion),
                                one.error) for one in found]
        return Backbone(points, self._told(tree, family, found, number))

    def kappa(self, number: int, name: str) -> "Rounded":
        """κ of ω ≈ ωᵢ(1 + κA²), A being the amplitude of a coordinate, with the bound of its error."""
        self._require_number(number)
        return kappa_of_mode(self.problem.configuration, self.equations, number - 1,
                             self.scene.coordinates.index(name))

    def near_resonance(self, number: int) -> str | None:
        """What narrows κ to the smallest amplitudes, in words."""
        found = near_resonance(self.equations, number - 1)
        return found and (f"Mode {found[0] + 1} has nearly {found[1]} times the frequency of mode {number} (internal "
                          f"resonance 1:{found[1]}): κ tells ω at amplitudes far below those where they may "
                          "exchange energy.")

    def _require_number(self, number: int) -> None:
        n = len(self.scene.q)
        if not 1 <= number <= n:
            raise PhysicsError(f"this scene has {n} families of free motions, found the index {number}",
                               f"write an index from 1 to {n}")

    def _told(self, tree: "NameRef", family: FamilyOfMode, found: "Sequence[MotionOfAmplitude]",
              number: int) -> str | None:
        """The first motion with an internal resonance, in words."""
        for one in found:
            if (shared := family.resonance(one.motion)) is not None:
                order, mode, share = shared
                return (f"Internal resonance near {order}:1: from {amplitude_told(self.problem, tree, one.amplitude)} "
                        f"on, harmonic {order} of family {number} moves as mode {mode + 1} does, with {share:.0%} of "
                        "the kinetic energy.")
        return None

    def _range(self, tree: "NameRef") -> AmplitudeOfSignal:
        node, speeds = node_of(self.problem, tree), self.scene.v
        require_changing(node)
        slopes = gradient(node)
        if any(v in slopes for v in speeds):
            raise PhysicsError("the amplitude of a family of free motions is that of a displacement or a spring's "
                               "force", "ask for a function of the places alone, without rates")
        by_q = [slopes.get(q, self.scene.table.zero) for q in self.scene.q]
        compiled = Compiled(self.scene, self.problem.numeric.floats, None, [node, *by_q])
        kind = AmplitudeOfSignal if any(slope.mask for slope in by_q) else AmplitudeOfCombination
        return kind(compiled, self.equations.rest, self.equations.shapes)
