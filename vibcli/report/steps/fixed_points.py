"""The steps to the points of a frequency response of two degrees of freedom that its one damper does not move
(Den Hartog 1956, section 3.3):

    X = (n₀ + ic n₁)/(d₀ + ic d₁),   |X| = |n₁/d₁| for every c where n₀ d₁ = ±n₁ d₀

n and d being functions of ω². With + the stretch of the damper is zero, or its force does not move the coordinate."""

from math import isclose, sqrt, tau
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.held import HINT, UNTOLD, SmallEquations, Untold
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import expanded, textbook
from vibcli.symbolic.radicals import root
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

READABLE = 40       # letters of a frequency or a height, beyond which its number alone tells it
CLOSE = 1e-8        # relative: of a place by the lines and the engine's
ANY = 0.7           # ω at which expressions are held against each other
POINTS = "P", "Q"


def tell_fixed_points(about: AboutRest, sheet: WorkedSolution, found: SmallEquations, forces: "Sequence[Node]",
                      Omega: "Node", uses: list[int]) -> None:
    """Write down the fixed points of each coordinate of which they are asked, or that Omega is one of; `forces`: the
    amplitudes of loads that act together, by row."""
    scene = about.scene
    if len(scene.q) != 2 or len(scene.dampers) != 1 or found.G or any(law.damper for law in scene.laws):
        return
    if Omega.op == "symbol" and any(Omega in reachable([force]) for force in forces):
        return          # the load is another at each frequency
    alone = sum(not force.is_zero for force in forces) == 1
    asked, before = _asked(about.problem) if alone else {}, len(sheet.steps)
    for k, name in enumerate(scene.coordinates):
        points = _FixedPoints(about, sheet, found, forces, Omega, k)
        if points.stand and (name in asked or points.hold()):
            try:
                points.write(name, asked.get(name), uses)
            except PhysicsError:
                del sheet.steps[before:]
            return


def _asked(problem: "Problem") -> dict[Any, Any]:
    """{signal whose fixed points are asked: driver}."""
    spec = problem.spec
    sides = [side for record in spec.choices.values() for side in record["so"].sides]
    trees = [tree for side in (*(answer.asked for answer in spec.answers), *sides) for tree in side.parts.quantities]
    return {tree.args[0].indices[0]: tree.args[0].indices[1] for tree in trees if tree.head == "fixed_point"}


