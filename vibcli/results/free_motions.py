"""Families of free motions about the equilibrium of a Problem, dampers and loads in time left out."""

from collections.abc import Sequence
from functools import cached_property
from math import tau
from typing import TYPE_CHECKING, Any

from vibcli.analyses.nonlinear.backbone import BackbonePoint
from vibcli.analyses.nonlinear.family import FamilyOfMotions, NoSuchAmplitude, function_of_place
from vibcli.analyses.nonlinear.period import has_potential, period_of
from vibcli.analyses.nonlinear.well import Well
from vibcli.base.errors import PhysicsError
from vibcli.language.signals import signal_dimension
from vibcli.notation.numbers import with_unit
from vibcli.symbolic.evaluation import multiprecision
from vibcli.symbolic.numeric_code import Compiled
from vibcli.symbolic.syntax import NameRef, QuantityRef

if TYPE_CHECKING:
    from vibcli.results.problem import Problem


class FreeMotions:
    """Those of one degree of freedom; PhysicsError of other scenes."""

    def __init__(self, problem: "Problem"):
        self.problem, self.scene = problem, problem.scene.resting
        if problem.spec.members:
            raise PhysicsError("members take part in small motions alone: their frequencies hang on no amplitude",
                               "ask for omega[1]")
        if len(self.scene.q) != 1:
            raise PhysicsError("how a frequency hangs on the amplitude is found of one degree of freedom, and this "
                               f"scene has {len(self.scene.q)}",
                               "ask for period(x) of a motion from `initial`, with motion: full")
        if not has_potential(self.scene):
            raise PhysicsError("the forces of this scene have no potential: it has no family of free motions",
                               "loads that follow the motion or change with time, and closed loops, are such")

    @cached_property
    def family(self) -> FamilyOfMotions:
        """About the equilibrium."""
        at_rest = self.problem.configuration.at_rest
        q = self.scene.q[0]
        return FamilyOfMotions(Well(self.scene, self.problem.numeric.floats), at_rest[q.name],
                      self.scene.unit_of(self.scene.coordinates[0]))

    def omega(self, number: int, tree: Any, amplitude: float) -> tuple[float, float]:
        """(angular frequency [rad/s], relative error) of the motion in which a signal has an amplitude."""
        if number != 1:
            raise PhysicsError(f"one degree of freedom has one family of free motions, found the index {number}",
                               "write backbone[1]")
        if not amplitude > 0:
            raise PhysicsError("an amplitude is positive", "as the amplitude tends to 0, ask for omega[1]")
        period, error = self._period(self._motion(tree, amplitude).ends)
        return tau / period, error + 2.0**-52

    def _period(self, ends):
        with_digits = self.problem.numeric.values(multiprecision())
        return period_of(self.family.well, self.scene, with_digits, (ends[1].q, 0.0), ends)

    def curve(self, tree: Any, amplitudes: "Sequence[float]") -> list[BackbonePoint]:
        """Those of the first family with these amplitudes."""
        signal = self._signal(tree)
        return [self._point(self._motion(tree, amplitude, signal), amplitude) for amplitude in amplitudes]

    def _point(self, motion, amplitude):
        period, error = self._period(motion.ends)
        return BackbonePoint(amplitude, tau / period, self.family.energy(motion), error + 2.0**-52)

    def _motion(self, tree, amplitude, signal=None):
        try:
            return self.family.motion(signal or self._signal(tree), amplitude)
        except NoSuchAmplitude as error:
            if error.largest is None:
                raise
            raise PhysicsError(f"{error.message}: they end at {self._told(tree, error.largest)}",
                               "beyond that a motion passes a top of V, or nothing turns it round") from None

    def _told(self, tree, amplitude):
        spec = self.problem.spec
        known = isinstance(tree, NameRef) and not tree.primes
        dimension = known and (spec.dimensions.of(tree.name) if tree.name in spec.coordinates else
                               signal_dimension(spec, tree.name))
        return with_unit(amplitude, dimension) if dimension else f"{amplitude:.6g} in SI units"

    def _signal(self, tree):
        from vibcli.mechanics.signals import moving
        from vibcli.symbolic.semantics import lower

        system, table = self.problem.system, self.scene.table

        def symbol(name, primes, part):
            if isinstance(part, QuantityRef):
                raise PhysicsError(f"'{part.text}' has no amplitude in a family of motions",
                                   "ask for the amplitude of a coordinate, of a place or of a spring's force")
            found = self.scene.parameters.nodes.get(name) if not primes else None
            return found if found is not None else moving(system, name, primes)

        node = lower(tree, table, symbol)
        compiled = Compiled(self.scene, self.problem.numeric.floats, None, [node])
        return function_of_place(self.family.well, compiled, node)
