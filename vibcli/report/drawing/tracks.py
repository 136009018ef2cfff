"""Fixed surfaces: the ground under what rolls or slides on lines, circles and curves."""

from math import isfinite, pi

from vibcli.algebra.evaluate import Floats, evaluate
from vibcli.report.drawing import plane
from vibcli.report.drawing.primitives import SURFACE, Circle, Hatch

SPREAD, MARGIN, FAR, SMALL = 0.35 * pi, 24.0, 150.0, 16.0  # of a circle beside what is inside it; beyond what rolls
SAMPLES, STEEP = 48, 0.6


def ground(record, contacts, bodies, sketch):
    """A fixed surface; `contacts` are the places on it that are used as drawn, `bodies` places on its free side."""
    if "line" in record:
        return _line(*(sketch.pair(place) for place in record["line"]), contacts, bodies)
    if "circle" in record:
        return _circle(record, contacts, sketch)
    points = curve_points(record, sketch, contacts[0][0] if contacts else 0.0)
    return [Hatch(tuple(points), -1)]


def _line(a, b, contacts, bodies):
    e, length = plane.unit(plane.minus(b, a)), plane.distance(a, b)
    used = [plane.dot(plane.minus(place, a), e) for place in contacts] or [0.0, length]
    low = min(max(0.0, min(used) - FAR), min(used) - MARGIN * (min(used) > MARGIN or min(used) < -1e-6))
    high = max(min(length, max(used) + FAR), max(used) + MARGIN * (max(used) < length - MARGIN
                                                                    or max(used) > length + 1e-6))
    off = sum(plane.across(e, plane.minus(place, a)) for place in bodies)
    return [Hatch((plane.plus(a, e, low), plane.plus(a, e, high)), -1 if off >= 0 else 1)]


def visible(record, contacts, sketch):
    """Points of a circle as far as it is drawn: all of one that bodies run on outside or that is carried."""
    centre, radius = sketch.pair(record["circle"]), sketch.length(record["radius"])
    if record.get("side") != "inside" or "body" in record:
        return plane.arc(centre, radius, 0.0, 2 * pi)
    angles = [plane.heading(plane.minus(place, centre)) for place in contacts] or [-pi / 2]
    turns = [(angle - angles[0] + pi) % (2 * pi) - pi for angle in angles]
    return plane.arc(centre, radius, angles[0] + min(turns) - SPREAD, angles[0] + max(turns) + SPREAD)


def _circle(record, contacts, sketch):
    points = visible(record, contacts, sketch)
    if record.get("side") == "inside":
        return [Hatch(tuple(points), -1)]
    circle = Circle(sketch.pair(record["circle"]), sketch.length(record["radius"]), "fixed", layer=SURFACE)
    return [circle] if circle.radius < SMALL else [circle, Hatch(tuple(points), 1)]


def curve_points(record, sketch, around=0.0):
    """Points of a curve y = f(x) as drawn, about the abscissa `around` in points."""
    f = _height(record, sketch)
    start = around / sketch.scale
    half = half_width(record, sketch, start)
    xs = [start + half * (2 * i / SAMPLES - 1) for i in range(SAMPLES + 1)]
    return [(x * sketch.scale, y * sketch.scale) for x in xs if isfinite(y := f(x))]


def half_width(record, sketch, start=0.0):
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


def _height(record, sketch):
    """y of a curve over x, both in metres."""
    scene = sketch.scene
    x = scene.table.variable("the abscissa of a curve")
    node = scene.height_of(record, x)

    def f(value):
        return evaluate([node], Floats, {**sketch.values, x.name: value})[0]
    return f
