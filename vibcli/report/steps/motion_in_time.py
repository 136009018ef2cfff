"""The steps from the equation of motion of one coordinate to its motion in time, without small oscillations: where
nothing takes energy away

    ½ m(q) q̇² + V(q) = E,   turning places where V = E,   T = 2 ∫ dq/|q̇| between these;

where dry friction R brakes a mass on a spring, half cycles about (F ∓ R)/k (Rao 2011, section 2.9)."""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.report.blocks import Name, SumOfTerms, Words
from vibcli.report.steps.agreement import same_in_motion, samples_of
from vibcli.report.steps.full_energies import potential_of_weights
from vibcli.report.steps.in_motion import short_form
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np

    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import NameRef

LOOKED_AT = 400         # places between two turning places, of which V is nowhere below that at rest
CLOSE, ROUNDING = 1e-9, 4e-16          # relative; of a float and what is read off one


def tell_motion(problem: "Problem", sheet: WorkedSolution, lines: "Sequence[int]") -> None:
    """Write down the integral of energy of a motion that a scene starts and follows without small oscillations; nothing
    of one that is damped, driven, or of several coordinates."""
    from vibcli.analyses.nonlinear.period import is_conservative

    scene, asked = problem.scene, problem.spec.motion == "full" and problem.spec.in_full
    if not asked or problem.spec.get("initial") is None or len(scene.q) != 1 or not is_conservative(scene):
        return
    before = len(sheet.steps)
    try:
        EnergyIntegral(problem, sheet).write(lines)
    except PhysicsError:
        del sheet.steps[before:]


class EnergyIntegral:
    """½ m(q) q̇² + V(q) = E of the one coordinate of a problem, written on a sheet."""

    def __init__(self, problem: "Problem", sheet: WorkedSolution) -> None:
        from vibcli.analyses.nonlinear.well import Well

        self.problem, self.sheet, self.scene = problem, sheet, problem.scene
        self.floats = None if problem.numeric.has_free_symbols else problem.numeric.floats
        self.name, = problem.scene.coordinates
        self.q, self.v = problem.scene.q[0], problem.scene.v[0]
        self.well = Well(problem.scene, self.floats or samples_of(problem, {})[0])
        V, M = self.well.nodes
        self.V, self.M = textbook(V - potential_of_weights(self.scene)[1]), textbook(M)
        self.unit = "m" if problem.system.dimension(self.name) else "rad"

    def write(self, lines: "Sequence[int]") -> None:
        """Write down all of it; nothing where it is no integral of the equation of the engine."""
        if not self._holds():
            return
        energy = self._energy(lines)
        if self.floats is None:
            return
        place, speed = (float(values[self.name]) for values in self.problem.initial.start)
        E = self._at_start(place, speed)
        start = self.sheet.write(Words("at the start  "), Name(self.name), *number(place, self.unit), Words(",  "),
                                 Name(self.name + "'"), *number(speed, f"{self.unit}/s"), Words(":  "), self.E,
                                 *number(E, "J"), settles=self.E.name, value=E, unit="J", uses=[energy])
        self._turning(place, speed, E, start)

    def _holds(self) -> bool:
        """Is q̇ times the equation of motion the rate of ½ m q̇² + V?"""
        equations = self.problem.symbolic.equations.full
        if not equations:
            return False
        rate = self.scene.rate(self.M * self.v ** 2 / 2 + self.V)
        return same_in_motion(self.problem, [equations[0] * self.v], [rate])

    def _energy(self, lines: "Sequence[int]") -> int:
        """The line of the integral, solved for the speed."""
        self.E = self.scene.table.parameter(self.sheet.letter("E"), positive=False)
        kinetic = short_form(self.M * self.v ** 2 / 2)
        line = self.sheet.write(Words("nothing takes energy away; the equation times "), Name(self.name + "'"), Words(
            ", integrated:  "), SumOfTerms((kinetic, self.V)), " = ", self.E, settles="integral of energy", uses=lines)
        node = 2 * (self.E - self.V) / self.M
        return self.sheet.write(self.v ** 2, " = ", node, settles=f"{self.name}'^2", node=node, uses=[line])

    def _at_start(self, place: float, speed: float) -> float:
        """½ m q̇² + V at the start, zero where the place is a float too coarse to tell it from that."""
        slope = gradient(self.V).get(self.q, self.scene.table.zero)
        kinetic, potential, tilt = evaluate([self.M * self.v ** 2 / 2, self.V, slope], Floats, {
            **self.floats, self.q.name: place, self.v.name: speed})
        known = abs(kinetic) + abs(potential) + abs(tilt * place)
        return kinetic + potential if abs(kinetic + potential) > ROUNDING * known else 0.0

    def _turning(self, place: float, speed: float, E: float, start: int) -> None:
        """Where it turns, how long it takes, and how fast it is where V is least."""
        from vibcli.analyses.nonlinear.turning_points import turning_point

        kinetic = 0.5 * float(self.well.inertia(_at(place))[0]) * speed ** 2
        low, high = (turning_point(self.well, place, kinetic, side).q for side in (-1, 1))
        period, _ = self.problem.response.period(self._tree())
        found, between = (evaluate([self.V], Floats, {**self.floats, self.q.name: q})[0] for q in (
            low, (low + high) / 2))
        if abs(found - E) > CLOSE * (abs(E) + abs(found) + abs(between) + kinetic):
            return
        name = Name(self.name)
        turns = self.sheet.write(Words("it turns where "), Name(self.name + "'"), " = 0", Words(":  "), name, *number(
            low, self.unit), Words(" and "), name, *number(high, self.unit), settles="turning places", uses=[start])
        self._fastest(low, high, E, turns)
        self.sheet.write(Words("twice the time from one to the other, the integral of "), "d", name, "/|", Name(
            self.name + "'"), "|", Words(", is the period:  "), Name(self.sheet.letter("T", "E")), *number(period, "s"),
            settles=f"period({self.name})", value=period, unit="s", uses=[turns])

    def _tree(self) -> "NameRef":
        from vibcli.symbolic.syntax import NameRef

        return NameRef(0, len(self.name), self.name, 0)

    def _fastest(self, low: float, high: float, E: float, line: int) -> None:
        """The greatest speed, where m is constant and V nowhere less than at rest."""
        import numpy as np

        rest = self.problem.configuration.equilibrium.values[self.name]
        if self.q in gradient(self.M) or not low <= rest <= high:
            return
        places = np.linspace(low, high, LOOKED_AT)
        heights = [evaluate([self.V], Floats, {**self.floats, self.q.name: float(q)})[0] for q in (rest, *places)]
        if min(heights[1:]) < heights[0] - CLOSE * max(map(abs, heights)):
            return
        M = evaluate([self.M], Floats, self.floats)[0]
        value = (2 * (E - heights[0]) / M) ** 0.5
        self.sheet.write(Words("fastest where it can rest,  "), Name(self.name), *number(rest, self.unit),
                         Words(":  "), "|", Name(self.name + "'"), "|", *number(value, f"{self.unit}/s"), uses=[line],
                         settles=f"max({self.name}')", value=value, unit=f"{self.unit}/s")


def _at(place: float) -> "np.ndarray":
    import numpy as np

    return np.array([place])
