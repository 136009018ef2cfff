"""The steps of one member, or two end to end, that vibrate: differential equation, standing waves, what holds at each
station, constants, frequency equation, its first roots and their frequencies (Rao 2007, chapters 8, 9 and 11)."""

from collections.abc import Mapping, Sequence
from math import isclose, pi
from typing import TYPE_CHECKING, Any, cast

from vibcli.analyses.closed_form.hanging_strings import HangingString
from vibcli.analyses.closed_form.member_frequencies import chains, frequency_equations
from vibcli.analyses.closed_form.member_shapes import shape, unstrained
from vibcli.analyses.closed_form.textbook_equation import by_letters, sides
from vibcli.analyses.closed_form.tied_members import tied_equations
from vibcli.base.errors import PhysicsError
from vibcli.notation.names import lowered
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Factor, Name, WithNumbers, Words, factors
from vibcli.report.own_letters import own_letters
from vibcli.report.sections.frequency_equation import SIMPLE, whose
from vibcli.report.sections.hanging_string import hanging_alone
from vibcli.report.sections.members import carried, of_what_is_no_member
from vibcli.report.steps.ends import Ends
from vibcli.report.steps.hanging import general_solution
from vibcli.report.steps.held import HINT
from vibcli.report.steps.member_conditions import MemberConditions
from vibcli.report.steps.member_motion import tell_motion_of_members
from vibcli.report.steps.step import WorkedSolution, number, of_time, told
from vibcli.report.steps.told_modes import FIRST, asked_modes, moving_alike, told_modes
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.member_frequencies import FrequencyEquation
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.elements.member import Member
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

EXACT = 1e-9            # relative: of a root that a formula gives
HALVINGS = 60           # of the interval that holds one
NEAR, FAR = 1e-2, 1e4   # βL between which they are looked for
CLOSE, BESIDE = 1e-6, 1.05      # relative: of a frequency equation at its roots, and beside them
WITHOUT = "the steps of these members are not told: their frequency equation has no closed form here"
UNKNOWN = "the steps of these members are not told: their equilibrium is not known in letters"


