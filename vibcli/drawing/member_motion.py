"""Modes along members, from their exact fields."""

from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.drawing.layout.strips import Strip, resting
from vibcli.drawing.symbols.member import Bend

if TYPE_CHECKING:
    from vibcli.drawing.layout.compose import Scenery
    from vibcli.drawing.layout.sketch import Sketch

RESTS = 1e-9        # of the most that a member moves


class MemberMode(NamedTuple):
    """A mode along a member: its fields times a factor, where it rests, the most that it moves."""

    strip: Strip
    fields: Any
    factor: complex
    nodes: list
    top: float

    @property
    def kind(self) -> str:
        """What its displacements are measured with: those of the plane, of what slides or of what turns."""
        return "placed" if self.strip.placed else "turns" if self.strip.member.kind.torsional else "slides"

    def bend(self, rest: "Sketch", moved: "Sketch", factor: complex, unit: float, turn_unit: float) -> Bend:
        """The Bend about the position `rest`, the mode times the real part of `factor`."""
        strip, still, now = self.strip, resting(self.strip, rest.values), resting(self.strip, moved.values)
        bar = strip.placed and not strip.sideways

        def at(places):
            u = (self.fields.displacements(strip.name, places) * (self.factor * factor)).real.tolist()
            return [(along + part, there) if bar else (here, across + part)
                    for (along, across), (here, there), part in zip(still(places), now(places), u, strict=True)]

        scale = strip.scale if strip.placed else turn_unit if strip.member.kind.torsional else unit
        return Bend(at, scale, self.nodes)


def mode_along_members(problem: Any, mode: Any, stage: "Scenery", normalise: str, turn: complex) -> list[MemberMode]:
    """The MemberModes of a mode, `turn` being the factor of its shape."""
    if not stage.strips or not hasattr(mode, "motion"):
        return []
    told = problem.modal.told_apart(mode)
    fields, factor, found = problem.modal.fields(told), complex(problem.modal.scale(told, normalise)) * turn, []
    for strip in stage.strips:
        top = abs(complex(fields.largest(strip.name)[1]) * factor)
        nodes = [float(x) for x in fields.node_places(strip.name)] if top else []
        found.append(MemberMode(strip, fields, factor, nodes, top))
    most = {kind: max(one.top for one in found if one.kind == kind) for kind in {one.kind for one in found}}
    return [one if one.top > RESTS * most[one.kind] else one._replace(nodes=[], top=0.0) for one in found]
