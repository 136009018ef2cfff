"""The motion of one bar, shaft or string that is let go from rest, by the waves that travel along it (d'Alembert):

    u = f₁(x − ct) + f₂(x + ct),   f₁ = f₂ = u(x, 0)/2,   c = √(S/μ),
    f₁(−s) = r₀ f₂(s) + (1 − r₀) u(0, 0)/2,   f₂(L + s) = r f₁(L − s) + (1 − r) u(L, 0)/2

with r = −1 where an end is held, 1 where it is free, (Z − b)/(Z + b), Z = √(Sμ), where a damper b acts (Rao 2007, 8.6
and 9.3)."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.signal_names import signal_name
from vibcli.mechanics.initial_fields import member_fields
from vibcli.notation.as_printed import as_printed
from vibcli.quantities.expression import value_of
from vibcli.report.blocks import Words
from vibcli.report.steps.step import WorkedSolution, number, told, unit_told
from vibcli.results.resting_shape import polynomial_at_rest
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.parser import VALUE, parse
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import NameRef, parts_of

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

RAISED = str.maketrans("01234", "⁰¹²³⁴")
CLOSE, MOST = 1e-9, 40      # relative: of a sum of waves and the engine's value; how often a wave comes back


class ReflectingEnd(NamedTuple):
    """r of an end in letters, and what damps there, None where nothing does."""

    r: Any
    damps: Any = None


class WavesOfMember:
    """The lines of the only member of a scene, which is one piece without weight or foundation; None of others."""

    def __init__(self, problem: "Problem", sheet: WorkedSolution) -> None:
        self.problem, self.sheet, self.scene, self.table = problem, sheet, problem.scene, problem.scene.table
        self.floats = problem.numeric.floats
        self.placed, = problem.symbolic.linearisation.pieces
        piece = self.placed.piece
        self.S, self.mu, self.L = piece.tension, piece.inertia, piece.length
        self.u = {"phi": "φ"}.get(letter := problem.scene.members[self.placed.owner].kind.letter, letter)

    def write(self, uses: list[int], beside: bool) -> None:
        """Write down all of them, `beside` another way; nothing where waves do not keep their form, or it does not
        start from rest."""
        ends, start = [self._end(row) for row in self.placed.rows], self._start()
        if None in ends or start is None:
            return
        shape, node = start
        c, *self.waves = (self.table.parameter(self.sheet.letter(letter)) for letter in ("c", "f1", "f2"))
        one, other = self.waves
        speed = textbook(self.table.sqrt(self.S / self.mu))
        self.speed = evaluate([speed], Floats, self.floats)[0]
        words = Words("or " * beside + "by waves, which travel along it with  ")
        line = self.sheet.write(words, c, " = ", speed, *number(self.speed, "m/s"), Words(":  "), f"{self.u} = ", one,
                                "(x − ", c, "·t) + ", other, "(x + ", c, "·t)", settles=c.name, node=speed,
                                value=self.speed, unit="m/s", uses=uses)
        half = [] if node is None else [" = ", node / 2]
        held = [] if beside else as_held(self.problem, self.u)
        lines = [line, self.sheet.write(Words("from rest  "), one, "(x) = ", other, f"(x) = {self.u}(x, 0)/2", *half,
                                        Words("  along it"), *held, settles="waves at the start", uses=[line])]
        reflected = [self._reflected(end, k, lines[:1]) for k, end in enumerate(ends)]
        factors = [evaluate([end.r], Floats, self.floats)[0] for end in ends]
        length, = evaluate([self.L], Floats, self.floats)
        self.of_one, self.of_other = (_wave(shape, length, factors, which) for which in (-1, 1))
        for one in self.problem.spec.answers:
            self._asked(one.asked, [*lines, *reflected])

    def _end(self, row: "dict[int, Node]") -> ReflectingEnd | None:
        """An end by what acts on it; None of one that has mass or a spring, or moves with other things."""
        if not row:
            return ReflectingEnd(-self.table.one)
        M, C, G, K = self.problem.symbolic.discrete_matrices
        i, *more = row
        if more or row[i] is not self.table.one or any(i in pair for pair in (*M, *G, *K)) or any(
                i in pair and pair != (i, i) for pair in C):
            return None
        if (i, i) not in C:
            return ReflectingEnd(self.table.one)
        b, Z = C[i, i], self.table.parameter(self.sheet.letter("Z"))
        return ReflectingEnd(textbook((self._impedance - b) / (self._impedance + b)), (Z, b))

    @property
    def _impedance(self) -> "Node":
        return self.table.sqrt(self.S * self.mu)

    def _start(self) -> "tuple[Callable[..., Any], Node | None] | None":
        """(u(x, 0) from rest as a function, its expression where the file gives it); None of what moves at t = 0, or
        does not start."""
        scene, problem = self.scene, self.problem
        if scene.timed or problem.response.deviations[1].any():
            return None
        given = member_fields(scene).get(self.placed.owner)
        if given is not None and given.rate is None and given.displacement is not None:
            node, = substitute([given.displacement], {scene.time: self.table.parameter("x")})
            return (lambda x: evaluate([given.displacement], Floats, {**self.floats, scene.time.name: x})[0]), node
        powers = _held_shape(problem) if given is None and problem.spec.let_go else None
        return None if powers is None else ((lambda x: sum(c * x**k for k, c in enumerate(powers))), None)

    def _reflected(self, end: Any, right: Any, uses: list[int]) -> int:
        """The line of what comes back from an end."""
        L = self.L
        where = [Words("at x = "), L, Words(":  ")] if right else [Words("at x = 0:  ")]
        (one, other), s = self.waves, self.table.parameter(self.sheet.letter("s"))
        back, comes = ([other, "(", L, " + ", s, ")"], [one, "(", L, " − ", s, ")"]) if right else (
            [one, "(−", s, ")"], [other, "(", s, ")"])
        if end.damps is None:
            sign = "" if end.r is self.table.one else "−"
            held = "free" if not sign else "held"
            return self.sheet.write(*where, *back, f" = {sign}", *comes, Words(f",  as it is {held}"),
                                    settles=f"end {right}", uses=uses)
        (Z, b), r = end.damps, self.table.parameter(self.sheet.letter("r"))
        (size, factor), unit = evaluate([self._impedance, end.r], Floats, self.floats), (
            "N·m·s" if self.u == "φ" else "N·s/m")
        at = [f"{self.u}(", L, ", 0)/2"] if right else [f"{self.u}(0, 0)/2"]
        self.sheet.write(Words("impedance of the member  "), Z, " = ", textbook(self._impedance), *number(
            size, unit), settles=Z.name, node=self._impedance, value=size, unit=unit, uses=uses)
        return self.sheet.write(*where, r, " = ", (Z - b) / (Z + b), *number(factor), Words(",  "), *back, " = ", r,
                                "·", *comes, " + (1 − ", r, ")·", *at, settles=r.name, node=end.r, value=factor,
                                uses=[self.sheet.last])

    def _asked(self, asked: "Expression", uses: list[int]) -> None:
        """A place at an instant by both waves, where they give what the engine does."""
        tree = asked.tree
        if getattr(tree, "head", "") != VALUE or not isinstance(tree.args[0], NameRef) or tree.args[0].primes or (
                parts_of(tree.args[1]).quantities):
            return
        signal = signal_name(tree.args[0].name)
        if signal.name != self.placed.owner or signal.part != self.problem.scene.members[signal.name].kind.letter or (
                signal.primes):
            return
        x, t = (self._number(part) for part in (parse(signal.place), tree.args[1]))
        try:
            value = float(value_of(self.problem, asked)[0])
            one, other = self.of_one(x - self.speed * t), self.of_other(x + self.speed * t)
        except (PhysicsError, RecursionError):
            return
        size = abs(one) + abs(other)
        if abs(one + other - value) <= CLOSE * size:
            text = as_printed(asked.text, {*self.problem.spec.parameters, *self.problem.spec.coordinates})
            unit, sign = unit_told(self.problem.spec, asked), "−" if other < 0 else "+"
            first, second = self.waves
            self.sheet.write(Words(f"{text}:  "), first, f"({told(x - self.speed * t)}) + ", second,
                             f"({told(x + self.speed * t)}) = {told(one)} {sign} {told(abs(other))}", *number(
                                 value, unit), settles=asked.text, value=value, unit=unit, uses=uses)

    def _number(self, tree: Any) -> float:
        node = lower(tree, self.table, lambda name, *_: self.scene.parameters.nodes[name])
        return float(evaluate([node], Floats, self.floats)[0])


def _wave(shape: Callable[[float], Any], length: float, factors: list[float], which: int) -> Callable[..., float]:
    """f of which = −1, g of which = 1, along the member and beyond its ends by what comes back from them."""
    rates = dict(zip((-1, 1), factors, strict=True))

    def at(x: float, side: int, left: int) -> float:
        if 0 <= x <= length:
            return float(shape(x)) / 2
        if not left or (x < 0) != (side < 0):
            raise PhysicsError("this wave is not followed as far")
        end = length if side > 0 else 0.0
        return rates[side] * at(2 * end - x, -side, left - 1) + (1 - rates[side]) * float(shape(end)) / 2

    return lambda x: at(_within(x, length), which, MOST)


def _within(x: float, length: float) -> float:
    """A place that rounding alone puts beyond an end is there."""
    near = min((0.0, length), key=lambda end: abs(x - end))
    return near if abs(x - near) <= CLOSE * length else x


def _held_shape(problem: "Problem") -> list[float] | None:
    """Coefficients of the powers of x in which what lets go holds the only piece, from rest; None of other shapes."""
    pieces, held = problem.configuration.linear_system.pieces, problem.configuration.preloaded
    if len(pieces) != 1 or held is None:
        return None
    shapes = [polynomial_at_rest(one, pieces[0], 4) for one in (held, problem.configuration)]
    if any(one is None for one in shapes):
        return None
    size = max(map(abs, shapes[0]))
    return [float(a - b) if abs(a - b) > CLOSE * size else 0.0 for a, b in zip(*shapes, strict=True)]


def as_held(problem: "Problem", u: str) -> list[Any]:
    """Parts of how a member is held until it is let go."""
    if not problem.spec.let_go:
        return []
    text = "".join((" − " if c < 0 else " + ") + told(abs(c)) + ("·x" + str(k).translate(RAISED)).removesuffix("¹") * (
        k > 0) for k, c in enumerate(_held_shape(problem) or ()) if c)
    shape = "−" * text.startswith(" − ") + text[3:]
    return [Words(f",  as {problem.spec.let_go} held it"), *([Words(":  "), f"{u}(x, 0) = {shape}"] if text else [])]


def tell_waves(problem: "Problem", sheet: WorkedSolution, uses: list[int], beside: bool) -> None:
    """Write down the motion by waves, `beside` that by modes, of what is let go from rest and keeps the form of its
    waves."""
    pieces = problem.symbolic.linearisation.pieces
    if len(pieces) != 1 or problem.spec.get("damping") is not None:
        return
    piece = pieces[0].piece
    if piece.bending.is_zero and piece.gradient.is_zero and piece.drag.is_zero and piece.foundation.is_zero:
        WavesOfMember(problem, sheet).write(uses, beside)
