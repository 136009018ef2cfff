"""Arrows: straight and round, with a filled head."""

from math import cos, pi, sin
from typing import Any

from vibcli.drawing.canvas.primitives import ARROW as ARROW
from vibcli.drawing.canvas.primitives import Polygon, Primitive
from vibcli.drawing.canvas.primitives import Polyline as Polyline
from vibcli.drawing.layout import plane

HEAD, WING = 6.5, 2.3


def head(tip: tuple[float, float], direction: tuple[float, float], role: str, size: float = HEAD) -> Polygon:
    back, side = plane.plus(tip, direction, -size), plane.left(direction)
    wing = WING * size / HEAD
    return Polygon((tip, plane.plus(back, side, wing), plane.plus(back, side, -wing)), role, role, 0.3, layer=ARROW)


def straight(start: Any, tip: tuple[float, float], role: Any, width: float = 1.2, both: Any = False) -> list[Any]:
    """An arrow from one place to another."""
    e = plane.unit(plane.minus(tip, start))
    size = min(HEAD, 0.6 * plane.distance(start, tip))
    found = [Polyline((plane.plus(start, e, size - 1) if both else start, plane.plus(tip, e, 1 - size)), role, width,
                  layer=ARROW), head(tip, e, role, size)]
    return [*found, head(start, plane.times(e, -1), role, size)] if both else found


def round_(centre: tuple[float, float], radius: float, start: float, end: float, role: str,
           width: float = 1.2) -> list[Any]:
    """An arrow along an arc between two angles."""
    sense = 1 if end > start else -1
    stop = end - sense * min(0.8 * HEAD / radius, 0.5 * abs(end - start))
    tip = plane.polar(centre, radius, end)
    base = plane.polar(centre, radius, end - sense * min(HEAD / radius, 0.6 * abs(end - start)))
    return [Polyline(tuple(plane.arc(centre, radius, start, stop)), role, width, layer=ARROW),
            head(tip, plane.unit(plane.minus(tip, base)), role)]


def over(place: tuple[float, float], role: str, width: float = 1.2) -> list[Primitive]:
    """An arrow round a shaft that is seen from the side."""
    angles = [1.15 * pi - 1.2 * pi * i / 16 for i in range(17)]
    points = [(place[0] + 12.0 * cos(angle), place[1] + 5.0 * sin(angle)) for angle in angles]
    tip = points[-1]
    return [Polyline(tuple(points[:-2]), role, width, layer=ARROW),
            head(tip, plane.unit(plane.minus(tip, points[-3])), role)]
