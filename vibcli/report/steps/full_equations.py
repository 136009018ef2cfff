"""The steps from the figure to the equations of motion, unexpanded: energies of each element, Lagrange's derivatives
of each coordinate, of closed loops Lagrange's equations of the first kind."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, cast

from vibcli.notation.equation_sides import sides
from vibcli.report.blocks import Name, Words
from vibcli.report.sections.equations_of_motion import WITHOUT
from vibcli.report.steps.bodies import Bodies
from vibcli.report.steps.full_energies import FullEnergies
from vibcli.report.steps.held import HINT, UNTOLD, Untold
from vibcli.report.steps.in_motion import InMotion
from vibcli.report.steps.step import WorkedSolution, momentum, slope_by
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.report.steps.bodies import EnergyPart
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


class FullEquations:
    """The steps to the equations of motion of a problem, written on a sheet."""

    def __init__(self, problem: "Problem", sheet: WorkedSolution) -> None:
        self.problem, self.sheet, self.motion = problem, sheet, InMotion(problem)
        self.scene = self.motion.scene
        self.energies = FullEnergies(self.motion, sheet)

    def write(self, conditions: list[int]) -> list[int]:
        """Write down all steps that follow the coordinates and the `conditions` of closed loops; the numbers of the
        lines that tell the equations."""
        energies = self.energies
        given = [*energies.given("T")]
        T = [*Bodies(self.motion, self.sheet, bool(given)).kinetic(), *given]
        V = [*energies.stored(), *energies.given("V")]
        Phi = [*energies.dissipated(), *energies.given("Phi")]
        known = self.problem.symbolic.energies
        total = [known["T"], self._total(V) if self.scene.laws else known["V"], self._total(Phi)]
        Q = energies.loads()
        uses = [energies.sum(letter, parts, node) for letter, parts, node in zip(
            ("T", "V", "Phi"), (T, V, Phi), total, strict=True)]
        sums = [self._total(parts) for parts in (T, V, Phi)]
        conditions = [*conditions, *self._multipliers(conditions)]
        lines = [self._equation(i, sums, Q[i], [*uses, *conditions]) for i in range(len(self.scene.q))]
        if self.problem.spec.get("damping") is not None:
            self.sheet.write(Words(WITHOUT), uses=lines)
        return lines

    def _total(self, parts: "Sequence[EnergyPart]") -> "Node":
        return self.scene.table.total([part.node for part in parts if part.node is not None])

    def _multipliers(self, conditions: list[int]) -> list[int]:
        """The line of the letters by which conditions add to the equations."""
        known = self.problem.symbolic.equations.multipliers
        if not known:
            return []
        told = [part for symbol, name in known.items() for part in (Words(",  "), symbol, Words(f" for '{name}'"))]
        return [self.sheet.write(Words("each condition adds to the equation of a coordinate its slope by that times a "
                                       "multiplier:  "), *told[1:], settles="multipliers", uses=conditions)]

    def _equation(self, i: int, sums: "Sequence[Node]", Q: "Node", uses: list[int | None]) -> int:
        """Lagrange's derivatives of a coordinate, then its equation: Untold where they are not that of the
        engine."""
        from vibcli.mechanics.lagrange import gyroscopic

        scene, zero = self.scene, self.scene.table.zero
        q, v, equations = scene.q[i], scene.v[i], self.problem.symbolic.equations
        T, V, Phi = (gradient(node) for node in sums)
        p = textbook(T.get(v, zero))
        terms = [textbook(scene.rate(p)), textbook(T.get(q, zero)), textbook(V.get(q, zero)),
                 textbook(Phi.get(v, zero))]
        ties = [textbook(gradient(constraint.node).get(q, zero)) * symbol
                for symbol, constraint in zip(equations.multipliers, scene.constraints, strict=False)]
        mine = [terms[0], -terms[1], *terms[2:], gyroscopic(scene, i), -Q, *ties]
        if not equations.full or not self.motion.agree(mine, [equations.full[i]], list(equations.multipliers)):
            raise Untold(UNTOLD, HINT)
        name = scene.coordinates[i]
        self._derivatives(name, p, terms, uses)
        left, right = map(self._short, sides(scene, equations.full[i]))
        head = () if len(scene.q) == 1 else (Name(name), Words(":  "))
        return self.sheet.write(*head, left, " = ", right, settles=f"motion[{name}]", node=equations.full[i],
                                uses=[*uses, self.sheet.last])

    def _short(self, node: "Node") -> "Node":
        return cast("Node", self.energies.short(node)[0])

    def _derivatives(self, name: str, p: "Node", terms: "Sequence[Node]", uses: list[int | None]) -> None:
        """∂T/∂q̇, its rate, ∂T/∂q, ∂V/∂q and ∂Φ/∂q̇."""
        p, change, bent, spring, damper = self.energies.short(p, *terms)
        if not terms[0].is_zero or not terms[1].is_zero:
            self.sheet.write(*momentum(self.sheet, name, p, change, bent), uses=uses)
        told: list[Any] = []
        for node, letter, by in ((spring, "V", name), (damper, "Phi", name + "'")):
            if not (hasattr(node, "is_zero") and node.is_zero):
                told += [*[Words(",  ")] * bool(told), *slope_by(self.sheet, letter, by), " = ", node]
        if told:
            self.sheet.write(*told, uses=uses)
