"""Bodies in a position: their outlines carried along, their pins and bearings, the floors that they slide on."""

from collections.abc import Mapping, Sequence
from math import pi
from typing import TYPE_CHECKING, Any, cast

from vibcli.drawing.canvas.primitives import BEHIND, BODY, Circle, Hatch, Polyline, Primitive
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols import footing, hulls, joint, support
from vibcli.drawing.symbols.connection import snapped

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import DrawnFrame, Sketch
    from vibcli.drawing.symbols.look import Look

RAIL, WOUND, OPEN, NARROW = 17.0, 18.0, 8.5, 4.5
BOXES, LEVEL = ("block", "platform", "ramp"), 1e-6


def draw(sketch: "Sketch", looks: "Mapping[str, Look]", room: Mapping[str, tuple[float, float]]) -> list[Any]:
    """All bodies with their pins and floors, large ones first; `room`: {body: (points back, points on) it slides}."""
    found = []
    for name, look in sorted(looks.items(), key=lambda item: -item[1].area()):
        found += [carried(part, sketch.frames[name]) for part in look.pieces]
        found += _rail(name, sketch, room)
        found += _floor(name, look, sketch, room.get(name, (0.0, 0.0)))
    return found + _pins(sketch, looks) + _clamps(sketch, looks)


def carried(part: Primitive, frame: "DrawnFrame") -> Primitive:
    """A primitive as drawn, moved with a frame."""
    if isinstance(part, Circle):
        return part._replace(centre=frame.point(part.centre))
    return part._replace(points=tuple(frame.point(point) for point in part.points))


def marks(sketch: "Sketch", looks: "Mapping[str, Look]") -> list[Any]:
    """A radius on each round body, which shows how far it has turned."""
    found = []
    for name, look in looks.items():
        if look.kind in ("disc", "ring", "wheel", "hub", "rim"):
            low, high = plane.corners(look.pieces[-1].points)
            centre, radius = plane.middle(low, high), (high[0] - low[0]) / 2
            spoke = Polyline((centre, plane.polar(centre, radius, pi / 2)), layer=BODY)
            found.append(carried(spoke, sketch.frames[name]))
    return found


def rail_of(name: str, sketch: "Sketch") -> str | None:
    """What turns about a pin and carries a body along a straight rod, which is as long as it takes; None of others."""
    slide = sketch.scene.bodies[name].record.get("slide", {})
    carrier = slide["carrier"].text if "carrier" in slide and "surface" not in slide else None
    record = sketch.scene.bodies[carrier].record if carrier in sketch.scene.bodies else {}
    return cast("str | None", carrier if "pin" in record and not {"shape", "parts"} & set(record) else None)


def along(name: str, sketch: "Sketch") -> tuple[float, float]:
    """The direction in which a body slides, as drawn."""
    slide = sketch.scene.bodies[name].record["slide"]
    return plane.unit(sketch.pair(slide["along"])) if "along" in slide else (1.0, 0.0)


def _rail(name: str, sketch: "Sketch", room: Mapping[str, tuple[float, float]]) -> list[Any]:
    """The rod under a body that slides along it, as far as it goes in a motion."""
    if name not in room or name not in sketch.scene.bodies or (carrier := rail_of(name, sketch)) is None:
        return []
    from vibcli.drawing.symbols.pinned import BEYOND

    start, e, (back, on) = sketch.centre(name), along(name, sketch), room[name]
    rod = Polyline((plane.plus(start, e, back), plane.plus(start, e, on + BEYOND)), width=2.4, layer=BEHIND)
    return [carried(rod, sketch.frames[carrier])]


def _pins(sketch: "Sketch", looks: "Mapping[str, Look]") -> list[Primitive]:
    """A hinge at every pin; a bearing where it is on the ground, higher where a spiral spring winds about it."""
    found, grounded = [], {}
    wound = {_rounded(at.drawn) for record, at, _, other in joint.elements(sketch)
             if record.element.name == "spring" and not other}
    for name, pivot in sketch.pivots().items():
        if sketch.is_fixed(pivot.carrier):
            points = [point for part in looks[name].pieces for point in part.points]
            grounded.setdefault(_rounded(pivot.drawn), (pivot, []))[1].extend(points)
        else:
            found += support.hinge(sketch.now(pivot))
    for key, (pivot, points) in grounded.items():
        height = WOUND if key in wound else support.HEIGHT
        found += support.bearing(sketch.now(pivot), down_of(pivot.drawn, points), height)
    return found


def _clamps(sketch: "Sketch", looks: "Mapping[str, Look]") -> list[Any]:
    """A wall where a body is clamped to the ground, upright or level, away from its mass centre."""
    found = []
    for name in looks:
        clamp = sketch.scene.bodies[name].record.get("clamp")
        at = None if clamp is None or "carrier" in clamp else sketch.attachment(clamp["at"])
        if at is not None and sketch.is_fixed(at.carrier):
            x, y = plane.minus(at.drawn, sketch.centre(name))
            outward = (x / abs(x), 0.0) if x and abs(x) >= abs(y) else (0.0, 1.0 if y > 0 else -1.0)
            found += support.wall(sketch.now(at), outward)
    return found


