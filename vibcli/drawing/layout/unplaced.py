"""What of a scene is laid out below what has a place: rows of bodies without one, members below one another, and what
ties these to each other."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import SURFACE, Polyline, Primitive, extent
from vibcli.drawing.layout import plane

if TYPE_CHECKING:
    from vibcli.drawing.layout.compose import Scenery
    from vibcli.drawing.layout.hung import Hung
    from vibcli.drawing.layout.lumped_place import Layout
    from vibcli.drawing.layout.rows import LumpedRow
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.drawing.layout.strips import Strip
    from vibcli.scene.scene import Scene

BELOW, CLEAR, STACKED = 40.0, 60.0, 20.0    # points to the first row, below a member, for each length above the first
ASIDE = 20.0        # points from the right end of the rows above to what one of them winds up


def laid_out(sketch: "Sketch", left: float, top: float) -> tuple[list[Any], list[Any], list[Any], list[Any]]:
    """The Hung of a scene, the Layouts of its rows, [(what turns, what it winds up)] and the Strips of its members,
    from the upper left corner on."""
    hung, rows, wound, strips = [], [], [], []
    if sketch.lumped:
        hung, rows, wound = _rows(sketch, left, top)
        top = min([top, *(layout.y - max(place.height for place in layout.places.values()) - BELOW for layout in rows)])
    sketch.numbers["standing"] = {name for layout in rows for name in layout.places}
    if sketch.scene.members:
        from vibcli.drawing.layout import strips as members

        strips = _apart(members.strips(sketch, left, top), sketch)
    return hung, rows, wound, strips


def _apart(strips: "Sequence[Strip]", sketch: "Sketch") -> "list[Strip]":
    """The same members, those without a place as far below one another as what hangs on them asks for."""
    from vibcli.drawing.layout.drawn_members import along

    made, low, sunk = [], None, 0.0
    for strip in sorted(strips, key=lambda strip: not strip.placed):
        if not strip.placed:
            x, y = strip.start
            sunk = max(sunk, 0.0 if low is None else y - low + CLEAR + STACKED * _stacked(strip))
            strip = strip._replace(start=(x, y - sunk))
        box = extent(along(strip, sketch))
        low = box[1] if low is None or not strip.placed else min(low, box[1])
        made.append(strip)
    return made


def _stacked(strip: "Strip") -> int:
    """How many lengths along a member stand above the first."""
    record, ends = strip.member.record, strip.metres * (1 - 1e-9)
    parts = [part for part in record.get("segments", (record,)) if "length" in part]
    return max(0, len(parts[:2]) + len({x for x in strip.places if 0.0 < x < ends} if "attached" in record else ()) - 2)


def _rows(sketch: "Sketch", left: float, top: float) -> "tuple[list[Hung], list[Layout], list[tuple[str, str]]]":
    """The Hung, the Layouts of rows, and what they wind up."""
    from vibcli.drawing.layout import gears, hung, lumped, rows

    every = rows.rows(sketch.scene)
    hanging = hung.find(every, sketch)
    elsewhere = {*_held_alone(sketch.scene), *(one.body for one in hanging)}
    found = lumped.layouts([row for row in every if not _only(row, elsewhere)], sketch, left, top)
    wound = gears.wound(sketch.scene) if found else []
    return hanging, [_aside(layout, found, wound) for layout in found], wound


def _aside(layout: "Layout", found: "Sequence[Layout]", wound: Sequence[tuple[str, str]]) -> "Layout":
    """A row between no walls, on the right of the rows above it where one of these winds it up: its rope then crosses
    no shaft."""
    above = [other for other in found if other.y > layout.y]
    drums = {drum for drum, load in wound if load in layout.places}
    if {layout.left, layout.right} != {None} or not any(drums & set(other.places) for other in above):
        return layout
    right = max(place.middle[0] + place.half for other in above for place in other.places.values())
    dx = right + ASIDE - min(place.middle[0] - place.half for place in layout.places.values())
    return layout._replace(places={name: place._replace(middle=plane.plus(place.middle, (dx, 0.0)))
                                   for name, place in layout.places.items()})


def _held_alone(scene: "Scene") -> set[str]:
    """The bodies without a place to which members are held: they are drawn there."""
    if not scene.members:
        return set()
    from vibcli.drawing.symbols.member_ends import held

    return {name for one in scene.members.values() if one is not None and one.line is None
            for side in ("left", "right") for _, name in held(one, side)}


def _only(row: "LumpedRow", held: set[str]) -> bool:
    return len(row.bodies) == 1 and row.bodies[0] in held and not row.gaps and not row.lanes


def draw(stage: "Scenery", sketch: "Sketch", unit: float,
         bends: Mapping[str, Any]) -> tuple[list[Any], dict[str, tuple[Any, ...]]]:
    """The primitives of rows and members, and where their elements are."""
    found, where = [], {}
    if stage.rows:
        from vibcli.drawing.layout import lumped

        for layout in stage.rows:
            moved = {name: sketch.lumped[name] * (1.0 if place.turns else unit)
                     for name, place in layout.places.items()}
            lines, places = lumped.draw(layout, moved, lambda record: sketch.gap(record, unit))
            found += lines
            where |= places
    if stage.strips:
        from vibcli.drawing.layout import drawn_members

        found += drawn_members.draw(stage, sketch, unit, bends)
    return found + _ropes(stage, sketch, unit), where


def _ropes(stage: "Scenery", sketch: "Sketch", unit: float) -> list[Primitive]:
    """Dashed lines between rows of which one winds the other up."""
    places = {name: place for layout in stage.rows for name, place in layout.places.items()}
    found: list[Primitive] = []
    for drum, load in stage.wound:
        above, below = places[drum], places[load]
        head = below.middle[0] + sketch.lumped[load] * unit, below.middle[1] + below.height
        side = -above.half if head[0] < above.middle[0] else above.half
        start = plane.plus(above.middle, (side, -0.5 * above.height))
        found.append(Polyline((start, head), "rope", 1.2, True, SURFACE))
    return found
