"""The steps from the figure to the equations of small oscillations: coordinates, energies body by body and spring by
spring, rest, Lagrange's derivatives, the equations."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.base.errors import PhysicsError
from vibcli.report.blocks import Factor, Name, SumOfTerms, Words
from vibcli.report.steps.bodies import Bodies, EnergyPart
from vibcli.report.steps.connections import Acting, Connections
from vibcli.report.steps.small import about_rest
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.report.steps.turning import TurningFrames
from vibcli.report.steps.written_out import WrittenOut
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

MOST = 8            # coordinates, beyond which the steps are no page to read
ALIKE = 1e-9        # relative: of what is added up element by element, and of the engine's
UNTOLD = "what moves, stores energy or acts in this scene is not told apart step by step"
HINT = "leave --steps out for the equations and their solution"


class SmallEquations(NamedTuple):
    """M, C, G, K as {(i, j): node}, {i: Q(t)}, and the numbers of the lines that tell the equations."""

    M: Any
    C: Any
    G: Any
    K: Any
    drive: Any
    lines: list[int]


class Derivation:
    """The steps to the equations of small oscillations of a problem, written on a sheet."""

    def __init__(self, problem: "Problem", sheet: WorkedSolution):
        _require_told(problem)
        self.problem, self.sheet, self.scene = problem, sheet, problem.scene
        self.about, self.letters = about_rest(problem)
        self.names = self.scene.coordinates

    def equations(self) -> SmallEquations:
        """Write down all steps; their matrices are those of the engine."""
        self._coordinates()
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
        M, C, G, K = self._held(self._added(bodies.mass_matrix(), written.quadratic("T")), slowed,
                                connections.stiffness(acting), turning.gyroscopic())
        if self._driven(turning.names):
            energies = self._driven_energies(T, V, Phi, acting, (M, C, G, K))
            return self._lagrange(M, C, G, K, [part.line for part in (*T, *V, *Phi)], energies)
        sums = [self._sum("T", T, self.about.squared(M, self.scene.v)),
                self._sum("V", V, self.about.squared(K, self.scene.q), rest),
                self._sum("Phi", Phi, self.about.squared(slowed, self.scene.v))]
        return self._lagrange(M, C, G, K, [line for line in sums if line])

    def _driven(self, turning):
        """Is something driven, but for frames that turn steadily?"""
        scene, time = self.scene, self.scene.time
        stretched = (*scene.springs, *scene.dampers, *scene.laws)
        return any(time in gradient(term.s) for term in scene.inertias if term.owner not in turning) or any(
            textbook(term.s).mask & time.mask for term in stretched if time in gradient(term.s))

    def _driven_energies(self, T, V, Phi, acting, matrices):
        """T, V and Φ of what is driven; PhysicsError where Lagrange's equations of these, written down term by term,
        are not those of the engine."""
        table, scene = self.scene.table, self.scene
        known = {one.shown: one.tension for one in acting if one.shown.op == "symbol"}
        total = [table.total([part.node for part in parts if part.node is not None]) for parts in (T, V, Phi)]
        energies = substitute(total, known)
        for i, (q, v) in enumerate(zip(scene.q, scene.v, strict=True)):
            mine = self._equation(energies, q, v)
            loads = [(term.weight - term.steady) * self.about.small(term.s).slopes.get(i, table.zero)
                     for term in scene.forces]
            engine = [self._left(matrices, i), -self.problem.symbolic.excitation.get(i, table.zero)]
            if not self.about.agree_in_motion(mine, [*loads, *engine]):
                raise PhysicsError(UNTOLD, HINT)
        return energies

    def _equation(self, energies, q, v):
        """The terms of d/dt ∂T/∂q̇ − ∂T/∂q + ∂V/∂q + ∂Φ/∂q̇."""
        T, V, Phi = energies
        zero = self.scene.table.zero
        return [self.scene.rate(gradient(T).get(v, zero)), -gradient(T).get(q, zero), gradient(V).get(q, zero),
                gradient(Phi).get(v, zero)]

    def _left(self, matrices, i):
        M, C, G, K = matrices
        return self._row(M, i, self.scene.a) + self._row(C, i, self.scene.v) + self._row(
            G, i, self.scene.v) + self._row(K, i, self.scene.q)

    def _added(self, one, other):
        """The sum of two matrices, simplified."""
        if not other:
            return one
        zero = self.scene.table.zero
        found = {pair: self.about.tidy(one.get(pair, zero) + other.get(pair, zero)) for pair in {**one, **other}}
        return {pair: node for pair, node in found.items() if not node.is_zero}

    def _held(self, *mine):
        """M, C, G, K of the engine; PhysicsError where what was told element by element, M, C, K and G, is not all."""
        symbolic = self.problem.symbolic
        if symbolic.linearisable:
            M, C, G, K = symbolic.matrices
            if self.problem.spec.get("damping") is not None:
                mine = (mine[0], self._damped_as_a_whole(C), *mine[2:])
            agree = all(self._same(own, found) for own, found in zip(mine, (M, C, K, G), strict=True))
        else:
            M, C, G, K = self.problem.configuration.linear_system.matrices()
            agree = not any(G.values()) and all(self._alike(*pair) for pair in zip(mine, (M, C, K, G), strict=True))
        if not agree:
            raise PhysicsError(UNTOLD, HINT)
        return (M, C, G, K) if symbolic.linearisable else (mine[0], mine[1], {}, mine[2])

    def _damped_as_a_whole(self, C):
        """What `damping:` adds to C, which is told."""
        alpha, beta = (self.scene.lower(one) for one in self.problem.spec.get("damping")["proportional"])
        parts = [part for node, name in ((alpha, "M"), (beta, "K")) if not node.is_zero
                 for part in (" + ", Factor(node), f"·{name}")][1:]
        self.sheet.write(Words("`damping:` adds  "), *parts, Words("  to the damping matrix"), settles="damping")
        return C

    def _same(self, own, found):
        zero = self.scene.table.zero
        return all(self.about.same(own.get(pair, zero), found.get(pair, zero)) for pair in {*own, *found})

    def _alike(self, own, found):
        """Are the expressions of a matrix its numbers, but for rounding beside those on its diagonal?"""
        values = {pair: self.about.value(node) for pair, node in own.items()}
        for i, j in {*values, *found}:
            size = abs(found.get((i, i), 0.0) * found.get((j, j), 0.0))**0.5 + abs(found.get((i, j), 0.0))
            if not abs(values.get((i, j), 0.0) - found.get((i, j), 0.0)) <= ALIKE * size:
                return False
        return True

    def _coordinates(self):
        from vibcli.report.sections.parameters import words_of

        for name in self.names:
            at = self.scene.drawn[self.scene.symbol(name)]
            drawn = ("zero as drawn",) if at.is_zero else ()
            about = words_of(self.problem, name)
            self.sheet.write(Name(name), Words(":  " + about + ",  " * bool(about and drawn)), *map(Words, drawn),
                             *(() if at.is_zero else (Words("  as drawn "), Name(name), " = ", at)), settles=name)
        for name, letter in self.letters.items():
            value = self.problem.configuration.equilibrium.values[name]
            self.sheet.write(Words("at rest "), Name(name), " = ", Name(letter), *number(value),
                             Words("  by a search for where all forces balance; "), Name(name),
                             Words(" is counted from there from now on"), settles=letter, value=value)
        self._tied()

    def _tied(self):
        """What constraints leave of the other coordinates; those that close loops, to the second order from rest."""
        loops = self.scene.loops
        for name, node in self.scene.dependent.items():
            if loops is None or name not in loops.names:
                self.sheet.write(Name(name), " = ", textbook(node), Words("   (by the constraints)"), settles=name,
                                 node=node)
        if loops is None:
            return
        loose = self.problem.system.scene_with_multipliers
        uses = [self.sheet.write(Words(f"'{constraint.whole}' holds:  "), textbook(constraint.node), " = 0",
                                 settles=f"condition {constraint.name}") for constraint in loose.constraints]
        for name in loops.names:
            small = self.about.small(self.scene.dependent[name])
            rate, moves = self.about.first(small, self.scene.v), self.about.first(small, self.scene.q)
            self.sheet.write(Words("so from rest  "), Name(name), " = ", moves + self.about.bent(small), " + …",
                             Words("   (second order),  "), Name(name + "'"), " = ", rate, settles=name, uses=uses,
                             node=moves)

    def _rest(self, acting: "list[Acting]") -> int | None:
        """The balance of forces at rest, and the tensions that follow; the number of its last line."""
        line = None
        loaded = [one for one in acting if not one.tension.is_zero]
        for i, name in enumerate(self.names):
            terms = [one.shown * one.s.slopes[i] for one in loaded if i in one.s.slopes]
            if not self.about.cancel([one.tension * one.s.slopes[i] for one in loaded if i in one.s.slopes]):
                raise PhysicsError(UNTOLD, HINT)
            if terms:
                line = self.sheet.write(Words("at rest  "), "∂V/∂", Name(name), " = ", SumOfTerms(tuple(terms)), " = 0",
                                        uses=[one.line for one in loaded])
        for one in loaded:
            if one.k is not None:
                self._tension(one, line)
        return line

    def _tension(self, one, line):
        about, unit = self.about, self._unit_of_force(one.name)
        force = about.value(one.tension)
        self.sheet.write(Words("so "), Name(one.shown.name), " = ", one.tension, *(() if force is None else number(
            force, unit)), *(self._deflection(one, unit) if one.linear else ()), settles=one.shown.name,
            node=one.tension, value=force, unit=unit, uses=[line])

    def _deflection(self, one, unit):
        """Parts of N/k of a linear spring."""
        delta = self.about.tidy(one.tension / one.k)
        value = self.about.value(delta)
        told = () if value is None else (*number(value, "rad" if unit == "N·m" else "m"),
                                         Words(" (lengthened)" if value > 0 else " (shortened)"))
        return Words(f",  {one.name} being deflected by "), delta, *told

    def _unit_of_force(self, name):
        record = (self.problem.spec.get("springs") or {}).get(name, {})
        return "N·m" if "torsion" in record else "N"

    def _sum(self, letter: str, parts: "Sequence[EnergyPart]", node: "Node", rest: int | None = None) -> int | None:
        """T, V or Φ of all; nothing where one part is all of it."""
        if not parts or (len(parts) == 1 and rest is None):
            return parts[0].line if parts else None
        uses = [part.line for part in parts]
        names = list(dict.fromkeys(part.letter for part in parts))
        several = [part for name in names for part in (" + ", Name(name))][1:] if len(names) > 1 else []
        why = [Words("   (the terms of the first order vanish at rest)")] if rest else []
        return self.sheet.write(Name(letter), " = ", *several, " = " * bool(several), node, *why, settles=letter,
                                node=node, uses=[*uses, rest])

    def _lagrange(self, M, C, G, K, uses, driven=None) -> SmallEquations:
        drive = self.problem.symbolic.excitation if self.scene.timed else {}
        lines = []
        for i, name in enumerate(self.names):
            if len(self.names) == 1:
                self._derivatives(i, name, M, C, K, uses, driven)
            left = self._left((M, C, G, K), i)
            head = () if len(self.names) == 1 else (Name(name), Words(":  "))
            lines.append(self.sheet.write(*head, left, " = ", drive.get(i, self.scene.table.zero),
                                          settles=f"equation[{name}]", node=left, uses=uses))
        return SmallEquations(M, C, G, K, drive, lines)

    def _row(self, matrix, i, symbols):
        return self.scene.table.sum(*((node * symbols[j], 1) for (k, j), node in matrix.items() if k == i))

    def _derivatives(self, i, name, M, C, K, uses, driven):
        """∂T/∂q̇, its rate, ∂V/∂q and ∂Φ/∂q̇ of one degree of freedom; `driven`: T, V and Φ of one that is."""
        scene, q, v = self.scene, Name(name), Name(name + "'")
        if driven is None:
            p, change, spring, damper = (self._row(M, i, scene.v), self._row(M, i, scene.a), self._row(K, i, scene.q),
                                         self._row(C, i, scene.v))
        else:
            zero = scene.table.zero
            p, spring, damper = (textbook(gradient(node).get(x, zero)) for node, x in zip(
                driven, (scene.v[i], scene.q[i], scene.v[i]), strict=True))
            change = textbook(scene.rate(p))
        if M:
            self.sheet.write("∂T/∂", v, " = ", p, Words(",  "), "d/dt ∂T/∂", v, " = ", change, Words(",  "), "∂T/∂", q,
                             " = 0", uses=uses)
        damped = [Words(",  "), "∂Φ/∂", v, " = ", damper] if C else []
        self.sheet.write("∂V/∂", q, " = ", spring, *damped, uses=uses)


def _require_told(problem):
    """PhysicsError of scenes whose steps are not told."""
    scene, system = problem.scene, problem.system
    if scene.pieces or scene.members:
        raise PhysicsError("the steps of members with distributed inertia or stiffness are not told one by one", HINT)
    if scene.loops is not None and scene.timed and scene.vibrating is not scene:
        raise PhysicsError("the steps of closed loops that are driven are not told one by one", HINT)
    if system.sticking is not None:
        raise PhysicsError("the steps of scenes that dry friction holds are not told one by one", HINT)
    if scene.matrices:
        raise PhysicsError("matrices that the file writes out have no steps", HINT)
    if not scene.q:
        raise PhysicsError("nothing moves freely in this scene: there are no steps to an equation of motion", HINT)
    if len(scene.q) > MOST:
        raise PhysicsError(f"steps are told of up to {MOST} coordinates, and this scene has {len(scene.q)}", HINT)

