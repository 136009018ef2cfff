"""Outlines of the shapes of bodies, as drawn."""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols.look import BALL, ROD

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.language.reader import Record


class Outline(NamedTuple):
    """A closed or open outline; a `cut` is a hole. `band` marks what is only a line: a ring or an arch."""

    points: list[tuple[float, float]]
    closed: bool = True
    cut: bool = False
    band: bool = False


def outline(record: "Record", sketch: "Sketch") -> Outline:
    """The Outline of one shape: a body or a part of one."""
    shape, cut = record.get("shape", "particle"), record.get("cut", False)
    angle = sketch.number(record["angle"]) if "angle" in record else 0.0
    if shape == "rod":
        return Outline(plane.capsule(sketch.pair(record["from"]), sketch.pair(record["to"]), ROD), cut=cut)
    centre = sketch.pair(record["at"])
    if shape == "rectangle":
        points = plane.box(centre, sketch.length(record["width"]), sketch.length(record["height"]), angle)
    elif shape == "ellipse":
        a, b = sketch.length(record["a"]), sketch.length(record["b"])
        size = max(a, b)
        points = [plane.plus(centre, plane.turned((x * a / size, y * b / size), angle))
                  for x, y in plane.circle((0.0, 0.0), size)]
    elif shape in ("sector", "arch"):
        half = sketch.number(record["half_angle"])
        points = plane.arc(centre, sketch.length(record["radius"]), angle - half, angle + half)
        points = [centre, *points] if shape == "sector" else points
    else:
        points = plane.circle(centre, sketch.length(record["radius"]) if "radius" in record else BALL)
    return Outline(points, shape != "arch", cut, shape in ("ring", "arch"))
