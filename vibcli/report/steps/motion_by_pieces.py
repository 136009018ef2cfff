"""The motion of the only coordinate as the sum of what pieces of a load bring about,

    x(t) = Σ fₖ u(t − tₖ)  of the pieces that have begun by then,

at an instant (Thomson & Dahleh 1998, section 4.2)."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.blocks import Factor, Name
from vibcli.report.steps.complex_numbers import factor_told
from vibcli.report.steps.step import told
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.symbolic.node import Node

AT_ONCE = "impulse", "place"        # kinds of pieces that do something when they begin
LATE = 1e-9         # relative: of an instant at which a piece has begun


class ToldPiece(NamedTuple):
    """factor·unit(t − begins), the name of the unit response, and Ω of a wave."""

    factor: Any
    begins: Any
    unit: Any
    name: str
    kind: str
    rate: Any = None


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
                if at > start + late or (piece.kind in AT_ONCE and at >= start - late)]

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


class PartOfMode(NamedTuple):
    """What a coordinate has of a mode, the name of the normal coordinate, and whether it is complex, one of a pair."""

    size: complex
    name: Name
    pair: bool = False

    def told(self, t: "Node | None", rate: int, first: bool) -> list[Any]:
        """Parts of ` + 2·p(t)`, or ` + 2·Re((1 + 2·i)·z(t))`; at an instant where one is given."""
        of = [Name(self.name.text + "'" * rate), *([] if t is None else ["(", t, ")"])]
        if self.pair:
            size = factor_told(self.size)
            factor = f"{size}·" * (size != "1")
            return [*([] if first else [" + "]), f"2·Re({factor}", *of, ")"]
        value = complex(self.size).real
        sign = "−" if value < 0 else "+"
        size = told(abs(value))
        head = [sign.strip("+") if first else f" {sign} ", f"{size}·" * (size != "1")]
        return [*filter(None, head), *of]


class MotionByModes(NamedTuple):
    """The same of a coordinate of several, and what that has of each mode."""

    by_pieces: MotionByPieces
    modes: Sequence[PartOfMode]

    @property
    def line(self) -> int:
        return self.by_pieces.line

    @property
    def settles(self) -> None:
        return None

    def begun(self, at: float, values: "Mapping[str, float]") -> list[ToldPiece]:
        """The pieces that do something at an instant."""
        return self.by_pieces.begun(at, values)

    def value(self, pieces: "Sequence[ToldPiece]", t: "Node", time: "Node", rate: int = 0) -> "Node":
        """The sum of such pieces, of their rates of change or those of these."""
        return self.by_pieces.value(pieces, t, time, rate)

    def told(self, _: "Sequence[ToldPiece]", t: "Node | None", rate: int = 0) -> list[Any]:
        """Parts of Σ uₖ pₖ, at an instant where one is given."""
        return [part for k, mode in enumerate(self.modes) for part in mode.told(t, rate, not k)]
