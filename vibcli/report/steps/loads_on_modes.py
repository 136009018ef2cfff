"""Loads on the modes of several degrees of freedom: in pieces that begin, end and strike, or others; and whether the
motion that lines add up of pieces is what the engine finds."""

from random import Random
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.report.steps.instances import instances
from vibcli.report.steps.motion_by_pieces import MotionByModes
from vibcli.report.steps.pieces import WAVES, LoadPiece, pieces_of
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution, number
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.node import is_number
from vibcli.symbolic.syntax import NameRef

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.symbolic.node import Node

SEEN, LONG, CLOSE = 3, 3.0, 1e-8        # instants at which the engine is asked; seconds behind pieces; relative


class LoadsOnModes(NamedTuple):
    """The rows that loads act on, and {row: pieces}; None where one is not made of pieces, or they swing at several
    frequencies."""

    rows: "Sequence[int]"
    pieces: "Mapping[int, Sequence[LoadPiece]] | None"

    def frequency(self, about: AboutRest, sheet: WorkedSolution, uses: "Sequence[int]") -> "Node":
        """The letter of Ω of loads that swing, told where that is an expression or a number; zero of others."""
        rate = next((piece.rate for pieces in (self.pieces or {}).values() for piece in pieces if piece.kind in WAVES),
                    about.table.zero)
        if rate.is_zero or rate.op == "symbol":
            return rate
        Omega, value = about.letter(sheet.letter("Omega")), about.value(rate)
        sheet.write(Omega, *([] if is_number(rate) else [" = ", rate]), *number(value or 0.0, "rad/s"), node=rate,
                    settles=Omega.name, letter=Omega.name, value=value, unit="rad/s", uses=uses)
        about.know(Omega, value)
        return Omega


def loads_on_modes(about: AboutRest, drive: "Mapping[int, Node]") -> LoadsOnModes:
    """Those of the right sides of the equations."""
    found = {i: pieces_of(about.scene, load) for i, load in drive.items()}
    pieces = {i: own for i, own in found.items() if own is not None}
    rates = {piece.rate for own in pieces.values() for piece in own} - {None}
    return LoadsOnModes(list(drive), pieces if len(pieces) == len(found) and len(rates) <= 1 else None)


def is_of_engine(about: AboutRest, sheet: WorkedSolution, name: str, motion: MotionByModes) -> bool:
    """Is the motion of a coordinate what the engine finds at some instants?"""
    from numpy import array

    problem, time = about.problem, about.scene.time
    (_, lettered), = instances(problem, sheet)
    known = {**about.numbers(), **lettered, **sheet.in_numbers}
    end = max(evaluate([piece.begins for piece in motion.by_pieces.pieces], Floats, known), default=0.0) + LONG
    draw, rest = Random("instants"), problem.configuration.equilibrium.values[name]
    instants = [draw.uniform(0, end) for _ in range(SEEN)]
    mine = [evaluate([motion.value(motion.begun(at, known), time, time)], Floats, {**known, time.name: at})[0]
            for at in instants]
    of_engine = problem.response.signal(NameRef(0, len(name), name, 0)).values(array(instants)) - rest
    return all(abs(one - other) <= CLOSE * max(map(abs, of_engine)) for one, other in zip(mine, of_engine, strict=True))
