"""What holds a scene: hinges, bearings on the ground, walls, rollers."""

from typing import Any

from vibcli.drawing.canvas.primitives import ARROW, BEHIND, JOINT, SURFACE, Circle, Hatch, Polygon, Primitive
from vibcli.drawing.layout import plane

HINGE, HEIGHT, HALF, WALL, ROLLER = 2.6, 11.0, 7.0, 11.0, 3.0


def hinge(place: tuple[float, float]) -> list[Primitive]:
    """Two bodies pinned together."""
    return [Circle(place, HINGE, "paper", layer=JOINT)]


def bearing(place: tuple[float, float], down: tuple[float, float], height: float = HEIGHT) -> list[Any]:
    """A pin on the ground, which lies in the direction `down`."""
    foot, side, half = plane.plus(place, down, height), plane.left(down), HALF + 0.2 * (height - HEIGHT)
    a, b = plane.plus(foot, side, half), plane.plus(foot, side, -half)
    ends = plane.plus(foot, side, half + 5), plane.plus(foot, side, -half - 5)
    return [Polygon((place, a, b), "paper", layer=JOINT - 1), Hatch(ends, 1, layer=JOINT - 1),
            Circle(place, HINGE, "paper", layer=JOINT)]


def wall(place: tuple[float, float], outward: tuple[float, float], half: float = WALL) -> list[Primitive]:
    """A piece of the ground at the end of a spring, damper or rope; `outward` points into it."""
    side = plane.left(outward)
    return [Hatch((plane.plus(place, side, half), plane.plus(place, side, -half)), 1, layer=BEHIND)]


def shaken_wall(place: tuple[float, float], outward: Any) -> list[Primitive]:
    """A support that is driven: a bar without ground behind it."""
    side = plane.left(outward)
    ends = [plane.plus(place, side, WALL), plane.plus(place, side, -WALL)]
    return [Polygon((*ends, plane.plus(ends[1], outward, 4), plane.plus(ends[0], outward, 4)), "driven", layer=BEHIND)]


def floor(place: tuple[float, float], along: tuple[float, float], half: float) -> list[Primitive]:
    """A flat piece of ground under what slides; it lies to the right of `along`."""
    return [Hatch((plane.plus(place, along, -half), plane.plus(place, along, half)), -1, layer=SURFACE)]


def dot(place: tuple[float, float]) -> list[Primitive]:
    """Where a spring, damper or rope is fastened to a body."""
    return [Circle(place, 1.6, "ink", layer=JOINT)]


def roller(place: tuple[float, float]) -> list[Primitive]:
    return [Circle(place, ROLLER, "paper", layer=BEHIND)]


def rocker(place: tuple[float, float], along: tuple[float, float]) -> list[Any]:
    """A bearing that rolls on the ground, which lies to the right of `along`."""
    down = plane.times(plane.left(along), -1.0)
    a, b = (plane.plus(plane.plus(place, down, 10.0), along, t) for t in (-6.5, 6.5))
    rollers = [Circle(plane.plus(plane.plus(place, down, 12.0), along, t), 2.0, "paper") for t in (-4.0, 4.0)]
    return [Polygon((place, a, b), "paper", layer=JOINT - 1), *rollers,
            *floor(plane.plus(place, down, 14.0), along, 12.0)]


def peg(place: tuple[float, float]) -> list[Primitive]:
    """A small smooth peg."""
    return [Circle(place, HINGE, "ink", layer=ARROW - 1)]
