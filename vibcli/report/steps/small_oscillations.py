"""The steps from the figure to the equations of small oscillations: coordinates, energies body by body and spring by
spring, rest, Lagrange's derivatives, the equations."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.report.blocks import Name, SumOfTerms, Words
from vibcli.report.steps.bodies import Bodies, EnergyPart
from vibcli.report.steps.connections import Acting, Connections
from vibcli.report.steps.held import HINT, UNTOLD, SmallEquations, Untold, drive_of, held, left, row
from vibcli.report.steps.lettered import FORCE, SHOWN, is_told_by_number
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, momentum, number, slope_by
from vibcli.report.steps.turning import TurningFrames
from vibcli.report.steps.written_out import WrittenOut
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:

    from vibcli.scene.energy_terms import Damper, Spring
    from vibcli.scene.laws import Law
    from vibcli.symbolic.node import Node

LENGTH, TURN = (("m_e", "kg"), ("k_e", "N/m")), (("J_e", "kg·m²"), ("k_e", "N·m/rad"))    # of q̈ and q
LONG = 20       # letters of such a factor, beyond which it has one of its own
SUMMED = 60     # letters of T of what is driven, up to which its parts are added


class Derivation:
    """The steps to the equations of small oscillations of a problem, written on a sheet."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution) -> None:
        self.about, self.sheet, self.problem, self.scene = about, sheet, about.problem, about.scene
        self.names = self.scene.coordinates

    def equations(self) -> SmallEquations:
        """Write down all steps that follow the coordinates; their matrices are those of the engine."""
        written = WrittenOut(self.about, self.sheet)
        turning = TurningFrames(self.about, self.sheet)
        bodies = Bodies(self.about, self.sheet, "T" in written or bool(turning.names), turning.names)
        T = [*bodies.kinetic(), *turning.kinetic(), *written.of_speeds("T")]
        connections = Connections(self.about, self.sheet, "V" in written)
        stored = [*connections.stored(), *connections.loads(), *written.potential(), *turning.potential()]
        V, acting = [energy for energy, _ in stored], [one for _, one in stored]
        Phi = [*connections.dissipated(), *written.of_speeds("Phi")]
        rest = self._rest(acting)
        slowed = self._added(connections.damping_matrix(), written.quadratic("Phi"))
        M, C, G, K = held(self.about, self.sheet, self._added(bodies.mass_matrix(), written.quadratic("T")), slowed,
                                connections.stiffness(acting), turning.gyroscopic())
        if self._driven(turning.names):
            energies = self._driven_energies(T, V, Phi, acting, (M, C, G, K))
            kinetic, lines = textbook(energies[0]), [part.line for part in (*T, *V, *Phi)]
            if all(part.node is not None for part in T) and letters(kinetic) <= SUMMED:
                lines.append(self._sum("T", T, kinetic))
            return self._lagrange(M, C, G, K, lines, energies)
        short, (M, K) = self._shortened(M, K)
        sums = [self._sum("T", T, self.about.squared(M, self.scene.v)),
                self._sum("V", V, self.about.squared(K, self.scene.q), rest),
                self._sum("Phi", Phi, self.about.squared(slowed, self.scene.v))]
        return self._lagrange(M, C, G, K, [line for line in (*short, *sums) if line], at_once=bool(short))

    def _shortened(self, *matrices: "dict[tuple[int, int], Node]"
                   ) -> "tuple[list[Any], Sequence[dict[tuple[int, int], Node]]]":
        """Numbers of lines, and M and K: of one degree, where coefficients at a place have letters, a letter for each
        that is long; not of what goes out in variants, which asks for M and K themselves."""
        about, name = self.about, self.names[0]
        if len(self.names) > 1 or not about.abbreviates or self.problem.spec.get("variants") is not None:
            return [], matrices
        kinds = LENGTH if self.problem.system.dimension(name) else TURN
        lines, found = [], []
        for matrix, (wanted, unit) in zip(matrices, kinds, strict=True):
            node = matrix.get((0, 0))
            if node is not None and letters(node) > LONG:
                letter, value = self.sheet.letter(wanted), about.value(node)
                lines.append(self.sheet.write(*([] if lines else [Words("for short:  ")]), Name(letter), " = ", node,
                                              *number(value, unit), settles=letter, node=node, value=value, unit=unit,
                                              joined=bool(lines)))
                about.know(about.letter(letter), value)
                matrix = {(0, 0): about.letter(letter)}
            found.append(matrix)
        return lines, found

    def _driven(self, turning: set[Any]) -> bool:
        """Is something driven, but for frames that turn steadily?"""
        scene, time = self.scene, self.scene.time
        stretched: tuple[Spring | Damper | Law, ...] = (*scene.springs, *scene.dampers, *scene.laws)
        return any(time in gradient(term.s) for term in scene.inertias if term.owner not in turning) or any(
            textbook(term.s).mask & time.mask for term in stretched if time in gradient(term.s))

    def _driven_energies(self, T: list[EnergyPart], V: list[EnergyPart], Phi: list[EnergyPart], acting: list[Acting],
                         matrices: tuple[Any, ...]) -> "list[Node]":
        """T, V and Φ of what is driven; Untold where Lagrange's equations of these, written down term by term,
        are not those of the engine."""
        table, scene = self.scene.table, self.scene
        known = {one.shown: one.tension for one in acting if one.shown.op == "symbol"}
        total = [table.total([part.node for part in parts if part.node is not None]) for parts in (T, V, Phi)]
        energies = substitute(total, known)
        for i, (q, v) in enumerate(zip(scene.q, scene.v, strict=True)):
            mine = self._equation(energies, q, v)
            loads = [(term.weight - term.steady) * self.about.small(term.s).slopes.get(i, table.zero)
                     for term in scene.forces]
            engine = [left(self.scene, matrices, i), -drive_of(self.problem).get(i, table.zero)]
            if not self.about.agree_in_motion(mine, [*loads, *engine]):
                raise Untold(UNTOLD, HINT)
        return energies

    def _equation(self, energies: "list[Node]", q: "Node", v: "Node") -> "list[Node]":
        """The terms of d/dt ∂T/∂q̇ − ∂T/∂q + ∂V/∂q + ∂Φ/∂q̇."""
        T, V, Phi = energies
        zero = self.scene.table.zero
        return [self.scene.rate(gradient(T).get(v, zero)), -gradient(T).get(q, zero), gradient(V).get(q, zero),
                gradient(Phi).get(v, zero)]

    def _added(self, one: "dict[tuple[int, int], Node]", other: Mapping[Any, Any]) -> "dict[tuple[int, int], Node]":
        """The sum of two matrices, simplified."""
        if not other:
            return one
        zero = self.scene.table.zero
        found = {pair: self.about.tidy(one.get(pair, zero) + other.get(pair, zero)) for pair in {**one, **other}}
        return {pair: node for pair, node in found.items() if not node.is_zero}

    def _rest(self, acting: "list[Acting]") -> int | None:
        """The balance of forces at rest, and the tensions that follow; the number of its last line."""
        line = None
        loaded = [one for one in acting if not one.tension.is_zero]
        for i, name in enumerate(self.names):
            terms = self._together([one for one in loaded if i in one.s.slopes], i)
            if not self.about.cancel([one.tension * one.s.slopes[i] for one in loaded if i in one.s.slopes]):
                raise Untold(UNTOLD, HINT)
            if terms:
                line = self.sheet.write(Words("at rest  "), *slope_by(self.sheet, "V", name), " = ", SumOfTerms(
                    tuple(terms)), " = 0", uses=[one.line for one in loaded])
        beside = line is not None and len(self.names) == 1
        uses = [line, *(one.line for one in loaded)] if beside else [line]
        for i, shown in enumerate(dict.fromkeys(one.shown for one in loaded if one.k is not None)):
            self._tension(next(one for one in loaded if one.shown is shown), uses, joined=beside or i > 0)
        return line

    def _together(self, acting: Sequence[Acting], i: int) -> "list[Node]":
        """What each force at rest adds to the balance of a coordinate, those of like springs together where they do
        not cancel."""
        slopes: dict[Any, Any] = {}
        for one in acting:
            slopes.setdefault(one.shown, []).append(one.s.slopes[i])
        found = [shown * self.about.tidy(self.scene.table.total(several)) for shown, several in slopes.items()]
        return [term for term in found if not term.is_zero] or [one.shown * one.s.slopes[i] for one in acting]

    def _tension(self, one: Acting, balance: list[int | None], joined: bool) -> None:
        """The tension of a spring at rest: what the balance leaves for it, or what its law gives there."""
        about, unit = self.about, self._unit_of_force(one.name)
        follows = (self.problem.spec.get("springs") or {}).get(one.name, {}).get("preload") == "static"
        words = "so " if follows else "" if joined else "at rest  "
        places = [step.number for step in self.sheet.steps if step.settles.startswith("equilibrium[")]
        force = about.value(one.tension)
        told = () if force is None else number(force, unit)
        most = FORCE if one.linear else SHOWN
        told = told if is_told_by_number(one.tension, force, most) else (" = ", one.tension, *told)
        self.sheet.write(Words(words), Name(one.shown.name), *told,
                         *(self._deflection(one, unit) if one.linear else ()), settles=one.shown.name,
                         node=one.tension, value=force, unit=unit, uses=balance if follows else places,
                         joined=joined, aside=True)

    def _deflection(self, one: Acting, unit: str) -> "tuple[Node | str | Words, ...]":
        """Parts of N/k of a linear spring."""
        delta = self.about.tidy((one.kept if self.about.is_long(one.tension) else one.tension) / one.k)
        value = self.about.value(delta)
        told = () if value is None else (*number(value, "rad" if unit == "N·m" else "m"),
                                         Words(" (lengthened)" if value > 0 else " (shortened)"))
        return Words(f",  {one.name} being deflected by "), delta, *told

    def _unit_of_force(self, name: str) -> str:
        record = (self.problem.spec.get("springs") or {}).get(name, {})
        return "N·m" if "torsion" in record else "N"

    def _sum(self, letter: str, parts: "Sequence[EnergyPart]", node: "Node", rest: int | None = None) -> int | None:
        """T, V or Φ of all; nothing where one part is all of it."""
        names = list(dict.fromkeys(part.letter for part in parts))
        if not parts or (len(names) == 1 and rest is None):
            return parts[0].line if parts else None
        uses = [part.line for part in parts]
        several = [part for name in names for part in (" + ", Name(name))][1:] if len(names) > 1 else []
        why = [Words("   (the terms of the first order vanish at rest)")] if rest else []
        letter = self.sheet.letter(letter)
        return self.sheet.write(Name(letter), " = ", *several, " = " * bool(several), node, *why, settles=letter,
                                node=node, uses=[*uses, rest])

    def _lagrange(self, M: "dict[tuple[int, int], Node]", C: "dict[tuple[int, int], Node]", G: dict[Any, Any],
                  K: "dict[tuple[int, int], Node]", uses: list[int], driven: "list[Node] | None" = None,
                  at_once: bool = False) -> SmallEquations:
        drive = drive_of(self.problem)
        lines = []
        for i, name in enumerate(self.names):
            if len(self.names) == 1:
                self._derivatives(i, name, M, C, K, uses, driven, at_once)
            node = left(self.scene, (M, C, G, K), i)
            limp = [Words("to the first order:  ")] if self.scene.laws and not K else []
            head = [*limp, *([] if len(self.names) == 1 else [Name(name), Words(":  ")])]
            lines.append(self.sheet.write(*head, node, " = ", drive.get(i, self.scene.table.zero),
                                          settles=f"equation[{name}]", node=node, uses=uses))
        return SmallEquations(M, C, G, K, drive, lines)

    def _derivatives(self, i: int, name: str, M: "dict[tuple[int, int], Node]", C: "dict[tuple[int, int], Node]",
                     K: "dict[tuple[int, int], Node]", uses: list[int], driven: "Sequence[Node] | None",
                     at_once: bool) -> None:
        """∂T/∂q̇, its rate, ∂V/∂q and ∂Φ/∂q̇ of one degree of freedom, those of V and Φ in the same line where
        `at_once`; `driven`: T, V and Φ of one that is."""
        scene = self.scene
        if driven is None:
            p, change, spring, damper = (row(scene, matrix, i, symbols) for matrix, symbols in (
                (M, scene.v), (M, scene.a), (K, scene.q), (C, scene.v)))
        else:
            zero = scene.table.zero
            p, spring, damper = (textbook(gradient(node).get(x, zero)) for node, x in zip(
                driven, (scene.v[i], scene.q[i], scene.v[i]), strict=True))
            change = textbook(scene.rate(p))
        if M:
            self.sheet.write(*momentum(self.sheet, name, p, change, "0"), uses=uses)
        damped = [Words(",  "), *slope_by(self.sheet, "Phi", name + "'"), " = ", damper] if C else []
        self.sheet.write(*slope_by(self.sheet, "V", name), " = ", spring, *damped, uses=uses, joined=at_once)
