"""The motion of coordinates whose constants lines tell as numbers alone: each has a letter, in whose place that number
stands."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.notation.numbers import figure
from vibcli.report.blocks import Factor, WithNumbers
from vibcli.report.steps.free_waves import FreeWave, ToldMotion
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


class KeptUpPart(NamedTuple):
    """What loads keep up of a coordinate: [" + ", part, …], and as waves; None where it is none of Ωt."""

    told: list[Any]
    waves: Any


NOTHING_KEPT = KeptUpPart([], [])


class NumberedWave(NamedTuple):
    """e^{−δₖt} (A cos ωₖt + B sin ωₖt) of a coordinate, and up to where A and B are rounding."""

    order: int
    A: float
    B: float
    damped: bool
    nothing: float


def know_waves(about: AboutRest, sheet: WorkedSolution, name: str, waves: "Iterable[NumberedWave]",
               kept: "Sequence[FreeWave] | None", line: int) -> None:
    """Let the last line tell them, beside what is kept up."""
    if kept is None:
        return
    unit, table = "m" if about.problem.system.dimension(name) else "rad", about.table
    found = list(kept)
    for wave in waves:
        constants = []
        for letter, value in (("A", wave.A), ("B", wave.B)):
            if abs(value) <= wave.nothing:
                constants.append(table.zero)
                continue
            symbol = table.parameter(sheet.letter(f"{letter}{wave.order}", name))
            sheet.write(settles=symbol.name, letter=symbol.name, value=abs(value), unit=unit, joined=True, uses=[line])
            sheet.in_numbers[symbol.name] = abs(value)
            constants.append(symbol if value > 0 else -symbol)
        rate, delta = (table.parameter(sheet.letter(f"{letter}{wave.order}")) for letter in (
            "omega_d" if wave.damped else "omega", "delta"))
        if any(not part.is_zero for part in constants):
            found.append(FreeWave(*constants, rate, delta if wave.damped else table.zero))
    sheet.waves[name] = ToldMotion(found, line)


def know_decay(sheet: WorkedSolution, order: int, delta: float, rate: float, line: int) -> None:
    """Let the last line tell the letters of δ and ω_d of a mode."""
    for letter, value, unit in (("delta", delta, "1/s"), ("omega_d", rate, "rad/s")):
        name = sheet.letter(f"{letter}{order}")
        sheet.write(settles=name, letter=name, value=value, unit=unit, joined=True, uses=[line])


def with_numbers(sheet: WorkedSolution, told: "Sequence[Any]") -> list[Any]:
    """Parts with the numbers of such letters in their place."""
    parts: list[Any] = []
    for part in told:
        node: Node | None = getattr(part, "node", part) if isinstance(part, Factor) or hasattr(part, "op") else None
        names = {} if node is None else {one.name: figure(sheet.in_numbers[one.name]) for one in reachable([node])
                                         if one.op == "symbol" and one.name in sheet.in_numbers}
        shown = [WithNumbers(node, names) if names else part]
        parts += ["(", *shown, ")"] if names and isinstance(part, Factor) and part.node.op == "sum" else shown
    return parts
