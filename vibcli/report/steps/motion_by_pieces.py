"""The motion of the only coordinate as the sum of what pieces of a load bring about,

    x(t) = Σ fₖ u(t − tₖ)  of the pieces that have begun by then,

at an instant (Thomson & Dahleh 1998, section 4.2)."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import islice
from math import pi
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Factor, Name
from vibcli.report.steps.instances import INSTANCES, instances
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.report.steps.step import WorkedSolution
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

LATE = 1e-9         # relative: of an instant at which a piece has begun, and of an angle
PARTS = 12          # of half a turn, of which sines and cosines are put in


class ToldPiece(NamedTuple):
    """factor·unit(t − begins), and the name of the unit response."""

    factor: Any
    begins: Any
    unit: Any
    name: str
    kind: str


class MotionByPieces(NamedTuple):
    """The pieces of a motion, the letter of the time since one began, the number of the line that adds them up, and
    where it settles; None where it does not."""

    pieces: Sequence[ToldPiece]
    tau: Any
    line: int
    settles: Any

    def begun(self, at: float, values: "Mapping[str, float]") -> list[ToldPiece]:
        """The pieces that do something at an instant, where the letters have these values: an impulse at once."""
        starts = evaluate([piece.begins for piece in self.pieces], Floats, values)
        late = LATE * max(abs(at), *map(abs, starts))
        return [piece for piece, start in zip(self.pieces, starts, strict=True)
                if at > start + late or (piece.kind == "impulse" and at >= start - late)]

    def value(self, pieces: "Sequence[ToldPiece]", t: "Node", time: "Node", rate: int = 0) -> "Node":
        """The sum of such pieces at an instant, of their rates of change or those of these."""
        found = t.table.zero
        for piece in pieces:
            unit, = substitute([piece.unit], {self.tau: time})
            for _ in range(rate):
                unit = gradient(unit).get(time, t.table.zero)
            found = found + piece.factor * substitute([unit], {time: t - piece.begins})[0]
        return found

    def told(self, pieces: "Sequence[ToldPiece]", t: "Node", rate: int = 0) -> list[Any]:
        """Parts of the same by the names of the unit responses."""
        parts: list[Any] = []
        for piece in pieces:
            negative = piece.factor.op != "sum" and piece.factor.coefficient < 0
            size = -piece.factor if negative else piece.factor
            sign = [" − " if parts else "−"] if negative else [" + "] if parts else []
            factor = [] if size is size.table.one else [Factor(size), "·"]
            parts += [*sign, *factor, Name(piece.name + "'" * rate), "(", t - piece.begins, ")"]
        return parts


def shortest(problem: "Problem", sheet: "WorkedSolution", node: "Node") -> "Node":
    """An expression of a scene in letters in its shortest form: sines and cosines of what are parts of a turn whatever
    the letters, and what lines have for ω, put in."""
    if not problem.numeric.has_free_symbols:
        return node
    known = [values for _, values in islice(instances(problem, sheet), INSTANCES)]
    of = {line.letter: line.node for line in sheet.steps if line.settles == "omega[1]" and line.letter}
    parameters, table = problem.scene.parameters, node.table
    put_in = {table.parameter(name): found for name, found in of.items()}
    put_in |= {parameters.nodes[name]: found for name, found in parameters.in_letters.items()}
    turned = textbook(substitute([node], _parts_of_a_turn(node, known))[0])
    return min(node, turned, textbook(substitute([turned], put_in)[0]), key=letters)


def _parts_of_a_turn(node, known):
    """{sine or cosine: its value} where the angle is π by a small fraction at all values of the letters."""
    found = {}
    for call in reachable([node]):
        if call.op == "call" and call.name in ("sin", "cos"):
            halves = [evaluate(list(call.args), Floats, values)[0] / pi for values in known]
            fraction = Fraction(halves[0]).limit_denominator(PARTS) if halves else None
            if halves and all(abs(half - fraction) <= LATE * max(1.0, abs(half)) for half in halves):
                table = node.table
                found[call] = table.call(call.name, table.pi * table.number(fraction))
    return found
