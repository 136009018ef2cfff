"""Bodies without a shape, drawn from the places that they carry: bars, slabs, frames; a cam below what it lifts, or as
a body of its own with a roller on it."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.drawing.canvas.primitives import Polygon
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols.look import Look, centre_mark

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.drawing.layout.ties import Ties
    from vibcli.elements.rigid_body import Body

Place = tuple[float, float]
BEYOND, THICK, LEAST, ROOM, CAM, LIFT, ROLLER = 22.0, 13.0, 26.0, 24.0, 15.0, 5.0, 9.0     # points


def straight(places: Sequence[Place]) -> bool:
    """Are all places on one line?"""
    ends = sorted(places)
    chord = plane.minus(ends[-1], ends[0])
    return all(abs(plane.across(plane.minus(p, ends[0]), chord)) < 1e-6 * (1 + plane.distance(ends[0], ends[-1])) ** 2
               for p in ends)


def bar(places: Sequence[Place], centre: Place) -> Look:
    """A bar over all places, which lie about a line."""
    ends = sorted(places)
    angle = plane.heading(plane.minus(ends[-1], ends[0]))
    turned = [plane.turned(place, -angle) for place in ends]
    left, bottom, right, top = plane.bounds(turned)
    middle = plane.turned(((left + right) / 2, (bottom + top) / 2), angle)
    corners = plane.box(middle, right - left + BEYOND, top - bottom + THICK, angle)
    return Look([Polygon(tuple(corners)), *centre_mark(centre)], "bar", corners)


def slab(places: Sequence[Place], centre: Place) -> Look:
    """A plate over all places, its sides level and upright."""
    left, bottom, right, top = plane.bounds(places)
    corners = plane.box(((left + right) / 2, (bottom + top) / 2), max(right - left, LEAST) + THICK,
                        max(top - bottom, LEAST - THICK) + THICK)
    return Look([Polygon(tuple(corners)), *centre_mark(centre)], "slab", corners)


def frame(body: "Body", places: Sequence[Place], ties: "Ties") -> Look:
    """A frame about what is in it, all places on it; wider where an element would run along its side."""
    (left, bottom), (right, top) = plane.corners(places)
    upright, level = _beside(body, ties, 0), _beside(body, ties, 1)
    left, right = _apart(left, right, upright)
    bottom, top = _apart(bottom, top, level)
    x, y = (left + right) / 2, (bottom + top) / 2
    outline = ((left, bottom), (x, bottom), (right, bottom), (right, y), (right, top), (x, top), (left, top), (left, y))
    return Look([Polygon(outline, None, width=3.0)], "frame")


def _beside(body: "Body", ties: "Ties", axis: int) -> list[float]:
    """The abscissas (axis 0) of upright elements that end on a body, or the ordinates (1) of level ones."""
    return [one.drawn[axis] for pair in ties.ends if body.name in (end.carrier for end in pair)
            for one, two in [pair] if abs(one.drawn[axis] - two.drawn[axis]) < 1e-6]


def _apart(low: float, high: float, lines: Sequence[float]) -> tuple[float, float]:
    """Two sides, moved away from each other where they meet or a line runs along one."""
    flat = high - low < 1.0
    return (low - (LEAST if flat else ROOM * any(abs(line - low) < 1e-6 for line in lines)),
            high + (LEAST if flat else ROOM * any(abs(line - high) < 1e-6 for line in lines)))


def encloses(body: "Body", places: Sequence[Place], sketch: "Sketch") -> bool:
    """Do the places that a body carries stand about the centre of another body?"""
    if straight(places):
        return False
    (left, bottom), (right, top) = plane.corners(places)
    others = [sketch.centre(name) for name in sketch.scene.bodies if name in sketch.frames and name != body.name]
    return any(left < x < right and bottom < y < top for x, y in others)


def cam(centre: Place, direction: Place) -> Look:
    """A disc that runs about a point beside its middle and lifts what slides along a direction."""
    middle = plane.plus(centre, direction, -CAM)
    return Look([Polygon(tuple(plane.circle(middle, CAM)))], "cam", angle=plane.heading(direction))


def follower(body: "Body", sketch: "Sketch") -> str | None:
    """The name of what rolls on a body that is a cam itself: the nearest one that slides from a place."""
    sliding = [name for name in sketch.frames if name in sketch.scene.bodies and name != body.name
               and "slide" in sketch.scene.bodies[name].record]
    centre = sketch.centre(body.name)
    return min(sliding, key=lambda name: plane.distance(sketch.centre(name), centre), default=None)


def follows(name: str, sketch: "Sketch") -> bool:
    """Does a body roll on a cam?"""
    return any(body.record.get("looks") == "cam" and "pin" in body.record and follower(body, sketch) == name
               for body in sketch.scene.bodies.values())


def _eccentric(body: "Body", centre: tuple[float, float], sketch: "Sketch") -> Look:
    """A disc about the mass centre of a cam, which reaches to the roller on it; without one about its pin."""
    name, pivot = follower(body, sketch), sketch.pivot(body.name)
    reach = plane.distance(centre, pivot.drawn) + LIFT if name is None else plane.distance(
        centre, sketch.centre(name)) - ROLLER
    disc = Polygon(tuple(plane.circle(centre, max(reach, LIFT))))
    return Look([disc, *centre_mark(centre)], "disc", list(disc.points))


def axle(look: Look) -> Place:
    """Where the point is, as drawn, about which a cam runs."""
    return plane.polar(plane.middle(*plane.corners(look.pieces[0].points)), -LIFT, look.angle)


def named(body: "Body", sketch: "Sketch", ties: "Ties") -> Look:
    """What the file says that a body looks like."""
    centre, word = sketch.centre(body.name), body.record["looks"]
    places = [*ties.carried.get(body.name, ()), centre]
    if word == "cam" and "pin" in body.record:
        return _eccentric(body, centre, sketch)
    if word == "cam":
        slide = body.record["slide"]
        return cam(centre, plane.unit(sketch.pair(slide["along"])) if "along" in slide else (1.0, 0.0))
    if word == "frame":
        return frame(body, places, ties)
    return slab(places, centre) if word == "slab" else bar(places, centre)
