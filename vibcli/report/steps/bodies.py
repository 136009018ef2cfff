"""The kinetic energy, body by body: translation ½ m v², a fixed axis ½ J_O ω², plane motion ½ m v_C² + ½ J_C ω²
(Kovacić & Radomirović 2018, §1.3), speeds to the first order about rest."""

from collections.abc import Collection, Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.notation.names import lowered
from vibcli.notation.plain import plain
from vibcli.report.blocks import Factor, Name, SumOfTerms, Words
from vibcli.report.steps.step import WorkedSolution, number, place_told
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from vibcli.elements.rigid_body import Body
    from vibcli.report.steps.in_motion import Unexpanded
    from vibcli.report.steps.small import Small
    from vibcli.scene.energy_terms import Inertia
    from vibcli.symbolic.node import Node

SHORT = 2       # factors of T, up to which it is told as shortly as that it is like another
LONG = 40       # letters of a place, beyond which it is told by powers alone


class EnergyPart(NamedTuple):
    """A part of T, V or Φ: the letters that stand for it, its expression, the number of its line."""

    letter: str
    node: Any
    line: int


class Bodies:
    """What the bodies of a scene add to T, AboutRest or InMotion, apart from some of these names; `others`: does
    something else, too?"""

    def __init__(self, about: Any, sheet: WorkedSolution, others: bool, apart: Collection[str] = ()) -> None:
        self.about, self.sheet, self.scene, self._apart = about, sheet, about.scene, apart
        self._told: dict[Any, Any] = {}
        self._lines: dict[Any, Any] = {}
        self._parts: dict[Any, Any] = {}
        self._at_once: set[Any] = set()
        self._likened = -1
        self._places: dict[Any, Any] = {}
        self._several = others or sum(1 for body in self.scene.bodies.values() if self._counts(body)) > 1

    def _counts(self, body: "Body") -> bool:
        return any(term.owner == body.name for term in (*self.scene.inertias, *self.scene.weights))

    def mass_matrix(self) -> Any:
        """M = Σ w ∇s ∇sᵀ of what was told of each, and of what has no line."""
        untold = [(term.weight, self.about.small(term.s)) for term in self.scene.inertias
                  if term.owner not in self._parts]
        return self.about.sum_of_squares([*(part for parts in self._parts.values() for part in parts), *untold])

    def kinetic(self) -> Iterator[EnergyPart]:
        """T of each body that moves."""
        for body in self.scene.bodies.values():
            terms = [term for term in self.scene.inertias if term.owner == body.name]
            if body.name not in self._apart and any(
                    small.slopes and not weight.is_zero for weight, small in self._moved(body, terms)):
                yield self._like_another(body, terms) or self._of_body(body, terms)
        for name in dict.fromkeys(term.owner for term in self.scene.inertias if term.owner not in self.scene.bodies):
            yield self._of_terms(name, [term for term in self.scene.inertias if term.owner == name])

    def _moved(self, body: "Body", terms: "Sequence[Inertia]") -> "Iterator[tuple[Node, Small | Unexpanded]]":
        """(weight, s) of each term of ½ Σ w ṡ² of a body, of one on a fixed axis of its turn alone."""
        if _is_on_an_axis(body):
            yield self.about.tidy(self.scene.table.total(_about_the_axis(body))), self.about.small(body.frame.angle)
        else:
            yield from ((term.weight, self.about.small(term.s)) for term in terms)

    def _letter(self, name: str) -> str:
        return self.sheet.letter("T", name if self._several or name not in self.scene.bodies else "")

    def _like_another(self, body: "Body", terms: "list[Inertia]") -> EnergyPart | None:
        """T of a body that moves like one before it; None of others."""
        if body.frame is None or body.pieces:
            return None
        node = self.about.half_squares(list(self._moved(body, terms)), rates=True)
        of = (body.mass, body.inertia, body.frame.angle.mask != 0, node)
        first = self._told.setdefault(of, body.name)
        if first == body.name or (node.op == "product" and len(node.args) <= SHORT and first in self._at_once):
            return None
        self._parts[body.name] = self._parts[first]
        letter = self._letter(body.name)
        line = self.sheet.write(Words(f"{body.name}, like {first}:  "), Name(letter), " = ", Name(self._letter(first)),
                                settles=letter, node=node, uses=[self._lines[first]],
                                joined=self.sheet.last in (self._likened, self._lines[first]))
        self._likened = line
        return EnergyPart(letter, node, line)

    def _of_body(self, body: "Body", terms: "list[Inertia]") -> EnergyPart:
        if body.frame is None:
            return self._of_terms(body.name, terms)
        if _is_on_an_axis(body):
            return self._about_a_fixed_axis(body, terms)
        return self._in_the_plane(body, terms)

    def _about_a_fixed_axis(self, body: "Body", terms: "list[Inertia]") -> EnergyPart:
        """½ J_O ω², J_O by the parallel axis theorem of each part."""
        about, parts = self.about, _about_the_axis(body)
        written, ((J, omega),) = list(map(textbook, parts)), self._moved(body, terms)
        rate, (axis, centre) = about.rate(omega), self._axis_and_centre(body)
        turns = [Words(f"{body.name} turns about the fixed {axis}:  ")]
        if len(parts) == 1:
            turn = about.letter(self.sheet.letter("omega", body.name))
            shown = [] if rate.op == "symbol" else [turn, " = ", rate, Words(",  ")]
            return self._energy(body.name, [(J, omega)], None, [J * turn ** 2 / 2] if shown else [],
                                before=[*turns, *shown])
        letter = self.sheet.letter("J", body.name) if self._shares_its_axis(body) else self.sheet.letter(
            f"J_{axis}", body.name if self._several and len(self._axes) < 2 else "")
        simple = len(parts) == 2 and not (body.pieces or body.cut)
        how = [f"J_{centre} + ", Factor(body.mass), f"·{axis}{centre}² = "] if simple else []
        told = [SumOfTerms(tuple(written)), " = "] if len(written) > 1 else []
        x, y = map(about.shifted, body.frame.point(*body.centre))
        if how and letters(x) + letters(y) <= LONG:
            where = Words(f"{body.name} turns about the fixed {axis}, {centre} at  ")
            turns = [where, *place_told(x, y), Words(":  ")]
        line = self.sheet.write(*turns, Name(letter), " = ", *how, *told, J,
                                *self._number(J), settles=letter, node=J, value=about.value(J), unit="kg·m²")
        return self._energy(body.name, [(J, omega)], line, [self.about.letter(letter) * rate ** 2 / 2])

    def _axis_and_centre(self, body: "Body") -> tuple[str, str]:
        """The letters O and C, others where the scene has these of something else than the places meant."""
        names = {*self.scene.parameters.nodes, *self.scene.coordinates, *self.scene.points}
        places = ("OASP", body.frame.place), ("CGWR", body.frame.point(*body.centre))
        axis, centre = (next((one for one in several if one not in names or self._is_at(one, place)), f"{several[0]}′")
                        for several, place in places)
        return self._axis_of(body, axis), centre

    def _axis_of(self, body: "Body", letter: str) -> str:
        """The letter of an axis, numbered where bodies have several."""
        return letter if len(self._axes) < 2 else letter + lowered(list(self._axes).index(_place(body)) + 1)

    def _shares_its_axis(self, body: "Body") -> bool:
        """Do others turn about it, while there are several axes?"""
        return len(self._axes) > 1 and len(self._axes[_place(body)]) > 1

    @cached_property
    def _axes(self) -> "dict[tuple[Node, Node], list[str]]":
        """{place of a fixed axis: the bodies that turn about it}."""
        found: dict[Any, Any] = {}
        for body in self.scene.bodies.values():
            if _is_on_an_axis(body):
                found.setdefault(_place(body), []).append(body.name)
        return found

    def _is_at(self, point: str, place: "tuple[Node, Node]") -> bool:
        """Is the point of the scene of this name always at the place?"""
        return point in self.scene.points and all(is_zero(one - other) for one, other in zip(
            self.scene.points[point][1], place, strict=True))

    def _in_the_plane(self, body: "Body", terms: "Sequence[Inertia]") -> EnergyPart:
        about = self.about
        x, y = body.frame.point(*body.centre)
        moves = [(axis, node) for axis, node in (("x", x), ("y", y)) if node.mask]
        speeds = [(axis, about.rate(small)) for axis, small in ((axis, about.small(node)) for axis, node in moves)
                  if small.slopes or small.drive.mask]
        turns = body.frame.angle.mask and body.inertia is not None and not body.inertia.is_zero
        omega = about.rate(about.small(body.frame.angle)) if turns else None
        v, turn = (about.letter(self.sheet.letter(letter, body.name)) for letter in ("v", "omega"))
        parts = [(term.weight, about.small(term.s)) for term in terms]
        if not turns and len(speeds) == 1 and speeds[0][1].op != "symbol" and self._goes_straight(moves):
            return self._energy(body.name, parts, None, [body.mass * v ** 2 / 2], before=[v, " = ", speeds[0][1], Words(
                ",  ")])
        if (there := self._places.setdefault((textbook(x), textbook(y)), body.name)) != body.name and not turns:
            return self._energy(body.name, parts, None, [body.mass * v ** 2 / 2], before=[
                Words(f"{body.name} is at the mass centre of {there}:  "), v, " = ", about.letter(
                    self.sheet.letter("v", there)), Words(",  ")], lines=[self._lines[there]])
        lines = [None if self._goes_straight(moves) else self._placed(body, x, y)]
        told = [part for axis, node in speeds for part in (Words(",  "), Name(f"{axis}_C'"), " = ", node)][1:]
        if len(speeds) == 1:
            told = [v, " = ", speeds[0][1]]
        elif speeds:
            told += [Words(",  "), v ** 2, " = ", about.square([node for _, node in speeds])]
        told += [Words(",  " * bool(told)), turn, " = ", omega] if turns else []
        if omega is None and len(speeds) == 1 and speeds[0][1].op != "symbol":
            return self._energy(body.name, parts, lines[-1], [body.mass * v ** 2 / 2], lines=lines, before=[
                v, " = ", speeds[0][1], Words(",  ")])
        if told and not _is_plain(speeds, omega):
            lines.append(self.sheet.write(Words(f"speeds of {body.name}{about.order_of_speeds}:  "), *told, uses=lines))
        formula = [body.mass * v ** 2 / 2] * bool(speeds and body.mass) + [
            body.inertia * turn ** 2 / 2] * bool(turns and not omega.is_zero)
        shown = [] if body.pieces or _is_plain(speeds, omega) else formula
        return self._energy(body.name, parts, lines[-1], shown, lines=lines)

    def _goes_straight(self, moves: "Sequence[tuple[str, Node]]") -> bool:
        """Is the place of the mass centre linear in the coordinates, so that its speeds are read off the figure?"""
        q = self.scene.q
        return all(not any(textbook(slope).mask for x, slope in gradient(node).items() if x in q) for _, node in moves)

    def _placed(self, body: "Body", x: "Node", y: "Node") -> int | None:
        """The line that tells where the mass centre is; None where it is the coordinates themselves."""
        x, y = self.about.shifted(x), self.about.shifted(y)
        if all(node.op == "symbol" or not node.mask for node in (x, y)) or letters(x) + letters(y) > LONG:
            return None
        return self.sheet.write(Words(f"mass centre of {body.name}:  "), "C = ", *place_told(x, y))

    def _of_terms(self, name: str, terms: "Sequence[Inertia]") -> EnergyPart:
        """½ w ṡ² of what has no place; of a body v or ω first, where that is more than the rate of a coordinate."""
        about = self.about
        parts = [(term.weight, about.small(term.s)) for term in terms]
        (weight, small), *others = parts
        rate, body, speed = about.rate(small), self.scene.bodies.get(name), []
        if body is not None and not others and rate.op != "symbol":
            moves = about.letter(self.sheet.letter("omega" if weight is body.inertia else "v", name))
            rate, speed = moves, [moves, " = ", rate, Words(",  ")]
        return self._energy(name, parts, None, [] if others else [weight * rate ** 2 / 2], before=speed)

    def _energy(self, name: str, parts: "list[tuple[Node, Small | Unexpanded]]", line: int | None,
                formula: "Sequence[Node]", lines: Sequence[int | None] = (),
                before: "Sequence[Node | str | Words]" = ()) -> EnergyPart:
        """A line T = formula = the same with what it stands for."""
        about = self.about
        node = about.half_squares(parts, rates=True)
        letter = self._letter(name)
        head = () if not formula or [plain(one) for one in formula] == [plain(node)] else (
            SumOfTerms(tuple(formula)), " = ")
        written = self.sheet.write(*before, Name(letter), " = ", *head, node, settles=letter, node=node,
                                   uses=[line, *lines])
        self._lines[name], self._parts[name] = written, parts
        if not any((line, *lines)):
            self._at_once.add(name)
        return EnergyPart(letter, node, written)

    def _number(self, node: "Node") -> tuple[str | Words, ...]:
        value = self.about.value(node)
        return () if value is None else number(value, "kg·m²")


def _is_on_an_axis(body: "Body") -> Any:
    """Does a body turn about a fixed axis?"""
    return body.frame is not None and body.frame.angle.mask and not any(node.mask for node in body.frame.place)


def _place(body: "Body") -> Any:
    return tuple(map(textbook, body.frame.place))


def _about_the_axis(body: "Body") -> "list[Node]":
    """The terms of J_O, J_C and m·OC² of each part."""
    ox, oy = body.frame.drawn
    squares = [(own, mass, textbook((x - ox) ** 2 + (y - oy) ** 2))
               for mass, (x, y), own in body.pieces or body.cut or ((body.mass, body.centre, body.inertia),)]
    nodes = [node for own, mass, square in squares for node in (own, None if mass is None else mass * square)]
    return [node for node in nodes if node is not None and not node.is_zero]


def _is_plain(speeds: "Sequence[tuple[str, Node]]", omega: "Node | None") -> bool:
    """Is there one speed, and that the rate of a coordinate?"""
    return omega is None and len(speeds) == 1 and speeds[0][1].op == "symbol"
