"""Members as drawn, with what is attached to them, and what ties those without a place to lumped bodies."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import SURFACE, Polyline
from vibcli.drawing.layout.strips import resting
from vibcli.drawing.symbols import member, member_ends

if TYPE_CHECKING:
    from vibcli.drawing.layout.compose import Scenery
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.drawing.layout.strips import Strip
    from vibcli.drawing.symbols.member import Bend


def draw(stage: "Scenery", sketch: "Sketch", unit: float, bends: "Mapping[str, member.Bend]") -> list[Any]:
    """The members of a scene, dashed lines from those without a place to what holds them and to the lumped bodies that
    elements join to them; those in motion as their Bends say."""
    found: list[Any] = []
    for strip in stage.strips:
        found += along(strip, sketch, unit, bends.get(strip.name))

    def place(strip: "Strip", x: float) -> tuple[float, float]:
        return member.place(strip, bends.get(strip.name) or _still(strip, sketch, unit), x)

    return found + member_ends.branches(stage.strips, sketch, place) + _tied(stage, sketch, unit, place)


def along(strip: "Strip", sketch: "Sketch", unit: float = 1.0, bend: "member.Bend | None" = None) -> list[Any]:
    """A member with its ends and what is attached; without a Bend as its stations are."""
    if bend is None:
        bend = _still(strip, sketch, unit)
    attached = member_ends.draw(strip, bend, sketch)[0]
    return member.bed(strip, bend, attached) + member.draw(strip, bend) + attached


def _still(strip: "Strip", sketch: "Sketch", unit: float) -> "Bend":
    """A member as its stations are."""
    return member.Bend(resting(strip, sketch.values), strip.scale if strip.placed else unit)


def _tied(stage: "Scenery", sketch: "Sketch", unit: float,
          on_member: "Callable[[Strip, float], tuple[float, float]]") -> list[Any]:
    """Dashed lines for what joins lumped bodies to members without a place: to points on them, or to their ends."""
    points = sketch.spec.get("member_points") or {}
    strips = {strip.name: strip for strip in stage.strips if not strip.placed}
    places = {name: (place, layout.y - place.height) for layout in stage.rows for name, place in layout.places.items()}

    def tie(strip: "Strip", x: float, name: str) -> Polyline:
        place, foot = places[name]
        moved = 0.0 if place.turns else sketch.lumped[name] * unit
        return Polyline(((place.middle[0] + moved, foot), on_member(strip, x)), "measure", 0.8, True, SURFACE)

    found = []
    for record in sketch.spec.connections:
        names = [getattr(end, "text", None) for end in record.get("between", ())]
        ends = [name for name in names if name in points and points[name]["body"].text in strips]
        bodies = [name for name in names if name in places]
        if len(ends) == len(bodies) == 1:
            strip = strips[points[ends[0]]["body"].text]
            found.append(tie(strip, sketch.number(points[ends[0]]["at"]), bodies[0]))
    for strip in strips.values():
        for side, x in (("left", 0.0), ("right", strip.metres)):
            found += [tie(strip, x, name) for _, name in member_ends.held(strip.member, side) if name in places]
    return found