class MemberSteps:
    """The steps of the members of a problem, written on a sheet."""

    def __init__(self, problem: "Problem", sheet: WorkedSolution) -> None:
        self.problem, self.sheet, self.scene, self.table = problem, sheet, problem.scene, problem.scene.table
        if not problem.symbolic.linearisable:
            raise PhysicsError(UNKNOWN, HINT)
        self.form = problem.symbolic.linearisation
        self.matrices = of_what_is_no_member(problem)
        self._conditions = MemberConditions(sheet, self.scene, self.form.pieces, self.matrices).write
        self.damped = bool(problem.symbolic.discrete_matrices[1]) or any(
            not one.piece.drag.is_zero for one in self.form.pieces)

    def write(self) -> None:
        """Write down all steps."""
        before, letters = len(self.sheet.steps), own_letters(self.scene)
        tell_motion_of_members(self.problem, self.sheet, self._write())
        self.sheet.steps[before:] = map(letters.step, self.sheet.steps[before:])

    def _write(self) -> list[Any]:
        if self.scene.loops is not None:
            self._by_a_search(self._others())
            return []
        parts = chains(self.form.pieces)
        found = frequency_equations(self.problem.symbolic)
        left = [piece for chain, one in zip(parts, found, strict=True) if one is None for piece in chain]
        groups = [tied or hanging_alone(self.problem, pieces)
                  for pieces, tied, _ in tied_equations(self.problem.symbolic, left)]
        alone = [one for one in found if one is not None]
        known = {i for one in alone for i in one.hung} | {i for one in groups if one for i in one.hung} | {
            i for one in groups if one for piece in one.pieces for row in piece.rows for i in row}
        mixed = len(groups) + bool(alone) > 1 and not self.problem.numeric.has_free_symbols
        if not found or None in groups or (groups and mixed) or not known.issuperset(self._others()):
            self._by_a_search(self._others())
            return []
        for one in alone:
            self._of_one(one)
        for one in groups:
            (self._of_hanging if isinstance(one, HangingString) else self._of_tied)(one)
        return [*alone, *groups]

    def _others(self) -> list[int]:
        """Coordinates that are no motion of a station."""
        own = {node for member in self.scene.members.values() for station in member.stations
               for node in member.motions(station)}
        return [i for i, q in enumerate(self.scene.q) if q not in own]

    def _by_a_search(self, others: Sequence[int]) -> None:
        """The equations alone, and the frequencies at which they hold."""
        if self.problem.numeric.has_free_symbols:
            raise PhysicsError(WITHOUT, HINT)
        lines = [line for name in self.scene.members for first, held in [self._conditions(name)]
                 for line in (first, *held)]
        tied = self._tied(self.scene.members)
        lines += [*(self._carried(i) for i in others if i not in tied), *self._bound(self.scene.members)]
        words = ", without what damps," if self.damped else ""
        told = f"they hold{words} at frequencies that a search finds, which misses none"
        self._searched(self.sheet.write(Words(told), settles="frequencies", uses=lines))

    def _searched(self, line: int) -> None:
        """The first frequencies."""
        for mode in told_modes(self.problem):
            if mode.omega:
                omega = float(mode.omega)
                self.sheet.write(f"ω{lowered(mode.index)}", *number(omega, "rad/s"), *of_time(self.sheet, omega),
                                 settles=f"omega[{mode.index}]", value=omega, unit="rad/s", uses=[line])

    def _bound(self, names: Any) -> list[int]:
        """The equations of what members are held to."""
        return [self._carried(i, "what it is held to:  ") for i in self._tied(names)]

    def _tied(self, names: "dict[str, Member]") -> list[int]:
        """Which coordinates move members that have them not of their own."""
        members = [self.scene.members[name] for name in names]
        tied = reachable([node for one in members for station in one.stations for node in one.motions(station)])
        return [i for i, q in enumerate(self.scene.q) if q in tied
                and not any(member.has_coordinate(q.name) for member in self.scene.members.values())]

    def _carried(self, i: int, words: str = "what it carries:  ") -> int:
        one = carried(i, self.form.pieces, self.matrices, self.scene)
        return self.sheet.write(Words(words), *one.parts, settles=f"equation[{self.scene.q[i].name}]")

    def _of_tied(self, found: Any) -> None:
        """Members that meet in one motion: the dynamic stiffness of each, and what they make together."""
        uses = [line for name in found.members for first, held in [self._conditions(name)] for line in (first, *held)]
        joint = [*map(self._carried, found.hung), *self._bound(found.members)]
        for letter, (order, power) in found.arguments.items():
            uses.append(self.sheet.write(Words("standing waves with  "), letter ** order, " = ", power,
                                         settles=letter.name, uses=uses))
        for letter, Z in found.letters.items():
            uses.append(self.sheet.write(Words("what acts on an end:  "), letter, " = ", Z, settles=letter.name,
                                         uses=uses))
        for letter, (above, below) in found.stiffnesses.items():
            parts = [Words("dynamic stiffness at the joint, "), *whose(found, letter), Words(":  ")]
            joint.append(self.sheet.write(*parts, letter, " = ", above / below, settles=letter.name, uses=uses))
        words = ", without what damps" if self.damped else ""
        rests = [part for letter in found.repeated for part in (
            Words(",  and where the denominator of "), letter, Words(" is 0, the joint at rest"))]
        line = self.sheet.write(Words(f"so the frequency equation{words}:  "), *factors(found.left), " = ",
                                found.right, *rests, settles="frequency equation", uses=joint)
        if not self.problem.numeric.has_free_symbols:
            self._searched(self.sheet.write(Words("its roots, by a search, which misses none"), settles="frequencies",
                                            uses=[line]))

    def _of_hanging(self, found: HangingString) -> None:
        """A string whose tension varies: Bessel functions of z, what its ends ask, the first roots."""
        uses = [line for name in found.members for first, held in [self._conditions(name)] for line in (first, *held)]
        uses += [*map(self._carried, found.hung), *self._bound(found.members)]
        line = general_solution(self.sheet, found, self.scene, uses)
        named = [part for letter, meant in found.named for part in (Words(",  "), letter, " = ", meant)]
        words = ", without what damps" if self.damped else ""
        line = self.sheet.write(Words(f"so the frequency equation{words}:  "), found.left, " = ", found.right, *named,
                                settles="frequency equation", uses=[line, *uses])
        if not self.problem.numeric.has_free_symbols:
            self._searched(self.sheet.write(Words("its roots, by a search, which misses none"), settles="frequencies",
                                            uses=[line]))

    def _of_one(self, found: "FrequencyEquation") -> None:
        conditions = [self._conditions(name) for name in found.members]
        hung = [*map(self._carried, found.hung), *self._bound(found.members)]
        waves = self._standing_waves(found, [first for first, _ in conditions])
        uses = [waves, *(line for _, lines in conditions for line in lines), *hung]
        ends = Ends(found, self.sheet)
        asked = ends.write(uses) if len(found.pieces) == 1 and not self._pressed(found) else None
        named, letters = by_letters(found, self.scene.parameters.nodes)
        left, right = sides(named)
        words = ", without what damps" if self.damped else ""
        how = f"so the frequency equation{words}:  " if asked else (
            f"the conditions leave constants other than zero{words + ',' * bool(words)} if  ")
        free = bool(unstrained(found))
        alike = [Words(",  and "), found.wave_number, Words(" = 0, as all of it may move alike")] * free
        line = self.sheet.write(Words(how), left, " = ", right, *alike, *(
            part for letter, argument in letters for part in (Words(",  "), letter, " = ", argument)),
                                uses=asked or uses, settles="frequency equation")
        self._roots(found, ends, line, self._frequency(found, line))

    def _pressed(self, found: "FrequencyEquation") -> bool:
        return any(not (part.piece.bending.is_zero or part.piece.tension.is_zero) for part in found.pieces)

    def _standing_waves(self, found: "FrequencyEquation", uses: list[int]) -> int:
        """u = X(x) sin(ωt + ε), β by ω, the general solution; of a beam under tension the shape that fits its ends."""
        piece = found.pieces[0].piece
        inertia = piece.inertia * found.omega ** 2 - piece.foundation
        if found.second is not None:
            return self._two_waves(found, inertia, uses)
        if self._pressed(found):
            negative = piece.tension.op != "sum" and piece.tension.coefficient < 0
            pull = [" − " if negative else " + ", Factor(-piece.tension if negative else piece.tension), "·β²"]
            return self.sheet.write(Words("standing waves  "), "X(x)·sin(ω·t + ε)", Words("  with  "), "X = ",
                                    shape(found).first, Words("  fit the ends,  "), Factor(piece.bending), "·β⁴", *pull,
                                    " = ", inertia, settles="beta", uses=uses)
        stiffness = piece.tension if piece.bending.is_zero else piece.bending
        where = ""
        if len(found.pieces) > 1:
            where = f" of {found.members[0]}" if len(found.members) > 1 else " left of its inner place"
        law, power = ("∂²X/∂x² = −β²·X", "β² = ") if found.order == 2 else ("∂⁴X/∂x⁴ = β⁴·X", "β⁴ = ")
        line = self.sheet.write(Words("standing waves  "), "X(x)·sin(ω·t + ε)", Words("  ask for  "), law, Words(",  "),
                                power, textbook(inertia / stiffness), Words(where), settles="beta", uses=uses)
        return self._general("βx", found.order, " in each part" * bool(where), line)

    def _two_waves(self, found: "FrequencyEquation", inertia: "Node", uses: list[int]) -> int:
        """α and β of a beam under an axial force that bends otherwise than a sine."""
        piece, (alpha, beta) = found.pieces[0].piece, map(self.table.parameter, "αβ")
        difference, both = (textbook(one / piece.bending) for one in (piece.tension, inertia))
        line = self.sheet.write(Words("standing waves  "), "X(x)·sin(ω·t + ε)", Words("  with  "),
                                "cosh αx, sinh αx, cos βx, sin βx", Words(":  "), alpha ** 2 - beta ** 2, " = ",
                                difference, Words(",  "), alpha ** 2 * beta ** 2, " = ", both, settles="beta",
                                uses=uses)
        return self._general("αx", found.order, "", line)

    def _general(self, along: str, order: int, where: str, line: int) -> int:
        """C₁ cos βx + …, `along` the argument of cosh and sinh."""
        names = ["cos βx", "sin βx", f"cosh {along}", f"sinh {along}"][:order]
        general = [part for k, name in enumerate(names, 1) for part in (
            " + ", Name(self.sheet.letter(f"C{k}")), f"·{name}")][1:]
        return self.sheet.write(Words(f"general solution{where}:  "), "X = ", *general, settles="X", uses=[line])

    def _frequency(self, found: "FrequencyEquation", uses: int) -> int:
        """ω by βL."""
        x, order = found.wave_number, found.order
        omega, alone = found.omega, textbook(found.square / x ** order)
        if x in reachable([alone]):
            return self.sheet.write(omega ** 2, " = ", found.square, settles="omega^2", node=found.square, uses=[uses])
        node = x ** (order // 2) * self.table.sqrt(alone)
        return self.sheet.write(omega, " = ", node, settles="omega", node=node, uses=[uses])

    def _roots(self, found: "FrequencyEquation", ends: Ends, equation: int, frequency: int) -> None:
        """βL and ω of the first modes; of an equation without letters all by a formula."""
        left, right = sides(found)
        simple = SIMPLE.get(left.name) if right.is_zero and left.op == "call" else None
        if simple:
            orders = ", n = 0, 1, 2, …" if unstrained(found) else ", n = 1, 2, …"
            equation = self.sheet.write(found.wave_number, " = ", simple + orders, settles="βL", uses=[equation])
        if self.problem.numeric.has_free_symbols:
            return
        floats = self.problem.numeric.floats
        known = [(mode, self._root_of(found, mode, floats)) for mode in told_modes(self.problem, 2 * FIRST)]
        free = [f"ω{lowered(mode.index)} = " for mode, _ in known if mode.omega == 0]
        if free:
            self.sheet.write("".join(free) + "0", Words(" rad/s:  it moves freely"), settles="what moves freely",
                             uses=[frequency])
        for mode, node in ((mode, moving_alike(found, mode, floats)) for mode, root in known if root is None):
            if node is not None:
                self.sheet.write(f"ω{lowered(mode.index)} = ", node, *number(float(mode.omega), "rad/s"), Words(
                    ":  all of it moves alike"), settles=f"omega[{mode.index}]", node=node, value=float(mode.omega),
                    unit="rad/s", uses=[frequency])
        asked, roots = asked_modes(self.problem), [(mode, root) for mode, root in known if root is not None]
        for mode, root in [*roots[:FIRST], *(one for one in roots[FIRST:] if one[0].index in asked)]:
            ends.hold(root, floats)
            self._of_mode(found, mode, root, equation, frequency, self._multiple(root) if simple else None)

    def _root_of(self, found: "FrequencyEquation", mode: "Mode", floats: Mapping[str, float]) -> float | None:
        """βL of a mode; None of one that grows, moves freely or belongs to other members."""
        if not mode.omega:
            return None
        x, square = found.wave_number, float(mode.omega)**2

        def residual(at: float) -> float:
            return cast("float", evaluate([found.square], Floats, {**floats, x.name: at})[0] - square)

        low, high = NEAR, 1.0
        while residual(high) < 0:
            high *= 2
            if high > FAR:
                return None
        if residual(low) >= 0:
            return None         # all of it moves alike
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            low, high = (middle, high) if residual(middle) < 0 else (low, middle)
        root = (low + high) / 2
        values, beside = (evaluate(found.terms, Floats, {**floats, x.name: at}) for at in (root, BESIDE * root))
        return root if abs(sum(values)) <= CLOSE * sum(map(abs, beside)) else None

    def _multiple(self, root: float) -> "Node | None":
        """A root as so many halves of π; None of another."""
        halves = round(2 * root / pi)
        return self.table.pi * halves / 2 if isclose(root, halves * pi / 2, rel_tol=EXACT) else None

    def _of_mode(self, found: "FrequencyEquation", mode: "Mode", root: float, equation: int, frequency: int,
                 exact: "Node | None") -> None:
        x, order, k = found.wave_number, found.order, lowered(mode.index)
        omega = float(mode.omega)
        alone = textbook(found.square / x ** order)
        node = self.table.sqrt(found.square) if x in reachable([alone]) else x ** (order // 2) * self.table.sqrt(alone)
        shown = node if exact is None else substitute([node], {x: exact})[0]
        put_in = {name: figure(value) for name, value in self.problem.numeric.floats.items()} | {x.name: figure(root)}
        how = [exact] if exact is not None else [told(root), Words("   (by a search)")]
        line = self.sheet.write(Words(f"root {mode.index}:  "), x, " = ", *how, settles=f"βL[{mode.index}]", node=exact,
                                value=root, uses=[equation], letter=x.name,
                                vanishes=None if exact is not None else self.table.total(found.terms))
        self.sheet.write(f"ω{k} = ", WithNumbers(shown, put_in), *number(omega, "rad/s"), *of_time(self.sheet, omega),
                         settles=f"omega[{mode.index}]", node=node, value=omega, unit="rad/s", uses=[line, frequency])
