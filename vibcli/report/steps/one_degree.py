"""The steps from the equation of one degree of freedom to its frequency, its damping, and its free motion from a given
start."""

from math import isclose, tau
from typing import TYPE_CHECKING, Any, cast

from vibcli.analyses.closed_form.free_response import CRITICAL, OVER, UNDAMPED, UNDER, regime_at
from vibcli.base.errors import PhysicsError
from vibcli.notation.numbers import figure
from vibcli.notation.units_in_sums import unit_beside
from vibcli.quantities.expression import value_of
from vibcli.report.blocks import Factor, Name, Quotient, Words
from vibcli.report.steps.degree import Degree
from vibcli.report.steps.extremes import Swing, tell_extremes
from vibcli.report.steps.forced import tell_forced
from vibcli.report.steps.free_waves import FreeWave, ToldMotion
from vibcli.report.steps.put_in import tell_motion_in_numbers
from vibcli.report.steps.step import number
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.node import is_number
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.language.reader import Expression
    from vibcli.symbolic.node import Node

FACTORS = {"M": ("acceleration", "kg", "kg·m²"), "C": ("speed", "N·s/m", "N·m·s/rad"),
           "K": ("coordinate", "N/m", "N·m/rad")}       # {matrix: what it stands before, its unit, that of a turn}
ROUNDING = 2.0**-50         # of ζ that is 1
AT_SIGHT = 24               # letters of a quotient that is told before it is simplified
AS_PRINTED = 1e-5           # relative: of a difference of two numbers of six digits


