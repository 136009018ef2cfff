"""Words of a figure that touch others, or lines; arrows across what is no arrow's place. In points."""

from itertools import pairwise

from vibcli.drawing.canvas.primitives import (
    ARROW,
    BEHIND,
    BODY,
    SURFACE,
    Circle,
    Hatch,
    LetterRuns,
    Polygon,
    Polyline,
)
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols.support import ROLLER

ARROWS = "coordinate", "load", "driven"
PARTS = "spring", "damper", "oil"
TAIL, ROUND_TAIL = 7.0, 0.4     # of an arrow, which begins at what it moves: points; the part of an arc
SPIRAL = 50         # points of a spring that is wound about a joint
BESIDE = 0.5        # points by which boxes of words may overlap
WITHIN = 1.5        # points inside a box by which lines may come from above and below: letters do not fill it
CLOSE = 1.0         # points beside a box in which there are none


def touching(drawn):
    """[(a word, what it touches)] of a figure."""
    words = [part for part in drawn if isinstance(part, LetterRuns)]
    lines = [part for part in drawn if not isinstance(part, LetterRuns)]
    found = []
    for i, word in enumerate(words):
        text = _text(word)
        found += [(text, _text(other)) for other in words[:i] if _overlap(word.box, other.box)]
        found += [(text, line.role) for line in lines if any(_struck(word.box, stroke) for stroke in line.strokes())
                  and not _hidden(line, word, lines)]
    return found


def _hidden(line, word, drawn):
    """Is a line behind the body in which a word stands?"""
    left, bottom, right, top = word.box
    corners = (left, bottom), (right, bottom), (right, top), (left, top)
    return line.layer < BODY and any(all(plane.inside(corner, list(part.points)) for corner in corners)
                                     for part in drawn if isinstance(part, Polygon) and _is_mass(part))


def _text(word):
    return "".join(run.text for run in word.runs)


def _overlap(one, two):
    return all(min(one[k + 2], two[k + 2]) - max(one[k], two[k]) > BESIDE for k in (0, 1))


def _struck(box, stroke):
    """Does a polyline pass through a box? Each stretch is cut to it (Liang & Barsky, 1984)."""
    left, bottom, right, top = box[0] - CLOSE, box[1] + WITHIN, box[2] + CLOSE, box[3] - WITHIN
    for (ax, ay), (bx, by) in pairwise(stroke):
        first, last = 0.0, 1.0
        for rate, room in ((ax - bx, ax - left), (bx - ax, right - ax), (ay - by, ay - bottom), (by - ay, top - ay)):
            if rate < 0:
                first = max(first, room / rate)
            elif rate > 0:
                last = min(last, room / rate)
            elif room < 0:
                last = -1.0
        if first <= last:
            return True
    return False


def crossed(drawn):
    """[(role of an arrow, role of a spring, damper or body that it crosses)] of a figure."""
    arrows = [part for part in drawn if isinstance(part, Polyline) and part.layer == ARROW and part.role in ARROWS]
    others = [part for part in drawn if part.role in PARTS or _is_mass(part)]
    return [(arrow.role, other.role) for arrow in arrows for path in [_without_tail(arrow.points)] for other in others
            if any(cross(path, stroke) for stroke in other.strokes())]


def grounded(drawn):
    """[(role of a spring or damper, what its middle leads through)] of a figure: floors and rollers."""
    paths = [(part.role, part.points[1:-1]) for part in drawn if isinstance(part, Polyline) and part.role in PARTS]
    under = [part for part in drawn if (isinstance(part, Hatch) and part.layer == SURFACE) or (
        isinstance(part, Circle) and part.layer == BEHIND and part.radius == ROLLER)]
    return [(role, type(other).__name__) for role, path in paths for other in under
            if any(cross(path, stroke) for stroke in other.strokes())]


def measured(drawn):
    """[role of an arrow that crosses the line of a dimension] of a figure."""
    lines = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "measure"]
    return [arrow.role for arrow in drawn if isinstance(arrow, Polyline) and arrow.layer == ARROW
            and arrow.role in ARROWS and any(cross(_without_tail(arrow.points), line) for line in lines)]


def struck(drawn):
    """[role of a spring or dashpot that a dimension line, or what leads to it, passes through] of a figure: their
    coils and cups, not the rods at their ends."""
    lines = [part.points for part in drawn if isinstance(part, Polyline) and part.role == "measure"]
    inner = [(part.role, part.points[1:-1] if part.role == "spring" else part.strokes()[0]) for part in drawn
             if part.role == "oil" or (isinstance(part, Polyline) and part.role == "spring" and len(part.points) > 6)]
    return [role for role, path in inner if any(cross(path, line) for line in lines)]


def begun(drawn):
    """[role of an arc that begins among the coils of a spring] of a figure, be it between two of their strokes."""
    coils = [[*points[1:-1:2], *points[2:-1:2][::-1]] for part in drawn if part.role == "spring"
             for points in [part.points] if isinstance(part, Polyline) and 6 < len(points) < SPIRAL]
    return [part.role for part in drawn if isinstance(part, Polyline) and part.layer == ARROW and part.role in ARROWS
            and len(part.points) > 2 and any(plane.inside(part.points[0], band) for band in coils)]


def cross(path, stroke):
    if not path or any(max(p[k] for p in one) < min(p[k] for p in other)
                       for one, other in ((path, stroke), (stroke, path)) for k in (0, 1)):
        return False
    return any(_meet(*one, *two) for two in pairwise(stroke) for one in pairwise(path))


def _is_mass(part):
    return isinstance(part, (Polygon, Circle)) and part.layer == BODY and part.fill not in (None, "paper")


def _without_tail(points):
    """The path of an arrow from its tail on; of a tick nothing, which stands where an arrow begins."""
    lengths = [plane.distance(a, b) for a, b in pairwise(points)]
    rest = TAIL if len(points) == 2 else ROUND_TAIL * sum(lengths)
    for i, length in enumerate(lengths):
        if length > rest:
            return [plane.plus(points[i], plane.minus(points[i + 1], points[i]), rest / length), *points[i + 1:]]
        rest -= length
    return points[-1:]


def _meet(a, b, c, d):
    """Do two stretches cross each other?"""
    along, over, gap = plane.minus(b, a), plane.minus(d, c), plane.minus(c, a)
    size = plane.across(along, over)
    return abs(size) > 1e-9 and all(0 <= plane.across(gap, way) / size <= 1 for way in (over, along))
