"""Looks of bodies without a shape that slide: blocks, carts, wedges under others, knots."""

from collections.abc import Sequence
from math import pi
from typing import TYPE_CHECKING

from vibcli.drawing.canvas.primitives import JOINT, Polygon, Polyline
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols import footing
from vibcli.drawing.symbols.look import Look, ball

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.drawing.layout.ties import Ties
    from vibcli.elements.rigid_body import Body

BLOCK, FLAT, BAR = (36.0, 25.0), (22.0, 13.0), (26.0, 5.0)
ROTOR = 46.0, 30.0          # a block with room for its name beside an unbalance


def block(body: "Body", centre: tuple[float, float], sketch: "Sketch", ties: "Ties") -> Look:
    """A box along its direction of sliding; small where it has no mass, a ramp where others slide on it at an angle."""
    slide = body.record["slide"]
    direction = sketch.pair(slide["along"]) if "along" in slide else (1.0, 0.0)
    angle = plane.heading(direction)
    angle -= round(angle / (pi / 2)) * (pi / 2)
    slots = [slot for slot in ties.slots.get(body.name, ()) if min(map(abs, slot[1])) > 0.05]
    if slots:
        return _ramp(*slots[0], ties.carried.get(body.name, ()))
    room, massless = ties.nearest(centre, sketch), body.mass is None
    upright = abs(direction[1]) > abs(direction[0])
    if massless and upright:
        return _holder(body, centre, ties)
    width, height = (FLAT if massless else ROTOR if _turns_a_rotor(body, sketch) else
                     (30.0, BLOCK[1]) if upright else BLOCK)
    shrink = min(1.0, max(0.5, 1.3 * (room or width) / width))
    width, height = width * shrink, height * shrink
    hook = _hook(body, centre, sketch)
    middle = plane.plus(centre, (0.0, -1.0), hook + height / 2) if hook else centre
    corners = plane.box(middle, width, height, angle)
    beside = [x for x, y in ties.carried.get(body.name, ()) if abs(y - centre[1]) > height / 2]
    if not angle and not upright and beside:
        low, high = min(centre[0] - width / 2, min(beside) - 6), max(centre[0] + width / 2, max(beside) + 6)
        middle, width = ((low + high) / 2, middle[1]), high - low
    if not angle and not upright:
        among = footing.gaps(body.name, middle[1] - height / 2, sketch)
        width = max(width, 2 * (footing.stance(middle[0], width / 2, among) + footing.EDGE))
        corners = plane.box(middle, width, height)
    hanger = [Polyline((centre, plane.plus(centre, (0.0, -1.0), hook)), width=1.4, layer=JOINT)] if hook else []
    return Look([*hanger, Polygon(tuple(corners))], "block", corners, angle, width, height)


def _turns_a_rotor(body: "Body", sketch: "Sketch") -> bool:
    """Does an unbalance act on a body?"""
    return any("unbalance" in record and getattr(record.get("at"), "text", None) == body.name
               for record in (sketch.spec.get("forces") or {}).values())


def _holder(body: "Body", centre: tuple[float, float], ties: "Ties") -> Look:
    """What has no mass and slides upright: bars at the places that it carries, else a knot where others meet."""
    bars = [plane.box(place, *BAR, plane.heading(plane.minus(centre, place)) + pi / 2)
            for place in ties.carried.get(body.name, ()) if plane.distance(place, centre) > 1e-6]
    if bars and ties.slots.get(body.name):
        return Look([Polygon(tuple(bar), "driven") for bar in bars], "joint")
    return Look([ball(centre, 2.4)._replace(fill="ink")], "joint")


def _hook(body: "Body", centre: tuple[float, float], sketch: "Sketch") -> float:
    """How far below the axle of a wheel a body hangs that is drawn at the very axle; 0 of any other."""
    for name, other in sketch.scene.bodies.items():
        wheel = name in sketch.frames and name != body.name and other.rolling_radius is not None
        if wheel and plane.distance(sketch.rim(name).drawn, centre) < 1e-6:
            return sketch.rolling_radius(name) + 14.0
    return 0.0


def _ramp(place: tuple[float, float], direction: tuple[float, float], carried: Sequence[tuple[float, float]]) -> Look:
    """A wedge under a block that slides on it."""
    reach = [plane.dot(plane.minus(point, place), direction) for point in carried]
    low, high = min([*reach, -40.0]), max([*reach, 40.0])
    up = direction if direction[1] > 0 else plane.times(direction, -1)
    if up is not direction:
        low, high = -high, -low
    foot, head = plane.plus(place, up, low), plane.plus(place, up, high)
    drop = plane.times(plane.left(up) if up[0] > 0 else plane.times(plane.left(up), -1), -BLOCK[1] / 2)
    foot, head = plane.plus(foot, drop), plane.plus(head, drop)
    corners = [foot, (head[0], foot[1]), head]
    return Look([Polygon(tuple(corners))], "ramp")
