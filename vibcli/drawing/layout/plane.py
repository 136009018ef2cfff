"""Vectors of the plane as pairs of floats: what drawing needs and no more."""

from collections.abc import Callable, Sequence
from functools import lru_cache
from math import acos, atan2, cos, hypot, pi, sin, tau
from typing import Any

Place = tuple[float, float]
FLAT, FINEST = 0.06, 0.01       # points by which a polyline may leave its arc; radians


def plus(a: tuple[float, float], b: tuple[float, float], factor: float = 1.0) -> tuple[float, float]:
    """a + factor·b."""
    return a[0] + factor * b[0], a[1] + factor * b[1]


def minus(a: tuple[float, float], b: tuple[float, float]) -> tuple[float, float]:
    return a[0] - b[0], a[1] - b[1]


def times(a: tuple[float, float], factor: Any) -> tuple[float, float]:
    return a[0] * factor, a[1] * factor


def dot(a: tuple[float, float], b: tuple[float, float]) -> float:
    return a[0] * b[0] + a[1] * b[1]


def across(a: tuple[float, float], b: tuple[float, float]) -> float:
    """The component of a × b out of the plane."""
    return a[0] * b[1] - a[1] * b[0]


def distance(a: tuple[float, float], b: tuple[float, float]) -> float:
    return hypot(b[0] - a[0], b[1] - a[1])


def unit(a: Sequence[float], otherwise: tuple[float, float] = (1.0, 0.0)) -> tuple[float, float]:
    size = hypot(*a)
    return (a[0] / size, a[1] / size) if size > 1e-12 else otherwise


def left(a: tuple[float, float]) -> tuple[float, float]:
    """a turned by a right angle, counter-clockwise."""
    return -a[1], a[0]


def turned(a: tuple[float, float], angle: float) -> tuple[float, float]:
    return a[0] * cos(angle) - a[1] * sin(angle), a[0] * sin(angle) + a[1] * cos(angle)


def polar(centre: tuple[float, float], radius: float, angle: float) -> tuple[float, float]:
    return centre[0] + radius * cos(angle), centre[1] + radius * sin(angle)


def heading(a: tuple[float, float]) -> float:
    """The angle of a vector from +x."""
    return atan2(a[1], a[0])


def middle(a: tuple[float, float], b: tuple[float, float]) -> tuple[float, float]:
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


def along(start: tuple[float, float], end: tuple[float, float]) -> Callable[..., tuple[float, float]]:
    """A map from (distance along start–end, distance to its left) to the plane."""
    e = unit(minus(end, start))
    n = left(e)
    return lambda s, t=0.0: (start[0] + s * e[0] + t * n[0], start[1] + s * e[1] + t * n[1])


def around(centre: tuple[float, float], radius: float, start: float) -> Callable[..., tuple[float, float]]:
    """As `along` on an arc: from the angle `start` on, counter-clockwise."""
    return lambda s, t=0.0: polar(centre, radius - t, start + s / radius)


def arc(centre: tuple[float, float], radius: float, start: float, end: float) -> list[tuple[float, float]]:
    """Points on an arc from one angle to another, dense enough to look round."""
    step = max(FINEST, 2 * acos(max(0.0, 1 - FLAT / max(radius, 2 * FLAT))))
    count = max(2, min(200, int(abs(end - start) / step) + 1))
    return [polar(centre, radius, start + (end - start) * i / count) for i in range(count + 1)]


def circle(centre: tuple[float, float], radius: float) -> list[tuple[float, float]]:
    return list(_circle(*centre, radius))


@lru_cache(64)      # of one thing it is asked for its outline, its extent and the room that it takes
def _circle(x: float, y: float, radius: float) -> list[tuple[float, float]]:
    return arc((x, y), radius, 0.0, tau)[:-1]


def box(centre: tuple[float, float], width: float, height: float, angle: float = 0.0) -> list[tuple[float, float]]:
    """The corners of a rectangle, its width along the angle."""
    e, n = (cos(angle) * width / 2, sin(angle) * width / 2), (-sin(angle) * height / 2, cos(angle) * height / 2)
    return [(centre[0] + i * e[0] + j * n[0], centre[1] + i * e[1] + j * n[1])
            for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def capsule(start: tuple[float, float], end: tuple[float, float], radius: float) -> list[tuple[float, float]]:
    """The outline of a rod with round ends."""
    angle = heading(minus(end, start))
    return arc(end, radius, angle - pi / 2, angle + pi / 2) + arc(start, radius, angle + pi / 2, angle + 3 * pi / 2)


def inside(point: tuple[float, float], polygon: Sequence[tuple[float, float]]) -> bool:
    """Is a point within a closed polygon?"""
    x, y = point
    found = False
    for (ax, ay), (bx, by) in zip(polygon, [*polygon[1:], polygon[0]], strict=True):
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            found = not found
    return found


def nearest_on(point: tuple[float, float], start: tuple[float, float], end: tuple[float, float]) -> tuple[float, float]:
    """The point of a segment that is nearest to a point."""
    d = minus(end, start)
    square = dot(d, d)
    s = 0.0 if square == 0 else min(1.0, max(0.0, dot(minus(point, start), d) / square))
    return plus(start, d, s)


def leaves(start: tuple[float, float], direction: tuple[float, float],
           polygon: Sequence[tuple[float, float]]) -> tuple[float, float]:
    """Where a ray from within a polygon leaves it; its start where it does not."""
    far = 0.0
    for a, b in zip(polygon, [*polygon[1:], polygon[0]], strict=True):
        d = minus(b, a)
        slope = across(direction, d)
        if abs(slope) > 1e-12:
            s, t = across(minus(a, start), d) / slope, across(minus(a, start), direction) / slope
            if s > far and -1e-9 <= t <= 1 + 1e-9:
                far = s
    return plus(start, direction, far)


def area(polygon: Sequence[tuple[float, float]]) -> float:
    """The area within a closed polygon."""
    return abs(sum(across(a, b) for a, b in zip(polygon, [*polygon[1:], polygon[0]], strict=True))) / 2


def bounds(points: Sequence[tuple[float, float]]) -> tuple[float, float, float, float]:
    """(left, bottom, right, top) of points."""
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return min(xs), min(ys), max(xs), max(ys)


def corners(points: Sequence[tuple[float, float]]) -> tuple[tuple[float, float], tuple[float, float]]:
    """The lower left and the upper right corner of the box about points."""
    left, bottom, right, top = bounds(points)
    return (left, bottom), (right, top)
