"""A scene as a drawing: everything that has a place, in one position."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.drawing.canvas.primitives import BODY, Circle, Polyline, Primitive, extent
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.positions import values_at
from vibcli.drawing.layout.scale import scale_of
from vibcli.drawing.layout.sketch import Sketch
from vibcli.drawing.layout.ties import Ties
from vibcli.drawing.symbols import bodies, connection, joint, support
from vibcli.drawing.symbols.appearance import looks

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Attachment
    from vibcli.drawing.symbols.look import Look
    from vibcli.scene.scene import Scene

BELOW, MOST = 40.0, 80      # points to the first row of bodies without a place; bodies
FINE = 1e9                  # points per metre at which what has a size on paper alone has none


class Scenery:
    """What of a drawing does not depend on the position: its scale, `share` times what its places call for, the looks
    of its bodies, its ends and walls."""

    def __init__(self, scene: "Scene", share: float = 1.0) -> None:
        if len(scene.bodies) > MOST:
            raise PhysicsError(f"a drawing of {len(scene.bodies)} bodies is not legible", f"the limit is {MOST}")
        self.scene = scene
        plain = Sketch(scene, values_at(scene), FINE)
        self.sketch = Sketch(scene, plain.values, share * scale_of(plain) * FINE)
        self.sketch.numbers["size"] = plain.numbers["size"] / FINE
        self.ties = Ties(self.sketch)
        self.looks = looks(self.sketch, self.ties)
        self.bunches = connection.bunches(self.sketch, self.looks)
        self.bunches += [connection.Bunch([cord.record], cord.wall, cord.end) for cord in self.ties.cords]
        self.ropes = {}
        if self.ties.roped:
            from vibcli.drawing.symbols import rope

            self.ropes = rope.ropes(self.sketch, self.looks, self.ties)
        self.hung, self.rows, self.wound, self.strips = [], [], [], []
        if self.sketch.lumped or scene.members:
            from vibcli.drawing.layout import unplaced

            box = extent(primitives(self, self.sketch)[0])
            left, top = (box[0], box[1] - BELOW) if box else (0.0, 0.0)
            self.hung, self.rows, self.wound, self.strips = unplaced.laid_out(self.sketch, left, top)

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
    if stage.rows or stage.strips:
        from vibcli.drawing.layout import unplaced

        lines, places = unplaced.draw(stage, sketch, unit, bends or {})
        found += lines
        where |= places
    return found, where


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
    if stage.ropes:
        from vibcli.drawing.symbols import rope

        for chain in stage.ropes.values():
            found += [*rope.draw(chain, sketch), *rope.held(chain, sketch)]
    for end in ties.hinges:
        found += support.hinge(sketch.now(end))
    found += _constraints(sketch)
    if any("move" in body.record for body in stage.scene.bodies.values()):
        from vibcli.drawing.symbols import guides

        found += guides.draw(sketch)
    found += connection.walls(_fixed_ends(stage, sketch), sketch)
    lines, places = joint.draw(sketch, looks)
    return found + lines, where | places


def _surfaces(sketch: Sketch, looks: "Mapping[str, Look]") -> list[Any]:
    found = []
    for name, record in (sketch.spec.get("surfaces") or {}).items():
        if "body" in record and not sketch.is_fixed(record["body"].text):
            continue
        from vibcli.drawing.symbols import tracks

        found += tracks.ground(record, tracks.contacts(name, sketch), sketch)
    return found


def _pegs(sketch: Sketch, ties: Ties) -> list[Primitive]:
    """Pulleys without a body: a smooth peg, or a wheel in a bearing."""
    found = []
    for at, radius in ties.pegs:
        place = sketch.now(at)
        if not radius:
            found += support.peg(place)
        else:
            found += [Circle(place, radius, "body", layer=BODY), *support.bearing(place, (0.0, -1.0))]
    return found


def _constraints(sketch: Sketch) -> list[Primitive]:
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
            from vibcli.drawing.symbols import rope

            found += rope.belt(record, sketch)
    return found


def _fixed_ends(stage: Scenery, sketch: Sketch) -> "list[tuple[Attachment, tuple[float, float]]]":
    """[(Attachment, direction into the ground)] of what ends on the ground or on a driven support."""
    ends = [(a, plane.unit(plane.minus(a.drawn, b.drawn))) for bunch in stage.bunches
            for a, b in ((bunch.one, bunch.two), (bunch.two, bunch.one))]
    if stage.ropes:
        from vibcli.drawing.symbols.rope import ends as ends_of_ropes

        ends += ends_of_ropes(stage.ropes, stage.sketch)
    for record in (sketch.spec.get("constraints") or {}).values():
        if "link" in record:
            a, b = (sketch.attachment(end) for end in record["link"])
            ends += [(a, plane.unit(plane.minus(a.drawn, b.drawn))), (b, plane.unit(plane.minus(b.drawn, a.drawn)))]
    bearings = bodies.fixed_pivots(stage.sketch)
    return [(end, out) for end, out in ends if (sketch.is_fixed(end.carrier) or end.carrier in sketch.moving_points)
             and (round(end.drawn[0], 3), round(end.drawn[1], 3)) not in bearings]