class _FixedPoints:
    """Those of the coordinate of number k."""

    def __init__(self, about: AboutRest, sheet: WorkedSolution, found: SmallEquations, forces: "Sequence[Node]",
                 Omega: "Node", k: int) -> None:
        self.about, self.sheet, self.Omega, self.k, table = about, sheet, Omega, k, about.table
        damper, = about.scene.dampers
        self.c, slopes, zero = damper.weight, about.small(damper.s).slopes, table.zero
        self.omega = about.letter(sheet.letter("omega"))
        for values in about.samples:
            values.setdefault(self.omega.name, ANY)
        (p, q), (r, s) = ([found.K.get((i, j), zero) - self.omega ** 2 * found.M.get((i, j), zero) for j in range(2)]
                          for i in range(2))
        a, b = (slopes.get(i, zero) for i in range(2))
        F, G = forces
        above = (F * s - G * q, F * b * b - G * a * b) if k == 0 else (p * G - r * F, a * a * G - a * b * F)
        self.n0, n1, self.d0, d1 = (about.tidy(node) for node in (
            *above, p * s - q * r, a * a * s + b * b * p - a * b * (q + r)))
        self.n1, self.d1, self._per = n1 * self.omega, d1 * self.omega, (n1, d1)
        alone = all(about.same(found.C.get((i, j), zero), self.c * (a, b)[i] * (a, b)[j])
                    for i in range(2) for j in range(2))
        self.stand = alone and not (self.n0.is_zero or n1.is_zero or d1.is_zero)
        if self.stand:
            self.equation = self._in_powers(self.d0 + about.tidy(self.n0 * d1 / n1))
            self.stand = len(self.equation) == 3

    def _in_powers(self, node: "Node") -> "list[Node]":
        """[e₂, e₁, e₀] of e₂ω⁴ − e₁ω² + e₀; nothing of others."""
        found = self._by_powers(node)
        return [found[4], -found[2], found[0]] if set(found) == {0, 2, 4} else []

    def _by_powers(self, node: "Node") -> "dict[int, Node]":
        """{power of ω: what stands before it}."""
        found: dict[Any, Any] = {}
        for monomial, c in expanded(textbook(node)).items():
            power = next((e for atom, e in monomial if atom is self.omega), 0)
            rest = self.about.table.product(*((atom, e) for atom, e in monomial if atom is not self.omega))
            found.setdefault(power, []).append((rest, c))
        return {power: self.about.tidy(self.about.table.sum(*parts)) for power, parts in found.items()}

    def hold(self) -> bool:
        """Is the frequency of the load one of them, whatever the values of the letters?"""
        sums = substitute([self.n0 * self.d1, self.n1 * self.d0], {self.omega: self.Omega})
        return all(isclose(one, -other, rel_tol=CLOSE) for one, other in (
            evaluate(sums, Floats, values) for values in self.about.samples))

    def write(self, name: str, driver: Any, uses: list[int]) -> None:
        """Write down all lines."""
        sheet, functions = self.sheet, (self.n0, self.n1, self.d0, self.d1)
        n0, n1, d0, d1 = found = [self.about.letter(sheet.letter(letter)) for letter in ("n0", "n1", "d0", "d1")]
        X = Name(sheet.letter(f"X{self.k + 1}"))
        c, size = Factor(self.c), ["|", X, "|"]
        head = sheet.write(Words("at any frequency ω of the load and any damper  "), X, " = (", n0, " + i·", c, "·", n1,
                           ")/(", d0, " + i·", c, "·", d1, ")", settles="amplitude by the damper", uses=uses)
        for letter, node in zip(found, functions, strict=True):
            entries = sheet.write(*([Words("with  ")] if letter is n0 else []), letter, " = ", node, node=node,
                                  settles=letter.name, uses=[head], joined=letter is not n0)
        where, how = " is the same for every damper where ", ", with + where the damper stands still or does not move "
        line = sheet.write(*size, Words(where), n0, "·", d1, " = ±", n1, "·", d0, Words(how), Name(name), Words(
            ", so with −:  "), n0, "·", d1, " + ", n1, "·", d0, " = 0", settles="fixed points", uses=[head, entries])
        e2, e1, e0 = self.equation
        polynomial = self.about.table.total([e2 * self.omega ** 4, -e1 * self.omega ** 2, e0])
        line = sheet.write(Words("that is  "), polynomial, " = 0", settles="equation of fixed points", uses=[line])
        places = self._places()
        self._agrees(places, name, driver)
        lines = [self._place(letter, x, value, [line]) for letter, (x, value) in zip(POINTS, places, strict=True)]
        height = self._height()
        line = sheet.write(Words("there  "), *size, " = |", n1, "/", d1, "| = ", height, uses=[entries, *lines],
                           settles="height of fixed points")
        for letter, (x, value) in zip(POINTS, places, strict=True):
            line = self._at(letter, x, value, size, height, [line])
        if self.about.problem.choice is not None:
            self._alike([line])

    def _alike(self, uses: list[int]) -> None:
        """The condition under which both are of one height, by the sum of their squares."""
        e2, e1, _ = self.equation
        found = dict(self._by_powers(self._per[1] / self._per[0]))
        if set(found) == {0, 2}:
            P, Q = (self.about.letter(self.sheet.letter("omega", letter)) for letter in POINTS)
            first, second = (self.about.tidy(node) for node in (e1 / e2, -2 * found[0] / found[2]))
            self.sheet.write(Words("so both are of one height where  "), P ** 2 + Q ** 2, " = ", first, " = ", second,
                             settles="one height", uses=uses)

    def _height(self) -> "Node":
        n1, d1 = self._per
        return self.about.table.call("abs", self.about.tidy(n1 / d1))

    def _places(self) -> list[tuple[Any, Any]]:
        """[(ω² in letters or None, ω in numbers or None)], ascending."""
        about, (e2, e1, e0) = self.about, self.equation
        values = [about.value(node) for node in self.equation]
        if None not in values:
            spread = values[1] ** 2 - 4 * values[0] * values[2]
            squares = sorted((values[1] + sign * sqrt(max(spread, 0.0))) / (2 * values[0]) for sign in (-1, 1))
            if spread <= 0 or squares[0] <= 0:
                raise Untold(UNTOLD, HINT)
            return [(None, sqrt(square)) for square in squares]
        spread = root(about.tidy(e1 * e1 - 4 * e0 * e2), about.samples)
        found = [about.tidy((e1 + sign * spread) / (2 * e2)) for sign in (-1, 1)]
        order = {low <= high for low, high in (evaluate(found, Floats, values) for values in about.samples)}
        if len(order) > 1:
            raise Untold(UNTOLD, HINT)
        return [(node, None) for node in (found if order.pop() else found[::-1])]

    def _agrees(self, places: "Sequence[tuple[Node, None]]", name: str, driver: str) -> None:
        """Untold where the engine finds others in numbers."""
        if places[0][1] is None:
            return
        damper = self.about.scene.dampers[0].owner
        drivers = [driver] if driver else list(self.about.problem.spec.get("forces") or {})
        if not drivers:
            raise Untold(UNTOLD, HINT)
        known = [point.Omega for point in self.about.problem.frequency_response(name, drivers[0]).fixed_points(damper)]
        if len(known) != 2 or any(not isclose(x, value, rel_tol=CLOSE) for x, (_, value) in zip(
                known, places, strict=True)):
            raise Untold(UNTOLD, HINT)

    def _place(self, letter: str, square: "Node", value: Any, uses: list[int]) -> int:
        """The line of a frequency."""
        name = self.about.letter(self.sheet.letter("omega", letter))
        if value is not None:
            return self.sheet.write(name, *number(value, "rad/s"), Words(",  "), Name(self.sheet.letter("f")), *number(
                value / tau, "Hz"), Words(",  "), Name(self.sheet.letter("T")), *number(tau / value, "s"), uses=uses,
                settles=f"fixed point {letter}", value=value, unit="rad/s")
        return self.sheet.write(name ** 2, " = ", square, settles=f"fixed point {letter}", node=square, uses=uses)

    def _at(self, letter: str, square: "Node", value: Any, size: "Sequence[Any]", height: "Node",
            uses: list[int]) -> int:
        """|X| at a frequency; the number of its line."""
        name, which = self.about.letter(self.sheet.letter("omega", letter)), []
        if value is not None:
            at = self.about.table.number(fraction_of(value))
            node, = substitute([height], {self.omega: at})
            unit = "m" if self.about.problem.system.dimension(self.about.scene.coordinates[self.k]) else "rad"
            shown = number(self.about.value(node), unit)
        else:
            n1, d1 = self._per
            node = self.about.tidy(substitute([n1 / d1], {self.omega: self.about.table.sqrt(square)})[0])
            node = node if evaluate([node], Floats, self.about.samples[0])[0] > 0 else self.about.tidy(-node)
            if letters(node) > READABLE:
                return uses[0]
            shown = (" = ", node)
            if self.about.same(self.Omega ** 2, square):
                which = [Words(", that of the load,")]
        reached = None if value is None else self.about.value(node)
        return self.sheet.write(Words("at "), name, *which, Words(" it is  "), *size, *shown, node=node, uses=uses,
                                settles=f"height of fixed point {letter}", value=reached)
