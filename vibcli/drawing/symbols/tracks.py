"""Fixed surfaces: the ground under what rolls or slides on lines, circles and curves."""

from collections.abc import Callable, Sequence
from math import isfinite, pi, tau
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import SURFACE, Circle, Hatch, Primitive
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols import support
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.language.reader import Record, Reference

SPREAD, MARGIN, FAR, SMALL = 0.35 * pi, 22.0, 120.0, 16.0  # of a circle beside what is inside it; beyond what rolls
SAMPLES, STEEP, SUNK = 48, 0.6, 12.5        # half the height of a block
FLAT = 0.36         # the sine of the angle by which a rod that lies on a surface leans from it
ON = 0.5            # points by which a rim may be off its circle


def contacts(name: str, sketch: "Sketch") -> Sequence[tuple[tuple[float, float], float | None]]:
    """[(a place of what is on the surface as drawn, how much room it needs along it)]."""
    found = []
    for body in sketch.scene.bodies.values():
        if name in body.touched:
            rolls = "roll" in body.record
            place = sketch.rim(body.name).drawn if rolls else sketch.centre(body.name)
            found.append((place, MARGIN + sketch.rolling_radius(body.name) * rolls))
    for constraint in (sketch.spec.get("constraints") or {}).values():
        if "surface" in constraint and constraint["surface"].text == name:
            at = sketch.attachment(constraint["point"])
            found.append((at.drawn, MARGIN))
            if at.carrier in sketch.frames and at.carrier in sketch.scene.bodies:
                found.append((sketch.centre(at.carrier), None))
    return found


def ground(record: "Record", used: Sequence[tuple[tuple[float, float], float | None]],
           sketch: "Sketch") -> list[Primitive]:
    """A fixed surface under what is on it (`contacts`)."""
    if "line" in record and (borne := _borne(record, sketch)):
        a, b = (sketch.pair(place) for place in record["line"])
        e = plane.times(plane.unit(plane.minus(b, a)), free_side(a, b, used))
        return [part for place in borne for part in support.rocker(place, e)]
    if "line" in record:
        a, b = straight(record, used, sketch)
        return [*_line(a, b, used), *_rollers(record, a, b, used, sketch)]
    places = [place for place, room in used if room is not None]
    if "circle" in record:
        return _circle(record, places, sketch)
    points = curve_points(record, sketch, places[0][0] if places else 0.0)
    return [Hatch(tuple(points), -1)]


def straight(record: "Record", used: Sequence[tuple[tuple[float, float], float | None]],
             sketch: "Sketch") -> list[tuple[float, float]]:
    """The ends of a straight surface as drawn: `sunk` below its line."""
    a, b = (sketch.pair(place) for place in record["line"])
    down = plane.times(plane.left(plane.unit(plane.minus(b, a))), -free_side(a, b, used))
    return [plane.plus(place, down, sunk(record.name, sketch)) for place in (a, b)]


def sunk(name: str, sketch: "Sketch") -> float:
    """How far below its line a straight surface is drawn: under the blocks whose mass centres slide along it, where no
    others are; under rollers of what is held to it where a spring lies along it."""
    on = [body for body in sketch.scene.bodies.values() if name in body.touched]
    points = _held(name, sketch)
    if on or not points:
        return SUNK if on and not points and all("slide" in body.record for body in on) else 0.0
    record = sketch.scene.surfaces[name]
    return 2 * support.ROLLER if "body" not in record and "line" in record and _is_lain_on(record, sketch) else 0.0


def _held(name: str, sketch: "Sketch") -> "list[Reference]":
    """The points that constraints hold to a surface."""
    return [record["point"] for record in (sketch.spec.get("constraints") or {}).values()
            if "surface" in record and record["surface"].text == name]


def _borne(record: "Record", sketch: "Sketch") -> list[tuple[float, float]]:
    """Where rods lie on a straight surface, or nearly along it, if nothing else is on it: each on a bearing."""
    ends = [sketch.attachment(point) for point in _held(record.name, sketch)]
    bodies = [sketch.scene.bodies.get(end.carrier) for end in ends]
    if any(record.name in body.touched for body in sketch.scene.bodies.values()) or not all(
            body is not None and body.record.get("shape") == "rod" for body in bodies):
        return []
    along = plane.unit(plane.minus(*(sketch.pair(place) for place in record["line"])))
    rods = [plane.unit(plane.minus(*(sketch.pair(body.record[key]) for key in ("from", "to")))) for body in bodies]
    return [sketch.now(end) for end in ends] if all(abs(plane.across(along, rod)) < FLAT for rod in rods) else []


def _is_lain_on(record: "Record", sketch: "Sketch") -> bool:
    """Does a spring or damper lie along a straight surface?"""
    a, b = (sketch.pair(place) for place in record["line"])
    e = plane.unit(plane.minus(b, a))
    ends = [[sketch.attachment(end) for end in one.get("between", ())] for one in sketch.spec.connections]
    return any(pair and None not in pair and all(abs(plane.across(e, plane.minus(end.drawn, a))) < ON for end in pair)
               for pair in ends)