class OneDegree:
    """The steps of m q̈ + c q̇ + k q = Q."""

    def __init__(self, degree: Degree) -> None:
        self.degree, self.problem, self.about = degree, degree.problem, degree.about
        self.sheet, self.found, self.M, self.C, self.K = degree.sheet, degree.found, degree.M, degree.C, degree.K
        self.omega, self.delta, self.zeta, self.omega_d = degree.omega, degree.delta, degree.zeta, degree.omega_d

    def write(self) -> None:
        """Write down all of them."""
        if self.M.is_zero or self.K.is_zero:
            return
        self._factors()
        square = _with_units(self.K / self.M)
        value = self.about.value(square)
        if value is not None and value < 0:
            self.sheet.write(self.omega ** 2, " = ", square, *number(value, "1/s²"),
                             Words(" < 0: it leaves the equilibrium"), settles="omega[1]", node=square)
            return
        if value == 0:
            self.sheet.write(self.omega ** 2, " = ", square, " = 0", Words(": to the first order nothing brings it "
                             "back"), settles="omega[1]", node=square)
            return
        of_omega = self._frequency(square)
        of_delta = None if self.C.is_zero else self._damping(of_omega)
        self.write_motion([of_omega, of_delta])
        tell_forced(self.degree)

    def _factors(self) -> None:
        """The factors of acceleration, speed and coordinate that sheets and answers ask for."""
        rules, answers = self.problem.spec.get("variants"), self.problem.spec.answers
        asked = [one.asked for one in (*(rules.ask if rules is not None else ()), *(
            () if self.problem.numeric.has_free_symbols else answers))]
        told = {one.text: one.tree.head for one in asked if one.tree.kind == "quantity" and one.tree.head in FACTORS
                and not one.tree.component and not one.tree.args and not self._is_read_off(one.tree.head)
                and self._is_here(one)}
        for i, head in enumerate(dict.fromkeys(told.values())):
            words, unit, turning = FACTORS[head]
            node, unit = single(getattr(self, head)), unit if self.degree.unit == "m" else turning
            text, *others = [text for text, of in told.items() if of == head]
            self.degree.settled([Words(f"factor of the {words}:  "), self.about.letter(self.sheet.letter(head))],
                                node, unit, text, self.found.lines, joined=i > 0)
            line = self.sheet.steps[-1]
            for other in others:
                self.sheet.settles_too(line, other, node, line.value, line.unit)

    def _is_here(self, asked: "Expression") -> bool:
        """Is it asked of this place of rest?"""
        here = self.about.value(getattr(self, asked.tree.head))
        return not asked.tree.alone or (here is not None and isclose(value_of(self.problem, asked)[0], here))

    def _is_read_off(self, head: str) -> bool:
        """Is a factor nothing, or a letter?"""
        return cast("bool", getattr(self, head).is_zero or getattr(self, head).op == "symbol")

    def _frequency(self, square: "Node") -> int:
        omega = self.degree.root(square)
        line = self.degree.settled([self.omega ** 2, *self._quotient(square), " = ", square, Words(",  "), self.omega],
                                   omega, "rad/s", "omega[1]", self.found.lines, letters=False)
        if (value := self.about.known_value(omega)) is not None:
            turn, f, T = 2 * self.about.table.pi, self.sheet.letter("f"), self.sheet.letter("T")
            period = [Words(",  "), Name(T), " = ", turn / self.omega, *number(tau / value, "s")]
            self.sheet.write(Name(f), " = ", self.omega / turn, *number(value / tau, "Hz"), *period, uses=[line],
                             settles="frequency[1]", node=self.omega / turn, value=value / tau, unit="Hz", joined=True)
        return line

    def _quotient(self, square: "Node") -> list[Quotient | str]:
        """Parts of ` = K/M`, where that is not yet the square in its simplest form and no long one."""
        halved = any(part.op == "product" and part.coefficient.denominator > 1 for part in (self.K, self.M))
        size = letters(self.K) + letters(self.M)
        if size > AT_SIGHT or not (halved or size > letters(square)):
            return []
        return [" = ", Quotient(self.K, self.M)]

    def _damping(self, of_omega: int) -> int:
        """δ = c/(2m), ζ = δ/ω, ω_d; the number of the last line."""
        delta = single(self.C / (2 * self.M))
        of_delta = self.degree.settled([*self._by_acceleration(), self.delta], delta, "1/s", self.delta.name,
                                       self.found.lines)
        zeta = self._zeta()
        value = 1.0 if self._is_critical() else self.about.known_value(zeta)
        beside = "" if value is None or value in (0.0, 1.0) or value < 0 else " < 1" if value < 1 else " > 1"
        kind = () if value is None else (beside, Words(f": {_damped(value)}"))
        shown = () if value is None or zeta is self.about.table.one else number(value)
        line = self.sheet.write(self.zeta, " = ", self.delta / self.omega, " = ", zeta, *shown, *kind,
                                uses=[of_delta, of_omega], settles="zeta[1]", node=zeta, value=value)
        if (value is None or abs(value) < 1) and not self._is_chosen_critical():
            return self._damped_frequency(delta, [of_omega, of_delta, line])
        return line

    def _is_chosen_critical(self) -> bool:
        """Does the scene choose a parameter so that ζ is one?"""
        conditions = [record["so"] for record in (self.problem.spec.choices or {}).values()]
        return any(not so.word and (so.left.text, so.right.text.strip()) == ("zeta[1]", "1") for so in conditions)

    def _by_acceleration(self) -> "list[Node | str | Words]":
        """Parts that say what δ is: the equation over the factor of the acceleration, where nothing drives."""
        if self.found.drive:
            return [Words("half the factor of the speed over that of the acceleration:  ")]
        scene = self.about.scene
        node = scene.a[0] + 2 * self.delta * scene.v[0] + self.omega ** 2 * scene.q[0]
        return [Words("so  "), node, " = 0", Words("  with  ")]

    def _is_critical(self) -> bool:
        """Is ζ one, in letters or but for rounding?"""
        value = self.about.known_value(self._zeta())
        return is_zero(self.C * self.C - 4 * self.M * self.K) or (value is not None and abs(value - 1) <= ROUNDING)

    def _zeta(self) -> "Node":
        return cast("Node", self.C / (2 * self.degree.root(self.K) * self.degree.root(self.M)))

    def _damped_frequency(self, delta: "Node", uses: list[int]) -> int:
        from vibcli.analyses.closed_form.one_degree import damped_frequency

        known = self.about.known_value(self._zeta()) is not None or self.problem.spec.choices
        omega_d = damped_frequency(self.M, self.C, self.K, self.about.samples)
        parts = [self.omega_d, " = ", self.about.table.sqrt(self.omega ** 2 - self.delta ** 2)]
        value = self.about.known_value(omega_d)
        squares = [None if value is None else figure(self.about.known_value(node)) for node in (
            self.K / self.M, delta ** 2)]
        if value is not None and isclose(float(squares[0]) - float(squares[1]), value ** 2, rel_tol=AS_PRINTED):
            return self.sheet.write(*parts, f" = √({squares[0]} − {squares[1]})", *number(value, "rad/s"), node=omega_d,
                                    uses=uses, settles="omega_d[1]", value=value, unit="rad/s",
                                    letter=self.omega_d.name)
        return self.degree.settled(parts, omega_d, "rad/s", "omega_d[1]", uses, more=[] if known else [
            Words("   (under-damped, "), self.delta, " < ", self.omega, Words(")")])

    def write_motion(self, uses: "Sequence[int]") -> None:
        """The constants of the free motion from the start that the file gives; lines tell frequency and damping."""
        from vibcli.mechanics.initial_state import start_in_letters

        try:
            start = start_in_letters(self.problem.symbolic)
        except PhysicsError:
            return
        if start is None or self.found.drive or self.problem.spec.in_full:
            return
        regime = self._regime()
        told: dict[str, Any] = {UNDAMPED: self._oscillates, UNDER: self._oscillates, CRITICAL: self._critical,
                                OVER: self._overdamped}
        if regime in told:
            told[regime](start, uses)

    def _regime(self) -> str | None:
        """How it is damped; lightly where letters decide, None where the scene chooses these."""
        if self.C.is_zero:
            return UNDAMPED
        if self._is_critical():
            return CRITICAL
        zeta = self.about.known_value(self._zeta())
        if zeta is None:
            return None if self.problem.spec.choices else UNDER
        return regime_at(1.0, 2.0 * zeta, 1.0)

    def _letters(self, start: "Sequence[Any]") -> "list[Node]":
        """A, B, the start and its speed: letters for these where they are no letter and not zero."""
        name = self.degree.name
        at_start = f"{name}_0" if name[-1].isdigit() else f"{name}0"
        known = [node if node.op == "symbol" or node.is_zero else None for node in start]
        return [node or self.about.letter(self.sheet.letter(letter)) for letter, node in zip(
            ("A", "B", at_start, "v0"), (None, None, *known), strict=True)]

    def _oscillates(self, start: "list[Node]", uses: list[int | None]) -> None:
        table, t = self.about.table, self.problem.scene.time
        A, B, x0, v0 = self._letters(start)
        rate = self.omega if self.C.is_zero else self.omega_d
        wave = A * table.call("cos", rate * t) + B * table.call("sin", rate * t)
        decay = () if self.C.is_zero else (table.call("exp", -(self.delta * t)), "·")
        ahead = v0 if self.C.is_zero else v0 + self.delta * x0
        delta = single(self.C / (2 * self.M))
        exact = self.about.table.sqrt(self.K / self.M - delta ** 2)
        line = self._constants([*decay, Factor(wave) if decay else wave], start, (x0, ahead / rate),
                               (start[0], (start[1] + delta * start[0]) / exact), uses,
                               ((self.delta, delta), (rate, exact)))
        self.sheet.waves[self.degree.name] = ToldMotion([FreeWave(A, table.zero if start[1].is_zero and self.C.is_zero
                                                                  else B, rate, table.zero if self.C.is_zero
                                                                  else self.delta)], line)
        tell_extremes(self.degree, Swing(self.about.place[self.about.scene.q[0]], A, None if start[1].is_zero else B,
                                         table.zero, line))

    def _critical(self, start: "list[Node]", uses: list[int]) -> None:
        A, B, x0, v0 = self._letters(start)
        t = self.problem.scene.time
        delta = single(self.C / (2 * self.M))
        line = self._constants([Factor(A + B * t), "·", self.about.table.call("exp", -(self.delta * t))], start,
                               (x0, v0 + self.delta * x0), (start[0], start[1] + delta * start[0]), uses,
                               ((self.delta, delta),), of_speed=True)
        wave = FreeWave(A, B, self.about.table.zero, self.delta)
        self.sheet.waves[self.degree.name] = ToldMotion([wave], line)

    def _overdamped(self, start: Any, uses: "Sequence[int]") -> None:
        table, t = self.about.table, self.problem.scene.time
        A, B, x0, v0 = self._letters(start)
        roots = [self.about.letter(self.sheet.letter(name)) for name in ("s1", "s2")]
        delta, size = single(self.C / (2 * self.M)), table.sqrt(self.delta ** 2 - self.omega ** 2)
        spread = table.sqrt(delta ** 2 - self.K / self.M)
        exact = [-delta + spread, -delta - spread]
        for i, (letter, form, node) in enumerate(zip(roots, (-self.delta + size, -self.delta - size), exact,
                                                     strict=True)):
            value = self.about.value(node)
            line = self.sheet.write(letter, " = ", form, *number(value, "1/s"), settles=letter.name, node=form,
                                    value=value, unit="1/s", uses=uses, joined=i > 0, letter=letter.name)
        x, v = start
        first = (v - exact[1] * x) / (exact[0] - exact[1])
        wave = A * table.call("exp", roots[0] * t) + B * table.call("exp", roots[1] * t)
        self._constants([wave], start, ((v0 - roots[1] * x0) / (roots[0] - roots[1]), x0 - A), (first, x - first),
                        [*uses, line], zip(roots, exact, strict=True))

    def _constants(self, motion: "Sequence[Any]", start: "Sequence[Any]", forms: "tuple[Node, Node]",
                   exact: "tuple[Node, Node]", uses: list[int | None], rates: Any, of_speed: bool = False) -> int:
        """The form of the motion, its constants from the start, and it with their numbers and those of its `rates`; the
        number of the line of the constants."""
        A, B, x0, v0 = self._letters(start)
        name, unit = self.degree.name, self.degree.unit
        moves = self.about.table.product(*((part.node if isinstance(part, Factor) else part, 1) for part in motion
                                           if part != "·"))
        line = self.sheet.write(Name(name), " = ", *motion, settles=name, uses=uses, node=moves)
        self._start([(x0, start[0], unit), (v0, start[1], unit + "/s")])
        of_start: list[Any] = []
        for which, letter, node, per in ((name, x0, start[0], ""), (name + "'", v0, start[1], "/s")):
            known = None if node.op == "symbol" else self.about.value(node)
            of_start += [Words(",  " * bool(of_start)), Name(which), *([" = ", letter] if letter is not node else []),
                         *([" = ", node] if not is_number(node) or not known else []),
                         *(number(known, unit + per) if known else ())]
        found = [(letter, form, self.about.value(value), unit + per) for letter, form, value, per in (
            (A, forms[0], exact[0], ""), (B, forms[1], exact[1], "/s" * of_speed))]
        constants: list[Any] = []
        for letter, form, known, its in found:
            shown = [] if is_number(form) and known is not None else [" = ", form]
            value = () if known is None else number(known, its)
            constants += [Words(",  " * bool(constants)), letter, *shown, *value]
        line = self.sheet.write(Words("at t = 0  "), *of_start, Words(":  "), *constants, uses=[line],
                                settles="free motion")
        for letter, form, known, its in found:
            self.sheet.write(settles=letter.name, node=form, value=known, unit=its, joined=True, letter=letter.name)
        tell_motion_in_numbers(self.degree, moves, [*((letter, known) for letter, _, known, _ in found), *(
            (letter, self.about.value(node)) for letter, node in rates)], [*uses, line])
        return line

    def _start(self, known: "Sequence[tuple[Node, Node, str]]") -> None:
        """Where and how fast it starts, as far as these have letters."""
        for letter, node, unit in known:
            if letter is not node:
                self.sheet.write(settles=letter.name, node=node, value=self.about.value(node), unit=unit, joined=True,
                                 letter=letter.name)


def _with_units(node: "Node") -> "Node":
    """As one fraction, but where that leaves a number in a sum without its unit, as in 25·L² + 81 for L² + 3.24 m²."""
    plainly = textbook(node)
    return plainly if _is_bare(single(node)) and not _is_bare(plainly) else single(node)


def _is_bare(node: "Node") -> bool:
    return node.table.dimension is not None and any(part.op == "sum" and part.coefficient and not unit_beside(part)
                                                    for part in reachable([node]))


def _damped(zeta: float) -> str:
    """How a damping ratio damps, in words."""
    if zeta < 0:
        return "negative, so free motion grows"
    return "under-damped" if zeta < 1 else "critically damped" if zeta == 1 else "over-damped"
