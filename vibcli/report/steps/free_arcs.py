"""From each bend of a load in pieces on, the free motion that goes on from there, where something is asked of how far
the coordinate then goes: about x_s = ΣF/K, where no piece grows or swings,

    x = x_s + e^{−δτ} (A cos ω_dτ + B sin ω_dτ),   τ = t − tₖ,   A = x(tₖ) − x_s,   B = (ẋ(tₖ) + δA)/ω_d."""

from typing import TYPE_CHECKING, Any, cast

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Factor, Name, Words
from vibcli.report.steps.degree import Degree
from vibcli.report.steps.extremes import Swing, asked_extremes, tell_extremes
from vibcli.report.steps.instances import instances
from vibcli.report.steps.motion_by_pieces import MotionByPieces, ToldPiece
from vibcli.report.steps.parts_of_a_turn import shortest
from vibcli.report.steps.resonance import ROUNDED
from vibcli.report.steps.step import number
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.nested_form import letters

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.symbolic.node import Node

LONG = 4            # letters of an instant, beyond which it has one of its own
ROOM = 22           # lines, behind which none is told
WAVES = "sin", "cos"


class LoadBend(NamedTuple):
    """The number of an instant at which pieces begin, it, those that began before, all that have begun, and x_s."""

    order: int
    at: Any
    before: "Sequence[ToldPiece]"
    begun: "Sequence[ToldPiece]"
    rest: Any

    @property
    def blows(self) -> "list[ToldPiece]":
        """The impulses at it."""
        return [piece for piece in self.begun if piece.kind == "impulse" and piece not in self.before]


def tell_arcs(degree: Degree, motion: MotionByPieces) -> None:
    """Write down those in which the engine finds an extreme that is asked, else the last one; where there is room."""
    if degree.sheet.last >= ROOM:
        return
    rest, bends, before = degree.about.place[degree.about.scene.q[0]], _bends(degree, motion), len(degree.sheet.steps)
    for bend in bends if asked_extremes(degree) else ():
        written = len(degree.sheet.steps)
        if bend.before or bend.blows:
            swing = _Arc(degree, motion, bend).write()
        else:
            swing = Swing(rest + bend.rest, -bend.rest, None, bend.at, motion.line)
        told = len(degree.sheet.steps)
        tell_extremes(degree, swing)
        if len(degree.sheet.steps) == told:
            del degree.sheet.steps[written:]
    behind = {piece.begins for piece in motion.pieces} - {motion.pieces[0].begins}
    if len(degree.sheet.steps) == before and bends and bends[-1].at in behind:
        _Arc(degree, motion, bends[-1]).write()


def _bends(degree: Degree, motion: MotionByPieces) -> "list[LoadBend]":
    """Those behind which no piece grows or swings, in order; none where the letters leave the order open."""
    orders, instants = [], list(dict.fromkeys(piece.begins for piece in motion.pieces))
    for values in degree.about.samples:
        known = evaluate(instants, Floats, values)
        orders.append(sorted(range(len(instants)), key=known.__getitem__))
    if any(order != orders[0] for order in orders):
        return []
    rank, found = {instants[i]: place for place, i in enumerate(orders[0])}, []
    for order, at in enumerate(rank, 1):
        before, begun = ([piece for piece in motion.pieces if rank[piece.begins] < end] for end in (order - 1, order))
        rest = rest_behind(degree, at, begun)
        if rest is not None:
            found.append(LoadBend(order, at, before, begun, rest))
    return found


def rest_behind(degree: Degree, at: "Node", begun: "Sequence[ToldPiece]") -> "Node | None":
    """x_s about which it swings from an instant on; None where a piece grows or swings."""
    table, ramps = degree.about.table, [piece for piece in begun if piece.kind == "ramp"]
    grows = not degree.about.tidy(table.total([piece.factor for piece in ramps])).is_zero
    if grows or not _cancel(degree, [piece for piece in begun if piece.kind in WAVES]):
        return None
    load = [piece.factor for piece in begun if piece.kind == "step"] + [
        piece.factor * (at - piece.begins) for piece in ramps]
    return degree.about.tidy(table.total(load) / degree.K)


def _cancel(degree: Degree, waves: "Sequence[ToldPiece]") -> bool:
    """Do waves that have begun add up to nothing?"""
    table, (sine, _) = degree.about.table, WAVES
    turned = [(piece, piece.rate * piece.begins) for piece in waves]
    along = [piece.factor * (table.call("cos", at) if piece.kind == sine else table.call("sin", at))
             for piece, at in turned]
    across = [piece.factor * (-table.call("sin", at) if piece.kind == sine else table.call("cos", at))
              for piece, at in turned]
    return all(degree.about.cancel(parts, ROUNDED) for parts in (along, across))


