"""Looks of bodies without a shape on surfaces, or which carry one: boxes, carts with a deck or a bowl, wedges."""

from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import Polygon
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols.look import Look
from vibcli.drawing.symbols.sliding import BAR, BLOCK
from vibcli.drawing.symbols.tracks import MARGIN, contacts, curve_points, free_side, straight, sunk

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.language.reader import Record

FLAT_ENOUGH = 0.05      # sine of what is level
DECK, DEEP = 19.0, 70.0


def resting(place: tuple[float, float], surface: "Record", sketch: "Sketch") -> Look:
    """A box on a straight surface, on the side where the ground is not, about its place where it can be."""
    a, b = (sketch.pair(end) for end in surface["line"])
    e = plane.times(plane.unit(plane.minus(b, a)), free_side(a, b, contacts(surface.name, sketch)))
    middle = plane.plus(place, plane.left(e), BLOCK[1] / 2 - sunk(surface.name, sketch))
    corners = plane.box(middle, *BLOCK, plane.heading(e))
    return Look([Polygon(tuple(corners))], "box", corners)


def platform(body: Any, sketch: Any, surface: Any) -> Look:
    """A plank under the surface that it carries, away from what is on it, with room for what rolls there; so thick that
    it holds its centre. A wedge where it slides on level ground and the surface leans."""
    used = contacts(surface.name, sketch)
    a, b = straight(surface, used, sketch)
    side = free_side(a, b, used)
    if side < 0:
        a, b = b, a
    e = plane.unit(plane.minus(b, a))
    down = plane.times(plane.left(e), -1)
    offset = plane.minus(sketch.centre(body.name), a)
    depth, s = plane.dot(offset, down), plane.dot(offset, e)
    thick = max(DECK, depth + 8) if depth < DEEP else DECK
    on = [(plane.dot(plane.minus(place, a), e), room) for place, room in used if (room or 0.0) > MARGIN]     # it rolls
    ends = min([0.0, s - DECK, *(x - room for x, room in on)]), max([plane.distance(a, b), s + DECK,
                                                                     *(x + room for x, room in on)])
    a, b = (plane.plus(a, e, end) for end in ends)
    along = body.record["slide"].get("along") if "slide" in body.record else None
    level = "slide" in body.record and (along is None or abs(sketch.pair(along)[1]) < FLAT_ENOUGH)
    if level and down[1] < 0 and FLAT_ENOUGH < abs(e[1]) < 1 - FLAT_ENOUGH:
        low = min(a[1], b[1]) - BAR[1]
        corners = [a, b, (b[0], low), (a[0], low)]
        return Look([Polygon(tuple(corners))], "ramp", corners)
    corners = [a, b, plane.plus(b, down, thick), plane.plus(a, down, thick)]
    return Look([Polygon(tuple(corners))], "platform", corners, plane.heading(e), plane.distance(a, b), thick)


def bowl(surface: "Record", sketch: "Sketch") -> Look:
    points = curve_points(surface, sketch)
    bottom = min(y for _, y in points) - DECK
    corners = [*points, (points[-1][0], bottom), (points[0][0], bottom)]
    width = points[-1][0] - points[0][0]
    return Look([Polygon(tuple(corners))], "platform", corners, 0.0, width, DECK)
