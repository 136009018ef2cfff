"""Which look each placed body has: that of its shape, else of what it does."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.drawing.canvas.primitives import BODY, Polygon, Polyline, Primitive
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols import hulls
from vibcli.drawing.symbols.look import BALL, Look, ball, teeth
from vibcli.drawing.symbols.posts import with_posts

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.drawing.layout.ties import Ties
    from vibcli.drawing.symbols.shape import Outline
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Record

RIM, KNOT, JOINED = 8.0, 2.4, 4.0       # points; from a pin to what it lies on


def looks(sketch: "Sketch", ties: "Ties") -> dict[str, Look]:
    """{name: Look} of all bodies that have a place."""
    return {name: with_posts(look_of(body, sketch, ties), body, sketch, ties)
            for name, body in sketch.scene.bodies.items() if name in sketch.frames}


def look_of(body: "Body", sketch: "Sketch", ties: "Ties") -> Look:
    record, name = body.record, body.name
    if "parts" in record or record.get("shape", "particle") != "particle":
        return _shaped(record, sketch, ties)
    if "looks" in record:
        return hulls.named(body, sketch, ties)
    centre = sketch.centre(name)
    carried = {kind: surface for surface in reversed(ties.surfaces.get(name, ()))
               for kind in ("line", "curve", "circle") if kind in surface}
    if "line" in carried or "curve" in carried:
        from vibcli.drawing.symbols import on_surfaces

        return (on_surfaces.platform(body, sketch, carried["line"]) if "line" in carried else
                on_surfaces.bowl(carried["curve"], sketch))
    if "circle" in carried:
        rim = plane.circle(sketch.pair(carried["circle"]["circle"]), sketch.length(carried["circle"]["radius"]))
        return Look([Polygon(tuple(rim), None, width=2.2)], "hoop")
    if name in ties.rims:
        return _rim(sketch.rim(name).drawn, max(ties.radii[name]))
    if name in ties.radii:
        axle = sketch.rim(name).drawn
        return _wheel(axle, _radii(name, axle, ties), name in ties.toothed)
    if name in ties.fastened and body.mass is None:
        return Look([ball(centre, KNOT)._replace(fill="ink")], "joint")
    pivot = sketch.pivot(name)
    if pivot is not None:
        from vibcli.drawing.symbols.pinned import pinned

        return pinned(body, centre, pivot.drawn, sketch, ties)
    if "slide" in record and hulls.encloses(body, [*ties.carried.get(name, ()), centre], sketch):
        return hulls.frame(body, [*ties.carried[name], centre], ties)
    if hulls.follows(name, sketch):
        return Look([found := ball(centre, hulls.ROLLER)], "ball", found.points)
    return (_sliding(body, centre, sketch, ties) if "slide" in record else None) or _loose(body, centre, sketch, ties)


def _sliding(body: "Body", centre: tuple[float, float], sketch: "Sketch", ties: "Ties") -> Look | None:
    """A block, or a box on a straight surface; None on others."""
    if "surface" not in body.record["slide"]:
        from vibcli.drawing.symbols.sliding import block

        return block(body, centre, sketch, ties)
    surface = sketch.scene.surfaces[body.record["slide"]["surface"].text]
    if "line" not in surface:
        return None
    from vibcli.drawing.symbols.on_surfaces import resting

    return resting(centre, surface, sketch)


def _shaped(record: "Record", sketch: "Sketch", ties: "Ties") -> Look:
    from vibcli.drawing.symbols.shape import outline

    toothed = record.name in ties.toothed
    parts = [outline(part, sketch) for part in record.get("parts", (record,))]
    shapes = [part.get("shape", "particle") for part in record.get("parts", (record,))]
    order = sorted(zip(shapes, parts, strict=True), key=lambda pair: (pair[0] == "particle", pair[1].cut))
    pieces = [_piece(part) for _, part in order]        # small weights lie on all, holes on what they are cut from
    if toothed and parts[0].band:
        return _rim(sketch.rim(record.name).drawn, sketch.length(record["radius"]))
    if toothed:
        pieces = [piece._replace(points=tuple(teeth(piece.points))) for piece in pieces]
    if record.get("shape") == "disc":
        centre, whole = sketch.centre(record.name), sketch.length(record["radius"])
        pieces += [Polygon(tuple(plane.circle(centre, radius)), "inner")
                   for radius in ties.radii.get(record.name, ()) if radius < whole * (1 - 1e-6)]
    if record.get("shape") == "arch" and (pivot := sketch.pivot(record.name)) is not None:
        pieces += _spokes(pivot.drawn, parts[0].points)
    core = list(pieces[0].points) if record.get("shape") == "rectangle" else None
    return Look(pieces, record.get("shape", "parts"), core)


def _spokes(pivot: tuple[float, float], points: Sequence[tuple[float, float]]) -> list[Primitive]:
    """What joins the ends of an arch to a pin beside it."""
    if min(plane.distance(pivot, point) for point in points) < JOINED:
        return []
    return [Polyline((points[0], pivot, points[-1]), width=0.9, layer=BODY)]


def _piece(part: "Outline") -> Primitive:
    if not part.closed:
        return Polyline(tuple(part.points), width=3.0, layer=BODY)
    if part.band:
        return Polygon(tuple(part.points), None, width=2.6)
    return Polygon(tuple(part.points), "paper" if part.cut else "body")


def _radii(name: str, centre: tuple[float, float], ties: "Ties") -> list[float]:
    """The radii of a wheel, that at which it carries places included."""
    radii = sorted(ties.radii[name], reverse=True)
    far = [plane.distance(centre, place) for place in ties.carried.get(name, ())]
    if far and min(far) > radii[0] and max(far) - min(far) < 1e-6 * max(far):
        return [max(far), *radii]
    return radii


def _rim(centre: tuple[float, float], radius: float) -> Look:
    """A gear with inner teeth."""
    rim = plane.circle(centre, radius + RIM)
    return Look([Polygon(tuple(rim)), Polygon(tuple(teeth(plane.circle(centre, radius))), "paper")], "rim")


def _wheel(centre: tuple[float, float], radii: Sequence[float], toothed: bool) -> Look:
    rims = [Polygon(tuple(plane.circle(centre, radius)), "body" if i == 0 else "inner") for i, radius in
            enumerate(radii)]
    if toothed:
        rims[0] = rims[0]._replace(points=tuple(teeth(rims[0].points)))
    return Look(rims, "wheel")


def _loose(body: "Body", centre: tuple[float, float], sketch: "Sketch", ties: "Ties") -> Look:
    """A body that moves freely: a bar through the places that it carries, else a ball; as thick as the members that
    it joins where it is a corner of a frame, which has no mass."""
    carried = [place for place in ties.carried.get(body.name, ()) if plane.distance(place, centre) > 1e-6]
    turns = body.inertia is not None and {"inertia", "gyration"} & set(body.record)
    if (len(carried) > 1 or (carried and turns)) and hulls.straight([*carried, centre]):
        return hulls.bar([*carried, centre], centre)
    radius = 14.0 if turns else BALL + 2.5
    if all(node is None or node.is_zero for node in (body.mass, body.inertia)):
        from vibcli.drawing.layout.strips import THICK

        radius = THICK
    found = ball(centre, radius)
    return Look([found], "ball", found.points)