class _Arc:
    """The motion from a bend on."""

    def __init__(self, degree: Degree, motion: MotionByPieces, bend: LoadBend) -> None:
        self.degree, self.motion, self.bend, self.sheet, self.table = (degree, motion, bend, degree.sheet,
                                                                       degree.about.table)
        self.A, self.B = (degree.about.letter(self.sheet.letter(f"{letter}{bend.order}")) for letter in "AB")
        self.damped = not degree.C.is_zero
        self.rate = degree.omega_d if self.damped else degree.omega
        self.delta = degree.delta if self.damped else self.table.zero
        own = letters(bend.at) > LONG
        self.at = degree.about.letter(self.sheet.letter("t", f"b{bend.order}")) if own else bend.at

    def write(self) -> Swing:
        """Write down its line, with its constants."""
        (_, _, before, _, rest), sheet, table, tau = self.bend, self.sheet, self.table, self.motion.tau
        t, blows = self.degree.problem.scene.time, table.total([piece.factor for piece in self.bend.blows])
        blow = blows / self.degree.M
        place, speed = (self.motion.value(before, self.bend.at, t, order) for order in (0, 1))
        A = table.zero if (place - rest).is_zero else self.A
        wave = A * table.call("cos", self.rate * tau) + self.B * table.call("sin", self.rate * tau)
        fading = table.call("exp", -(self.delta * tau)) if self.damped else table.one
        since = [] if self.at.is_zero else [Words("  with  "), f"{tau.name.replace('tau', 'τ')} = ", t - self.at]
        line = sheet.write(Words("from  "), f"{t.name} = ", self.at, *([" = ", self.bend.at] * (
            self.at is not self.bend.at)),
                           Words(" on"), *since, Words(":  "), Name(self.degree.name), " = ",
                           *([] if rest.is_zero else [rest, " + "]),
                           *([fading, "·", Factor(wave)] if self.damped else [wave]),
                           settles=f"motion from bend {self.bend.order}", uses=[self.motion.line],
                           node=rest + fading * wave)
        if self.at is not self.bend.at:
            self._settle(self.at, self.bend.at, "s", line)
        told = [*self.motion.told(before, self.bend.at), *_sum([-rest], bool(before))]
        if not A.is_zero:
            self._constant(A, place - rest, told, line)
        told = [*self.motion.told(before, self.bend.at, 1), *_sum([blow, self.delta * A], bool(before))]
        several = len(before) + (not blow.is_zero) + (not (self.delta * A).is_zero) > 1
        self._constant(self.B, (speed + blow + self.delta * A) / self.rate, [
            *(["(", *told, ")"] if several else told), "/", self.rate], line)
        place_of_rest = self.degree.about.place[self.degree.about.scene.q[0]]
        return Swing(place_of_rest + rest, A, self.B, self.at, line, beside=True)

    def _constant(self, letter: "Node", node: "Node", told: "Sequence[Factor | Name | Node | str]", line: int) -> None:
        """The entry of A or of B; of letters by its simplest form as well, where that is short."""
        plainly = shortest(self.degree.problem, self.sheet, node)
        shown: list[Any] = [" = ", plainly] if letters(plainly) <= LONG and self._value(node) is None else []
        self._settle(letter, plainly if shown else node, self.degree.unit, line, [letter, " = ", *told, *shown])

    def _settle(self, letter: Any, node: "Node", unit: str, line: int,
                shown: "Sequence[Factor | Name | Node | str]" = ()) -> None:
        value = self._value(node)
        self.sheet.write(*shown, *(number(value, unit) if shown and value is not None else ()), settles=letter.name,
                         node=node, value=value, unit="" if value is None else unit, letter=letter.name, joined=True,
                         uses=[line])

    def _value(self, node: "Node") -> float | None:
        if self.degree.problem.numeric.has_free_symbols:
            return None
        return cast("float | None", evaluate([node], Floats, next(instances(self.degree.problem, self.sheet))[1])[0])


def _sum(nodes: "Sequence[Node]", behind: bool) -> list[Any]:
    """Parts of further terms, each with its sign; `behind` others."""
    parts: list[Any] = []
    for node in nodes:
        if not node.is_zero:
            negative = node.op != "sum" and node.coefficient < 0
            sign = " − " if negative else " + "
            parts += [sign if behind or parts else "−" if negative else "", Factor(-node if negative else node)]
    return [part for part in parts if part != ""]
