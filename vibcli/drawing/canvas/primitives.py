"""What a drawing is made of: lines, filled outlines, hatching and text, in points of 1/72 inch, y upwards.

A role names what a line is: ink for what is there, blue for coordinates, red for loads, green for what is driven.
Layers are drawn in ascending order.
"""

from collections.abc import Iterable, Sequence
from typing import Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.layout import plane

SURFACE, BEHIND, BODY, ELEMENT, JOINT, LEADER, ARROW = range(7)
SPACING, DEPTH = 5.0, 5.5       # of hatching
COLOURS = {
    "ink": "#1b1b1b", "body": "#dce4ec", "inner": "#c9d5e1", "fixed": "#e4e4e0", "paper": "#ffffff",
    "ground": "#4d4d4d", "spring": "#1b1b1b", "damper": "#1b1b1b", "oil": "#e8e8e8", "rope": "#7b4a1e",
    "belt": "#7b4a1e", "coordinate": "#1d5fa6", "load": "#b3261e", "driven": "#2c7a4b", "measure": "#6a6a6a",
    "ghost": "#b9b9b9", "note": "#5a5a5a", "diagram": "#0072b2", "positive": "#dcebf7", "negative": "#fbe6d0",
}


class Polyline(NamedTuple):
    """An open polyline."""

    points: tuple[tuple[float, float], ...]
    role: str = "ink"
    width: float = 1.1
    dashed: bool = False
    layer: int = ELEMENT

    def strokes(self) -> list[tuple[tuple[float, float], ...]]:
        return [self.points]


class Polygon(NamedTuple):
    """A closed outline, filled unless `fill` is None."""

    points: tuple[tuple[float, float], ...]
    fill: str | None = "body"
    role: str = "ink"
    width: float = 1.1
    dashed: bool = False
    layer: int = BODY

    def strokes(self) -> list[tuple[tuple[float, float], ...]]:
        return [(*self.points, self.points[0])]


class Circle(NamedTuple):
    """A circle, filled unless `fill` is None."""

    centre: tuple[float, float]
    radius: float
    fill: str | None = None
    role: str = "ink"
    width: float = 1.1
    dashed: bool = False
    layer: int = BODY

    @property
    def points(self) -> list[tuple[float, float]]:
        return plane.circle(self.centre, self.radius)

    def strokes(self) -> list[tuple[tuple[float, float], ...]]:
        points = self.points
        return [(*points, points[0])]


class Hatch(NamedTuple):
    """A line of the ground, hatched on its left (side 1) or right (−1)."""

    points: tuple[tuple[float, float], ...]
    side: int = 1
    role: str = "ground"
    width: float = 1.1
    dashed: bool = False
    layer: int = SURFACE

    def strokes(self) -> list[tuple[tuple[float, float], ...]]:
        found, rest = [self.points], SPACING / 2
        for a, b in zip(self.points, self.points[1:], strict=False):
            length, at = plane.distance(a, b), plane.along(a, b)
            while rest < length:
                found.append((at(rest), at(rest - DEPTH * 0.8, self.side * DEPTH)))
                rest += SPACING
            rest -= length
        return found


Primitive = Polyline | Polygon | Circle | Hatch


class Run(NamedTuple):
    """Letters of one size: `rise` is that of their baseline; slanted are the names of quantities."""

    text: str
    slanted: bool = False
    size: float = 11.0
    rise: float = 0.0


class LetterRuns(NamedTuple):
    """Runs of letters from the left end of their baseline on."""

    place: tuple[float, float]
    runs: tuple[Run, ...]
    box: tuple[float, float, float, float]              # (left, bottom, right, top) as measured
    role: str = "ink"
    layer: int = ARROW

    def strokes(self) -> list[Any]:
        return []


def extent(primitives: Sequence[Any]) -> tuple[float, float, float, float] | None:
    """(left, bottom, right, top) of a drawing; None of an empty one."""
    points = [point for part in primitives for stroke in part.strokes() for point in stroke]
    points += [corner for part in primitives if isinstance(part, LetterRuns) for corner in (part.box[:2], part.box[2:])]
    return plane.bounds(points) if points else None


def ghost(primitives: Iterable[Any]) -> list[Any]:
    """The same in grey and without its texts: the position from which something moves."""
    found = []
    for part in primitives:
        if not isinstance(part, LetterRuns):
            filled = {"fill": None} if isinstance(part, (Polygon, Circle)) else {}
            found.append(part._replace(role="ghost", layer=SURFACE, **filled))
    return found


def shifted(part: Any, by: tuple[float, float]) -> Any:
    """A primitive elsewhere."""
    if isinstance(part, LetterRuns):
        left, bottom, right, top = part.box
        return part._replace(place=plane.plus(part.place, by),
                             box=(left + by[0], bottom + by[1], right + by[0], top + by[1]))
    if isinstance(part, Circle):
        return part._replace(centre=plane.plus(part.centre, by))
    return part._replace(points=tuple(plane.plus(point, by) for point in part.points))
