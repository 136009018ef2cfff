"""What the ends of one uniform member leave of the constants of its shape X(x), x from the left:

    bars, shafts, strings   S X′(0) = Z X(0)                  S X′(L) = −Z X(L)
    beams                   X = C₁ f(βx) + C₂ g(βx), f and g by the left end; at the right one
                            EI X‴ = Z X or X = 0, and EI X″ = −Z X′ or X′ = 0

with Z = k − ω²M of what acts on an end.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

from vibcli.analyses.closed_form.member_shapes import LEFT, SLOPE, shape
from vibcli.base.errors import PhysicsError
from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.held import HINT, UNTOLD
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.member_frequencies import FrequencyEquation
    from vibcli.symbolic.node import Node

NOTHING, BESIDE = 1e-6, 1.05        # relative: of what vanishes at a root, and what it is beside it


class Ends:
    """The lines on the constants of a chain that is one piece, and what they make vanish at each root."""

    def __init__(self, found: "FrequencyEquation", sheet: WorkedSolution) -> None:
        self.found, self.sheet, self.x = found, sheet, found.wave_number
        self.table = self.x.table
        piece = found.pieces[0].piece
        self.stiffness = piece.tension if piece.bending.is_zero else piece.bending
        self.beta = self.x / piece.length
        self._vanishes: list[tuple[Any, ...]] = []

    def write(self, uses: list[int]) -> list[int] | None:
        """Write down the shape by the left end and what the right end asks; None where that is not simple."""
        return self._second_order(uses) if self.found.order == 2 else self._fourth_order(uses)

    def _second_order(self, uses: list[int]) -> list[int]:
        """X = C f(βx), C (S β f′ + Z f) = 0 at βL."""
        (left,), (right,) = self.found.impedances
        along, table = self.table.parameter("βx"), self.table
        ratio = None if left is None or left.is_zero else left / (self.stiffness * self.beta)
        parts = {"sin": table.one} if left is None else {"cos": table.one, **({} if ratio is None else {"sin": ratio})}
        constant = self.sheet.letter("C2" if left is None else "C1")
        line = self.sheet.write(Words("the left end leaves  "), "X = ", Name(constant), "·", Factor(_sum(parts, along)),
                                settles="shape", uses=uses)
        f, slope = _sum(parts, self.x), _sum(_slope(parts), self.x)
        terms = [f] if right is None else [slope] if right.is_zero else [self.stiffness * self.beta * slope, right * f]
        self._vanishes = [tuple(terms)]
        return [self.sheet.write(Words("the right end asks for  "), Name(constant), "·", Factor(table.total(terms)),
                                 " = 0", settles="right end", uses=[line, *uses])]

    def _fourth_order(self, uses: list[int]) -> list[int] | None:
        """X = C₁ f + C₂ g, and two conditions at βL."""
        ends, table = self.found.impedances, self.table
        if any(Z is not None and not Z.is_zero for Z in ends[0]) or len(ends[1]) > 2:
            return None
        along = table.parameter("βx")
        left = [{name: table.number(sign) for name, sign in one.items()}
                for one in LEFT[ends[0][0] is None, ends[0][-1] is None]]
        constants = [self.sheet.letter(f"C{k}") for k in (1, 2)]
        line = self.sheet.write(Words("the left end leaves  "), "X = ", *self._combined(
            constants, [_sum(one, along) for one in left]), settles="shape", uses=uses)
        rows = [[self._shear(one, ends[1][0]) for one in left], [self._moment(one, ends[1][1]) for one in left]]
        (a, b), (c, d) = rows
        self._vanishes = [(a * d, -(b * c))]
        lines = [self.sheet.write(Words("the right end asks for  "), *self._combined(constants, row), " = 0",
                                  settles="right end", uses=[line, *uses]) for row in rows]
        drawn = shape(self.found)
        if drawn is not None and drawn.sigma is not None:
            above, below = drawn.sigma
            self.sheet.write(Words("by one of them  "), "X = ", Name(constants[0]), "·(", drawn.first, " − σ·",
                             Factor(drawn.second), ")", Words(",  "), "σ = ", above / below,
                             settles="sigma", uses=lines)
        return lines

    def _combined(self, constants: Sequence[str], nodes: "Sequence[Node]") -> list[Factor | Name | str]:
        return [part for name, node in zip(constants, nodes, strict=True) for part in (
            " + ", Name(name), "·", Factor(node))][1:]

    def _shear(self, f: "Mapping[str, Node]", Z: Any) -> "Node":
        """f where it is held, f‴ where it is free, else EI β³ f‴ − Z f."""
        third = _sum(_slope(_slope(_slope(f))), self.x)
        if Z is None or Z.is_zero:
            return _sum(f, self.x) if Z is None else third
        return cast("Node", self.stiffness * self.beta ** 3 * third - Z * _sum(f, self.x))

    def _moment(self, f: "Mapping[str, Node]", Z: Any) -> "Node":
        """f′ where it is held, f″ where it is free, else EI β² f″ + Z β f′."""
        second, first = _sum(_slope(_slope(f)), self.x), _sum(_slope(f), self.x)
        if Z is None or Z.is_zero:
            return first if Z is None else second
        return cast("Node", self.stiffness * self.beta ** 2 * second + Z * self.beta * first)

    def hold(self, root: float, floats: Mapping[str, float]) -> None:
        """PhysicsError where what the lines make vanish does not at a root."""
        for terms in self._vanishes:
            values, beside = (evaluate(list(terms), Floats, {**floats, self.x.name: at}) for at in (
                root, BESIDE * root))
            if not abs(sum(values)) <= NOTHING * sum(map(abs, beside)):
                raise PhysicsError(UNTOLD, HINT)


def _sum(terms: "Mapping[str, Node]", argument: "Node") -> "Node":
    table = argument.table
    return table.total([factor * table.call(name, argument) for name, factor in terms.items()])


def _slope(terms: "Mapping[str, Node]") -> "dict[str, Node]":
    return {SLOPE[name][0]: SLOPE[name][1] * factor for name, factor in terms.items()}
