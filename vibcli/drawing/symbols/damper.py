"""Dampers: a dashpot between two ends, or bent about a joint."""

from vibcli.drawing.canvas.primitives import ELEMENT, Polygon, Polyline
from vibcli.drawing.layout import plane

CUP, HALF = 13.0, 5.5


def dashpot(start, end):
    """A damper from one place to another."""
    return _dashpot(plane.along(start, end), plane.distance(start, end))


def bent(centre, radius, start, sense, length):
    """A rotary damper: the same along an arc."""
    at = plane.around(centre, radius, start, sense)
    found = _dashpot(at, length)
    rod = found[-1]
    steps = [length * i / 12 for i in range(13)]
    back = rod.points[0]
    lead = tuple(at(s) for s in steps if s < 0.35 * length)
    tail = (back, *(at(s) for s in steps if s > 0.6 * length))
    return [found[0]._replace(points=(*lead, found[0].points[-1])), *found[1:-1], rod._replace(points=tail)]


def _dashpot(at, length):
    cup = min(CUP, 0.5 * length)
    near, far = 0.5 * (length - cup), 0.5 * (length + cup)
    piston = near + 0.55 * cup
    inner = Polygon((at(near, HALF), at(far, HALF), at(far, -HALF), at(near, -HALF)), "oil", "oil", 0.1, layer=ELEMENT)
    return [Polyline((at(0), at(near)), "damper"), inner,
            Polyline((at(far, HALF), at(near, HALF), at(near, -HALF), at(far, -HALF)), "damper"),
            Polyline((at(piston, HALF - 1.2), at(piston, 1.2 - HALF)), "damper", 1.8),
            Polyline((at(piston), at(length)), "damper")]
