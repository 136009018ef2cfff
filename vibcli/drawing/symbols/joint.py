"""Torsion springs and rotary dampers, at the joint about which they turn."""

from math import pi, tau

from vibcli.drawing.layout import plane
from vibcli.drawing.symbols import damper, spring, support

SPIRAL, ARC, SPAN = 12.5, 24.0, 0.62 * pi


def elements(sketch):
    """[(name, is it a spring, record, joint, body, other)] of what acts between placed bodies or on the ground."""
    found = []
    for section in ("springs", "dampers"):
        for name, record in (sketch.spec.get(section) or {}).items():
            if "torsion" not in record or "between" not in record:
                continue
            names = [None if end.text == "ground" else end.text for end in record["between"]]
            if any(name in sketch.frames for name in names):
                body, other = _turning(names, sketch)
                at = sketch.pivot(body)
                at = at if at is not None else _still(body, sketch)
                found.append((name, section == "springs", record, at, body, other))
    return found


def _turning(names, sketch):
    """The body that turns about the joint, and the other one (None: the ground)."""
    one, two = names
    if one is None or one not in sketch.frames:
        return two, None
    if two is None or two not in sketch.frames:
        return one, None
    pivot = sketch.pivot(one)
    return (one, two) if pivot is not None and pivot.carrier == two else (two, one)


def _still(body, sketch):
    from vibcli.drawing.layout.sketch import Attachment

    return Attachment(body, sketch.centre(body))


def _heading(body, joint, looks, sketch):
    """The direction of a body from a joint, as drawn."""
    left, bottom, right, top = plane.bounds([p for part in looks[body].pieces for p in part.points])
    away = plane.minus(((left + right) / 2, (bottom + top) / 2), joint)
    return plane.heading(away) if plane.distance(away, (0, 0)) > 1.0 else pi / 2


def draw(sketch, looks):
    """The primitives of all of them, and where each is: {name: (middle, normal)}."""
    found, where, wound = [], {}, {}
    for name, is_spring, _, at, body, other in elements(sketch):
        centre, moved = sketch.now(at), sketch.frames[body].angle
        key = is_spring, round(at.drawn[0], 3), round(at.drawn[1], 3)
        rank = wound[key] = wound.get(key, -1) + 1
        heading = _heading(body, at.drawn, looks, sketch)
        if other is None:
            start, held = heading + pi / 2 + 0.35 * pi * rank, 0.0
        else:
            start, held = _heading(other, at.drawn, looks, sketch), sketch.frames[other].angle
        if is_spring:
            radius = SPIRAL + 6.0 * rank
            found += spring.spiral(centre, heading + moved, start + held, radius)
            tip = plane.polar(centre, radius, start + held)
            if other is None:
                found += support.wall(tip, plane.polar((0.0, 0.0), 1.0, start), 6.0)
            where[name] = plane.polar(centre, radius + 3, start + pi / 3), plane.polar((0, 0), 1.0, start + pi / 3)
            continue
        span = SPAN if other is None else (start - heading) % tau
        span = span if 0.3 * pi < span < 1.7 * pi else SPAN
        begin, end = heading - span + held, heading + moved
        found += damper.bent(centre, ARC, begin, 1, ARC * (end - begin))
        if other is None:
            foot = plane.polar(centre, ARC, begin)
            found += support.wall(foot, plane.polar((0.0, 0.0), 1.0, begin - pi / 2), 6.0)
        mid = (begin + end) / 2
        where[name] = plane.polar(centre, ARC + 7, mid), plane.polar((0, 0), 1.0, mid)
    return found, where
