"""What a member does between its stations and at each of them: its differential equation, and what holds there."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.notation.names import GREEK
from vibcli.report.blocks import Words
from vibcli.report.sections.members import differential, station_conditions
from vibcli.report.steps.step import WorkedSolution

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene

ALONG = {"φ": "turn"}


class MemberConditions:
    """Those of the members of a scene, written on a sheet; what elements of several members fulfil is told of the first
    one."""

    def __init__(self, sheet: WorkedSolution, scene: "Scene", pieces: Sequence[Any], matrices: Any) -> None:
        self.sheet, self.scene, self.pieces, self.matrices = sheet, scene, pieces, matrices
        self._told: dict[tuple[Any, ...], tuple[str, list[int]]] = {}     # {equations: (member, lines)}

    def write(self, name: str) -> tuple[int | None, list[int]]:
        """(the line of the differential equation, those of the stations) of a member."""
        member, pieces = self.scene.members[name], [piece for piece in self.pieces if piece.owner == name]
        u = GREEK.get(member.kind.letter, member.kind.letter)
        equations = tuple(one.parts for one in differential(pieces, u))
        first, lines = self._told.get(equations, (name, []))
        alike = f",  an element moves as one of {first}" if lines else ""
        self.sheet.write(f"{u}(x, t)", Words(f":  {ALONG.get(u, 'displacement')} of {name} at x, counted from its left "
                                             f"end{alike}"), settles=u)
        lines = lines or [self.sheet.write(Words("motion of an element dx:  "), *parts, settles=f"equation of {name}")
                          for parts in equations]
        self._told.setdefault(equations, (name, lines))
        whose = [Words(f"of {name} ")] * (len(self.scene.members) > 1)
        held = [self.sheet.write(*whose, *one.label, Words(":  "), *one.parts, settles="", uses=lines[-1:])
                for one in station_conditions(member, self.pieces, self.matrices, self.scene)]
        return (lines or [None])[-1], held
