"""Bodies in a position: their outlines carried along, their pins and bearings, the floors that they slide on."""

from math import pi

from vibcli.report.drawing import plane, support
from vibcli.report.drawing.connection import snapped
from vibcli.report.drawing.primitives import BODY, Circle, Hatch, Line

RAIL = 17.0


def draw(sketch, looks, ties):
    """All bodies with their pins and floors, large ones first."""
    found = []
    for name, look in sorted(looks.items(), key=lambda item: -item[1].size()):
        found += [carried(part, sketch.frames[name]) for part in look.pieces]
        found += _floor(name, look, sketch, ties)
    return found + _pins(sketch, looks)


def carried(part, frame):
    """A primitive as drawn, moved with a frame."""
    if isinstance(part, Circle):
        return part._replace(centre=frame.point(part.centre))
    return part._replace(points=tuple(frame.point(point) for point in part.points))


def marks(sketch, looks):
    """A radius on each round body, which shows how far it has turned."""
    found = []
    for name, look in looks.items():
        if look.kind in ("disc", "ring", "wheel", "hub"):
            left, bottom, right, top = plane.bounds(look.pieces[-1].points)
            centre, radius = ((left + right) / 2, (bottom + top) / 2), (right - left) / 2
            found.append(carried(Line((centre, plane.polar(centre, radius, pi / 2)), layer=BODY), sketch.frames[name]))
    return found


def _pins(sketch, looks):
    """A hinge at every pin; a bearing where it is on the ground."""
    found, grounded = [], {}
    for name, body in sketch.scene.bodies.items():
        pivot = sketch.pivot(name) if name in looks else None
        if pivot is None:
            continue
        if sketch.is_fixed(pivot.carrier):
            key = round(pivot.drawn[0], 3), round(pivot.drawn[1], 3)
            grounded.setdefault(key, (pivot, []))[1].append(_outward(name, pivot.drawn, looks[name], sketch))
        elif body.moves:
            found += support.hinge(sketch.now(pivot))
    for pivot, directions in grounded.values():
        found += support.bearing(sketch.now(pivot), down_of(directions))
    return found


def _outward(name, pivot, look, sketch):
    """From a pin towards the middle of its body."""
    left, bottom, right, top = plane.bounds([p for part in look.pieces for p in part.points])
    away = plane.minus(((left + right) / 2, (bottom + top) / 2), pivot)
    return plane.unit(away) if plane.distance(away, (0, 0)) > 0.1 * look.size() else (0.0, 0.0)


def down_of(directions):
    """The direction of the ground from a bearing: away from what hangs, stands or reaches out from it."""
    x, y = -sum(d[0] for d in directions), -sum(d[1] for d in directions)
    if abs(x) < 1e-6 and abs(y) < 1e-6:
        return 0.0, -1.0
    if abs(y) >= 0.5 * abs(x):
        return 0.0, 1.0 if y > 0 else -1.0
    return (1.0 if x > 0 else -1.0), 0.0


def fixed_pivots(sketch, looks):
    """Rounded places of all bearings."""
    pivots = [sketch.pivot(name) for name in looks]
    return {(round(p.drawn[0], 3), round(p.drawn[1], 3)) for p in pivots if p and sketch.is_fixed(p.carrier)}


def _floor(name, look, sketch, ties):
    """The ground, and rollers, under a box that slides on it; guides beside one that slides upright."""
    slide = sketch.scene.bodies[name].record.get("slide")
    if slide is None or look.kind not in ("block", "platform", "ramp") or "surface" in slide:
        return []
    if "carrier" in slide and not sketch.is_fixed(slide["carrier"].text):
        return []
    e = snapped(plane.unit(sketch.pair(slide["along"]))) if "along" in slide else (1.0, 0.0)
    frame = sketch.frames[name]
    left, bottom, right, top = plane.bounds([p for part in look.outlines for p in part.points])
    if abs(e[1]) > 0.95:
        return _guides(name, (left, bottom, right, top), sketch)
    e = e if e[0] > 0 else plane.times(e, -1)
    down = plane.times(plane.left(e), -1)
    if e == (1, 0):
        under = ((left + right) / 2, bottom)
        half, wheels = (right - left) / 2, 2 * support.ROLLER
        spots = [plane.plus(under, e, side * (half - 6)) for side in (-1, 1)] if half > 8 else [under]
        found = [part for spot in spots for part in support.roller(frame.point(plane.plus(spot, down, support.ROLLER)))]
    else:
        middle = sketch.centre(name)
        under, half, wheels, found = plane.plus(middle, down, look.height / 2), look.width / 2, 0.0, []
    floor = plane.plus(under, down, wheels)
    if _hangs(name, sketch):
        for side in (-1, 1):
            found += support.floor(plane.plus(floor, e, side * (half + 2)), e, RAIL / 2 + 2)
        return found
    return [*found, *support.floor(floor, e, half + RAIL)]


def _hangs(name, sketch):
    """Does anything hang from the pin of this body?"""
    _, y0 = sketch.centre(name)
    for other in sketch.scene.bodies:
        pivot = sketch.pivot(other) if other in sketch.frames else None
        if pivot is not None and pivot.carrier == name and sketch.centre(other)[1] < y0 - 1e-6:
            return True
    return False


def _guides(name, box, sketch):
    """Walls on either side of a body that slides upright and is pinned to others."""
    joined = False
    for record in (sketch.spec.get("constraints") or {}).values():
        joined |= any(getattr(end, "text", None) == name for key in ("join", "link") for end in record.get(key, ()))
    for other in sketch.scene.bodies:
        pivot = sketch.pivot(other) if other in sketch.frames else None
        joined |= pivot is not None and pivot.carrier == name
    if not joined:
        return []
    left, bottom, right, top = box
    low, high = bottom - 8, top + 8
    return [Hatch(((left - 2, low), (left - 2, high)), 1), Hatch(((right + 2, low), (right + 2, high)), -1)]
