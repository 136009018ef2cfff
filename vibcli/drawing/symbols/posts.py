"""Posts: thin rods from a body to the places that it carries and that are not on it."""

from typing import TYPE_CHECKING

from vibcli.drawing.canvas.primitives import BEHIND, Polyline
from vibcli.drawing.layout import plane

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.drawing.layout.ties import Ties
    from vibcli.drawing.symbols.look import Look
    from vibcli.elements.rigid_body import Body

SLACK = 2.5     # points


def with_posts(look: "Look", body: "Body", sketch: "Sketch", ties: "Ties") -> "Look":
    """The Look with a thin post to each carried place that is not on the body."""
    centre, whole = sketch.centre(body.name), look
    for place in sorted(ties.carried.get(body.name, ()), key=lambda place: -plane.distance(place, centre)):
        if look.kind == "joint" or _touches(place, whole):
            continue
        root = _root(place, whole, centre)
        if not _along_element(root, place, ties, body.name):
            post = Polyline(_bent(root, place, look, centre), width=2.4, layer=BEHIND)
            whole = whole._replace(pieces=[post, *whole.pieces])
    return whole


def _touches(place: tuple[float, float], look: "Look") -> bool:
    """Is a place on a body as drawn?"""
    for part in look.pieces:
        points = list(part.points)
        if not isinstance(part, Polyline) and plane.inside(place, points):
            return True
        pairs = zip(points, points[1:] + ([] if isinstance(part, Polyline) else points[:1]), strict=False)
        if any(plane.distance(place, plane.nearest_on(place, a, b)) < SLACK for a, b in pairs):
            return True
    return False


def _root(place: tuple[float, float], look: "Look", centre: tuple[float, float]) -> tuple[float, float]:
    """Where a post to a place grows from a body: straight from its outline if it can."""
    best = centre
    for part in look.pieces:
        points = list(part.points)
        closing = [] if isinstance(part, Polyline) else points[:1]
        near = min((plane.nearest_on(place, a, b) for a, b in zip(points, points[1:] + closing, strict=False)),
                   key=lambda p: plane.distance(place, p))
        if plane.distance(place, near) < plane.distance(place, best):
            best = near
    return best


def _along_element(root: tuple[float, float], place: tuple[float, float], ties: "Ties", name: str) -> bool:
    """Does a spring or damper from this place run where the post would?"""
    for one, two in ties.ends:
        for a, b in ((one, two), (two, one)):
            if a.carrier == name and plane.distance(a.drawn, place) < 1e-6 and b.carrier != name:
                d, e = plane.unit(plane.minus(b.drawn, place)), plane.unit(plane.minus(root, place))
                if plane.dot(d, e) > 0.99:
                    return True
    return False


def _bent(root: tuple[float, float], place: tuple[float, float], look: "Look",
          centre: tuple[float, float]) -> tuple[tuple[float, float], ...]:
    """A post to a place beside a box: level from the box, then upright."""
    (x, y), (x0, y0) = place, root
    if look.kind in ("block", "platform") and min(abs(x - x0), abs(y - y0)) > 1.0 and not look.angle:
        return (centre[0], centre[1]), (x, centre[1]), place
    return root, place