def _rounded(place: tuple[float, float]) -> tuple[float, float]:
    return round(place[0], 3), round(place[1], 3)


def down_of(place: tuple[float, float], points: Sequence[tuple[float, float]]) -> tuple[float, float]:
    """The direction of the ground from a bearing: that in which its bodies reach least; below, if it can be."""
    def reach(direction: "tuple[float, float]") -> float:
        return max(plane.dot(plane.minus(point, place), direction) for point in points)

    return min(((0.0, -1.0), (0.0, 1.0), (-1.0, 0.0), (1.0, 0.0)),
               key=lambda direction: round(reach(direction)) + 5 * abs(direction[0]) + (direction[1] > 0))


def fixed_pivots(sketch: "Sketch") -> set[tuple[float, float]]:
    """Rounded places of all bearings."""
    return {_rounded(pivot.drawn) for pivot in sketch.pivots().values() if sketch.is_fixed(pivot.carrier)}


def _floor(name: str, look: "Look", sketch: "Sketch", room: tuple[float, float]) -> list[Primitive]:
    """The ground, and rollers, under a box that slides on it; guides beside one that slides upright."""
    if look.kind == "cam":
        return support.bearing(hulls.axle(look), (0.0, -1.0))
    slide = sketch.scene.bodies[name].record.get("slide")
    if slide is None or look.kind not in (*BOXES, "rectangle") or "surface" in slide:
        return []
    if "carrier" in slide and not sketch.is_fixed(slide["carrier"].text):
        return []
    e = snapped(along(name, sketch))
    frame = sketch.frames[name]
    left, bottom, right, top = plane.bounds([p for part in look.outlines for p in part.points])
    if abs(e[1]) > 0.95:
        return _guides(name, (left, bottom, right, top), sketch) if look.kind == "block" else []
    e, level = e if e[0] > 0 else plane.times(e, -1), abs(e[0]) == 1
    if look.kind == "rectangle" and not (level and _lies_flat(look)):
        return []
    turned = level and look.kind == "platform" and abs(look.angle) > 3
    if turned:      # what is on it is below
        e, bottom, room = plane.times(e, -1), top, room[::-1]
    down = plane.times(plane.left(e), -1)
    if level:
        under = ((left + right) / 2, bottom)
        half, wheels = (right - left) / 2, 2 * support.ROLLER
        among = [] if turned else footing.gaps(name, bottom, sketch)
        beside = footing.stance(under[0], half, among)
        spots = [plane.plus(under, e, side * beside) for side in (-1, 1)] if beside > 2.0 else [under]
        found = [part for spot in spots for part in support.roller(frame.point(plane.plus(spot, down, support.ROLLER)))]
    else:
        middle = sketch.centre(name)
        under, half, wheels, found, among = plane.plus(middle, down, look.height / 2), look.width / 2, 0.0, [], []
    back, on = half + RAIL - room[0], half + RAIL + room[1]
    floor = plane.plus(under, down, wheels)
    if _hangs(name, sketch):
        among.append((under[0] - half + OPEN, under[0] + half - OPEN))
    if among and room == (0.0, 0.0):
        pieces = footing.floors(under[0] - back + NARROW, under[0] + on - NARROW, among)
        return [*found, *(part for low, high in pieces
                          for part in support.floor(((low + high) / 2, floor[1]), e, (high - low) / 2))]
    return [*found, *support.floor(plane.plus(floor, e, (on - back) / 2), e, (on + back) / 2)]


def _lies_flat(look: "Look") -> bool:
    """Is a side of a rectangle level?"""
    low, high = plane.corners(look.core)
    return plane.area(list(look.core)) > (1 - LEVEL) * (high[0] - low[0]) * (high[1] - low[1])


def _hangs(name: str, sketch: "Sketch") -> bool:
    """Does anything hang from the pin of this body?"""
    _, y0 = sketch.centre(name)
    return any(pivot.carrier == name and sketch.centre(other)[1] < y0 - 1e-6
               for other, pivot in sketch.pivots().items())


def _guides(name: str, box: tuple[float, float, float, float], sketch: "Sketch") -> list[Any]:
    """Walls on either side of a body that slides upright and is pinned to others."""
    joined = any(pivot.carrier == name for pivot in sketch.pivots().values())
    for record in (sketch.spec.get("constraints") or {}).values():
        joined |= any(getattr(end, "text", None) == name for key in ("join", "link") for end in record.get(key, ()))
    if not joined:
        return []
    left, bottom, right, top = box
    low, high = bottom - 8, top + 8
    return [Hatch(((left - 2, low), (left - 2, high)), 1), Hatch(((right + 2, low), (right + 2, high)), -1)]
