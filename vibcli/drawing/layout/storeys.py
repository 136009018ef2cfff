"""Storeys above one another: girders on columns, which the springs between them stand for; ground, shaken or not."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import BEHIND, SURFACE, Hatch, Polygon, Polyline, Primitive
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.lumped_place import Layout, LumpedPlace
from vibcli.drawing.symbols.connection import symbol

if TYPE_CHECKING:
    from vibcli.drawing.layout.rows import Edge, LumpedRow
    from vibcli.scene.scene import Scene

HALF, THICK, STOREY, COLUMN, BASE, ASIDE, STEPS = 48.0, 9.0, 62.0, 40.0, 3.5, 56.0, 12


def is_one(row: "LumpedRow", scene: "Scene") -> bool:
    """Are all masses of a row storeys, each joined to the next alone, on one ground?"""
    heavy = [name for name in row.bodies if scene.bodies[name].mass is not None]
    light = [name for name in row.bodies if name not in heavy]
    grounds = [0 in row.gaps, len(row.bodies) in row.gaps, *(name in (row.bodies[0], row.bodies[-1]) for name in light)]
    return bool(heavy) and not row.lanes and sum(grounds) == 1 and all(
        scene.bodies[name].record.get("looks") == "frame" for name in heavy)


def layout(row: "LumpedRow", scene: "Scene", left: float, top: float) -> Layout:
    """The Layout of storeys from the upper left corner on; bodies without mass are the ground that shakes."""
    bodies, last = list(row.bodies), len(row.bodies)
    if last in row.gaps or (0 not in row.gaps and scene.bodies[bodies[0]].mass is not None):
        bodies.reverse()
    count = sum(scene.bodies[name].mass is not None for name in bodies)
    x, ground = left + ASIDE + HALF, top - 26 - count * STOREY
    places, y = {}, ground
    for name in bodies:
        light = scene.bodies[name].mass is None
        y += 0.0 if light else STOREY
        places[name] = LumpedPlace((x, y - BASE if light else y), HALF + 8 * light, BASE if light else THICK, False)
    return Layout(row, places, None, None, ground, top, "frame")


def draw(layout: Layout,
         moved: Mapping[str, float]) -> tuple[list[Any], dict[str, tuple[Any, ...]]]:
    """The primitives of storeys, and where their elements are; `moved`: {body: displacement in points}."""
    found: list[Any] = []
    where = {}
    for name, place in layout.places.items():
        box = plane.box(plane.plus(place.middle, (moved.get(name, 0.0), 0.0)), 2 * place.half, 2 * place.height)
        light = place.height == BASE
        found.append(Polygon(tuple(box), "driven" if light else "body"))
        if light:       # the ground itself moves
            found.append(Hatch((box[0], box[1]), -1, "driven"))
    x = next(iter(layout.places.values())).middle[0]
    if not any(place.height == BASE for place in layout.places.values()):
        found.append(Hatch(((x - HALF - 12, layout.y), (x + HALF + 12, layout.y)), -1, layer=SURFACE))
    for edges in layout.row.gaps.values():
        lines, places = _storey(edges, *_levels(edges[0], layout, moved, x))
        found += lines
        where |= places
    return found, where


def _levels(edge: "Edge", layout: Layout, moved: Mapping[str, float],
            x: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """The middle of the upper side of what is below an element, and that of the lower side of what is above."""
    names = sorted((name for name in (edge.one, edge.two) if name), key=lambda name: layout.places[name].middle[1])
    tops = [(x, layout.y)] if len(names) == 1 else []
    tops += [plane.plus(layout.places[name].middle, (moved.get(name, 0.0), layout.places[name].height))
             for name in names]
    return tops[0], plane.plus(tops[1], (0.0, -2 * layout.places[names[-1]].height))


def _storey(edges: "Sequence[Edge]", low: tuple[float, float],
            high: tuple[float, float]) -> tuple[list[Primitive], dict[str, tuple[plane.Place, plane.Place]]]:
    """Columns for the springs between two girders, what else there is aslant between them."""
    found: list[Primitive] = []
    where = {}
    springs = [edge.record for edge in edges if edge.record.element.name == "spring"]
    others = [edge.record for edge in edges if edge.record.element.name != "spring"]
    for side in (-1, 1) if springs else ():
        found.append(_column(plane.plus(low, (side * COLUMN, 0.0)), plane.plus(high, (side * COLUMN, 0.0))))
    for i, record in enumerate(springs):
        side = -1 if i % 2 == 0 else 1
        where[record.name] = plane.plus(plane.middle(low, high), (side * (COLUMN + 2), 0.0)), (float(side), 0.0)
    for i, record in enumerate(others):
        start, end = plane.plus(low, (-COLUMN + 10 + 14 * i, 0.0)), plane.plus(high, (COLUMN - 18 + 14 * i, 0.0))
        found += symbol(record).between(record, start, end, plane.distance(start, end))
        where[record.name] = plane.middle(start, end), plane.left(plane.unit(plane.minus(end, start)))
    return found, where


def _column(foot: tuple[float, float], head: tuple[float, float]) -> Polyline:
    """A column, clamped at both ends: it bends as 3s² − 2s³."""
    points = []
    for i in range(STEPS + 1):
        s = i / STEPS
        points.append((foot[0] + (head[0] - foot[0]) * s * s * (3 - 2 * s), foot[1] + (head[1] - foot[1]) * s))
    return Polyline(tuple(points), width=2.4, layer=BEHIND)