def _rollers(record: "Record", a: tuple[float, float], b: tuple[float, float],
             used: Sequence[tuple[tuple[float, float], float | None]], sketch: "Sketch") -> list[Primitive]:
    """Those between a straight surface that is drawn lower and what is held to it."""
    up = plane.times(plane.left(plane.unit(plane.minus(b, a))), free_side(a, b, used))
    if not _held(record.name, sketch) or not sunk(record.name, sketch):
        return []
    places = [sketch.now(sketch.attachment(point)) for point in _held(record.name, sketch)]
    return [part for place in places for part in support.roller(plane.plus(place, up, -support.ROLLER))]


def free_side(a: tuple[float, float], b: tuple[float, float],
              used: Sequence[tuple[tuple[float, float], float | None]]) -> int:
    """1 where what is on a line through a and b is on its left, −1 on its right."""
    e = plane.unit(plane.minus(b, a))
    return 1 if sum(plane.across(e, plane.minus(place, a)) for place, _ in used) >= -1e-6 else -1


def _line(a: tuple[float, float], b: tuple[float, float],
          used: Sequence[tuple[tuple[float, float], float | None]]) -> list[Primitive]:
    e, length = plane.unit(plane.minus(b, a)), plane.distance(a, b)
    spans = [(plane.dot(plane.minus(place, a), e), room) for place, room in used if room is not None] or [(0.0, 0.0),
                                                                                                        (length, 0.0)]
    least, most = min(s - room for s, room in spans), max(s + room for s, room in spans)
    low, high = min(least, max(0.0, least - FAR)), max(most, min(length, most + FAR))
    return [Hatch((plane.plus(a, e, low), plane.plus(a, e, high)), -free_side(a, b, used))]


def visible(record: "Record", places: Sequence[tuple[float, float]], sketch: "Sketch") -> list[tuple[float, float]]:
    """Points of a circle as far as it is drawn: all of one that bodies run on outside or that is carried; else about
    what is in it, up to a rim on which something leans."""
    centre, radius = sketch.pair(record["circle"]), sketch.length(record["radius"])
    if record.get("side") != "inside" or "body" in record:
        return plane.arc(centre, radius, 0.0, tau)
    angles = [plane.heading(plane.minus(place, centre)) for place in places] or [-pi / 2]
    turns = [_turn(angle, angles[0]) for angle in angles]
    rims = [_turn(plane.heading(plane.minus(place, centre)), angles[0]) for place in _rims(centre, radius, sketch)]
    low = max((turn for turn in rims if turn < min(turns)), default=min(turns) - SPREAD)
    high = min((turn for turn in rims if turn > max(turns)), default=max(turns) + SPREAD)
    return plane.arc(centre, radius, angles[0] + low, angles[0] + high)


def _turn(angle: float, start: float) -> float:
    """From one angle to another, by half a turn at most."""
    return (angle - start + pi) % tau - pi


def _rims(centre: tuple[float, float], radius: float, sketch: "Sketch") -> list[Any]:
    """Fixed points on a circle, at which constraints hold bodies."""
    points = [record["point"] for record in (sketch.spec.get("constraints") or {}).values() if "point" in record]
    places = [sketch.pair(point) for point in points if isinstance(point, list)]
    return [place for place in places if abs(plane.distance(place, centre) - radius) < ON]


def _circle(record: "Record", places: list[tuple[float, float]], sketch: "Sketch") -> list[Primitive]:
    points = visible(record, places, sketch)
    if record.get("side") == "inside":
        return [Hatch(tuple(points), -1)]
    circle = Circle(sketch.pair(record["circle"]), sketch.length(record["radius"]), "fixed", layer=SURFACE)
    return [circle] if circle.radius < SMALL else [circle, Hatch(tuple(points), 1)]


def curve_points(record: "Record", sketch: "Sketch", around: float = 0.0) -> list[tuple[float, float]]:
    """Points of a curve y = f(x) as drawn, about the abscissa `around` in points."""
    f = _height(record, sketch)
    start = around / sketch.scale
    half = half_width(record, sketch, start)
    xs = [start + half * (2 * i / SAMPLES - 1) for i in range(SAMPLES + 1)]
    return [(x * sketch.scale, y * sketch.scale) for x in xs if isfinite(y := f(x))]


def half_width(record: "Record", sketch: "Sketch", start: float = 0.0) -> float:
    """Half the width in metres that is drawn of a curve: where it rises or falls by about that much."""
    f, size = _height(record, sketch), sketch.numbers.get("size", 0.0)
    base = f(start)
    low, high = (0.2 * size, 0.6 * size) if size else (1e-6, 1e6)
    for i in range(300):
        half = low * 1.12**i
        rises = [abs(f(start + side * half) - base) for side in (-1, 1)]
        if half >= high or not all(map(isfinite, rises)) or max(rises) > STEEP * half:
            return min(half, high)
    return 1.0


def _height(record: "Record", sketch: "Sketch") -> Callable[[float], float]:
    """y of a curve over x, both in metres."""
    scene = sketch.scene
    x = scene.table.variable("the abscissa of a curve")
    node = scene.height_of(record, x)

    def f(value: float) -> float:
        found: float = evaluate([node], Floats, {**sketch.values, x.name: value})[0]
        return found
    return f
