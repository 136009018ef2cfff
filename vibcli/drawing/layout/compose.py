"""A scene as a drawing: everything that has a place, in one position."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.drawing.canvas.primitives import BODY, SURFACE, Circle, Polyline, extent
from vibcli.drawing.layout import gears, hung, lumped, plane, rows
from vibcli.drawing.layout.positions import values_at
from vibcli.drawing.layout.scale import scale_of
from vibcli.drawing.layout.sketch import Sketch
from vibcli.drawing.layout.strips import resting, strips
from vibcli.drawing.layout.ties import Ties
from vibcli.drawing.symbols import bodies, connection, joint, member, member_ends, rope, support, tracks
from vibcli.drawing.symbols.appearance import looks

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene

BELOW, CLEAR, MOST = 40.0, 60.0, 80     # points to the first row of lumped bodies, below a member; bodies
FINE = 1e9                  # points per metre at which what has a size on paper alone has none


class Scenery:
    """What of a drawing does not depend on the position: its scale, the looks of its bodies, its ends and walls."""

    def __init__(self, scene: "Scene"):
        if len(scene.bodies) > MOST:
            raise PhysicsError(f"a drawing of {len(scene.bodies)} bodies is not legible", f"the limit is {MOST}")
        self.scene = scene
        plain = Sketch(scene, values_at(scene), FINE)
        self.sketch = Sketch(scene, plain.values, scale_of(plain) * FINE)
        self.sketch.numbers["size"] = plain.numbers["size"] / FINE
        self.ties = Ties(self.sketch)
        self.looks = looks(self.sketch, self.ties)
        self.bunches = connection.bunches(self.sketch, self.looks)
        self.ropes = {name: rope.stops(record, self.sketch, self.looks)
                      for name, record in (scene.spec.get("constraints") or {}).items() if "rope" in record}
        for number, found in enumerate(self.ties.implied):
            self.ropes[f"implied {number}"] = rope.implied(found, self.sketch, self.looks)
        for found in self.ties.standing:
            self.ropes[f"standing {found.wheel}"] = rope.standing(found, self.sketch)
        for cord in self.ties.cords:
            self.ropes[cord.end.carrier] = rope.wound(cord, self.sketch)
            self.bunches.append(connection.Bunch([cord.record], cord.wall, cord.end))
        box = extent(primitives(self, self.sketch)[0])
        left, top = (box[0], box[1] - BELOW) if box else (0.0, 0.0)
        every = rows.rows(scene)
        self.hung = hung.find(every, self.sketch)
        elsewhere = {*_held_alone(scene), *(one.body for one in self.hung)}
        self.rows = lumped.layouts([row for row in every if not _only(row, elsewhere)], self.sketch, left, top)
        self.wound = gears.wound(scene) if self.rows else []
        self.sketch.numbers["standing"] = {name for layout in self.rows for name in layout.places}
        if self.rows:
            top = min(layout.y - max(place.height for place in layout.places.values()) for layout in self.rows) - BELOW
        self.strips = _apart(strips(self.sketch, left, top), self.sketch)

    def at(self, position: Mapping[str, float] | None = None, time: float = 0.0) -> Sketch:
        """The Sketch in another position; None where its loops cannot follow."""
        values = values_at(self.scene, position, time)
        return None if values is None else self.sketch.at(values)


def figure(stage: Scenery, sketch: Any, unit: Any = 1.0,
           room: Any = None,
           bends: Any = None) -> tuple[list[Any], dict[str, tuple[Any, ...]]]:
    """Everything of a scene but its words and arrows, and where its elements are, as {name: (middle, normal)};
    lumped bodies are displaced by `unit` points for one metre; `room`: that in which bodies slide on the ground;
    `bends`: {member: Bend} of members in motion."""
    found, where = primitives(stage, sketch, room)
    for layout in stage.rows:
        moved = {name: sketch.lumped[name] * (1.0 if place.turns else unit) for name, place in layout.places.items()}
        lines, places = lumped.draw(layout, moved)
        found += lines
        where |= places
    for strip in stage.strips:
        found += along(strip, sketch, unit, (bends or {}).get(strip.name))
    found += member_ends.branches(stage.strips, sketch)
    return found + _tied(stage, sketch, unit, bends or {}), where


def _tied(stage, sketch, unit, bends):
    """Dashed lines for what joins lumped bodies to members without a place: to points on them, or to their ends; and to
    each other where one winds the other up."""
    points = sketch.spec.get("member_points") or {}
    strips = {strip.name: strip for strip in stage.strips if not strip.placed}
    places = {name: (place, layout.y - place.height) for layout in stage.rows for name, place in layout.places.items()}

    def tie(strip, x, name):
        place, foot = places[name]
        on_strip = member.place(strip, bends.get(strip.name) or _still(strip, sketch, unit), x)
        moved = 0.0 if place.turns else sketch.lumped[name] * unit
        return Polyline(((place.middle[0] + moved, foot), on_strip), "measure", 0.8, True, SURFACE)

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
    for drum, load in stage.wound:
        above, below = places[drum][0], places[load][0]
        head = below.middle[0] + sketch.lumped[load] * unit, below.middle[1] + below.height
        side = -above.half if head[0] < above.middle[0] else above.half
        start = plane.plus(above.middle, (side, -0.5 * above.height))
        found.append(Polyline((start, head), "rope", 1.2, True, SURFACE))
    return found


def _still(strip, sketch, unit):
    """A member as its stations are."""
    return member.Bend(resting(strip, sketch.values), strip.scale if strip.placed else unit)


def along(strip: Any, sketch: Any, unit: Any = 1.0, bend: Any = None) -> list[Any]:
    """A member with its ends and what is attached; without a Bend as its stations are."""
    if bend is None:
        bend = _still(strip, sketch, unit)
    return member.bed(strip) + member.draw(strip, bend) + member_ends.draw(strip, bend, sketch)[0]


def _apart(found, sketch):
    """The same members, those without a place as far below one another as what hangs on them asks for."""
    made, low, sunk = [], None, 0.0
    for strip in sorted(found, key=lambda strip: not strip.placed):
        if not strip.placed:
            x, y = strip.start
            sunk = max(sunk, 0.0 if low is None else y - low + CLEAR)
            strip = strip._replace(start=(x, y - sunk))
        box = extent(along(strip, sketch))
        low = box[1] if low is None or not strip.placed else min(low, box[1])
        made.append(strip)
    return made


def _held_alone(scene):
    """The bodies without a place to which members are held: they are drawn there."""
    return {name for one in scene.members.values() if one is not None and one.line is None
            for side in ("left", "right") for _, name in member_ends.held(one, side)}


def _only(row, held):
    return len(row.bodies) == 1 and row.bodies[0] in held and not row.gaps and not row.lanes


def primitives(stage: Scenery, sketch: Any,
               room: Any = None) -> tuple[list[Any], dict[str, tuple[Any, ...]]]:
    """What has a place, without words and arrows."""
    looks, ties = stage.looks, stage.ties
    found = _surfaces(sketch, looks)
    found += bodies.draw(sketch, looks, room or {})
    where = {}
    for bunch in stage.bunches:
        lines, places = connection.draw(bunch, sketch)
        found += lines
        where |= places
    found += _pegs(sketch, ties)
    for chain in stage.ropes.values():
        found += rope.draw(chain, sketch)
    for end in ties.hinges:
        found += support.hinge(sketch.now(end))
    found += _constraints(sketch)
    found += connection.walls(_fixed_ends(stage, sketch), sketch)
    lines, places = joint.draw(sketch, looks)
    return found + lines, where | places


def _surfaces(sketch, looks):
    found = []
    for name, record in (sketch.spec.get("surfaces") or {}).items():
        if "body" in record and not sketch.is_fixed(record["body"].text):
            continue
        found += tracks.ground(record, tracks.contacts(name, sketch), sketch)
    return found


def _pegs(sketch, ties):
    """Pulleys without a body: a smooth peg, or a wheel in a bearing."""
    found = []
    for at, radius in ties.pegs:
        place = sketch.now(at)
        if not radius:
            found += support.peg(place)
        else:
            found += [Circle(place, radius, "body", layer=BODY), *support.bearing(place, (0.0, -1.0))]
    return found


def _constraints(sketch):
    """Links, belts, and pins where points are joined."""
    found = []
    for record in (sketch.spec.get("constraints") or {}).values():
        ends = [sketch.attachment(end) for end in record.get("link", record.get("join", ()))]
        places = [sketch.now(end) for end in ends]
        if "link" in record:
            found += [Polyline(tuple(places), width=2.4), *(part for place in places for part in support.hinge(place))]
        elif places:
            found += support.hinge(places[0])
        elif "belt" in record:
            found += rope.belt(record, sketch)
    return found


def _fixed_ends(stage, sketch):
    """[(Attachment, direction into the ground)] of what ends on the ground or on a driven support."""
    ends = [(a, plane.unit(plane.minus(a.drawn, b.drawn))) for bunch in stage.bunches
            for a, b in ((bunch.one, bunch.two), (bunch.two, bunch.one))]
    for chain in stage.ropes.values():
        for stop, other in ((chain[0], chain[1]), (chain[-1], chain[-2])):
            if not stop.sense:
                free = rope.draw([stop, other], stage.sketch)[0].points
                ends.append((stop.at, plane.unit(plane.minus(free[0], free[1]))))
    for record in (sketch.spec.get("constraints") or {}).values():
        if "link" in record:
            a, b = (sketch.attachment(end) for end in record["link"])
            ends += [(a, plane.unit(plane.minus(a.drawn, b.drawn))), (b, plane.unit(plane.minus(b.drawn, a.drawn)))]
    bearings = bodies.fixed_pivots(stage.sketch)
    return [(end, out) for end, out in ends if (sketch.is_fixed(end.carrier) or end.carrier in sketch.moving_points)
             and (round(end.drawn[0], 3), round(end.drawn[1], 3)) not in bearings]
