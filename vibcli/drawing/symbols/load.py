"""Loads: arrows of forces at the points where they act, round ones of moments; unbalances."""

from collections.abc import Mapping, Sequence
from math import hypot, pi
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import BODY, Circle, Polyline, Primitive, Run
from vibcli.drawing.layout import captions, lettering, plane
from vibcli.drawing.symbols import acting, arrow
from vibcli.symbolic.syntax import Sum

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Attachment, Sketch
    from vibcli.drawing.layout.space import Space
    from vibcli.drawing.symbols.look import Look
    from vibcli.language.reader import Record
    from vibcli.symbolic.node import Node

LENGTH = 32.0


def draw(record: "Record", sketch: "Sketch", looks: "Mapping[str, Look]",
         space: "Space") -> tuple[list[Any], tuple[Run, ...], list[tuple[float, float]]] | None:
    """(primitives, runs, places for them) of a load on what has a place; None of any other."""
    if "moment" in record:
        if "body" not in record or record["body"].text not in sketch.frames:
            return None             # that at a point of a member is drawn with it
        return _moment(record, sketch, looks, space)
    if "at" in record and (at := sketch.attachment(record["at"])) is not None:
        if "unbalance" in record:
            return _unbalance(record, at, sketch, space)
        return _force(record, at, sketch, looks, space)
    return None


def _force(record: "Record", at: "Attachment", sketch: "Sketch", looks: "Mapping[str, Look]",
           space: "Space") -> "tuple[list[Primitive], tuple[Run, ...], list[tuple[float, float]]]":
    fields = record["force"]
    direction = _direction([captions.raw(field, sketch.scene) for field in fields], sketch)
    if "carrier" in record:
        direction = sketch.frames[record["carrier"].text].turned(direction)
    place = sketch.now(at)
    here, there = (_leaves(place, plane.times(direction, sense), at.carrier, sketch, looks) for sense in (1, -1))
    paths = [(here, plane.plus(here, direction, LENGTH)), (plane.plus(there, direction, -LENGTH), there)]
    start, tip = min(paths, key=lambda path: space.arrow([plane.plus(path[0], direction, 5),
                                                          plane.plus(path[1], direction, -5)]))
    given = [field for field in fields if field.text.strip() not in ("0", "0 N")]
    runs = captions.expression(unsigned(given[0]), sketch, 18) if len(given) == 1 else None
    runs = runs or lettering.named(record.name)
    return arrow.straight(start, tip, "load", 1.7), runs, [plane.middle(start, tip), tip]


def _leaves(place: tuple[float, float], direction: tuple[float, float], carrier: str, sketch: "Sketch",
            looks: "Mapping[str, Look]") -> tuple[float, float]:
    """Where a direction from a place leaves the body that carries it, and what is welded to that there."""
    edges = {name: [sketch.frames[name].point(p) for p in look.core] for name, look in looks.items() if look.core}
    about = [edge for name, edge in edges.items()
             if name == carrier or (_carries(carrier, name, sketch) and plane.inside(place, edge))]
    return max((plane.leaves(place, direction, edge) for edge in about),
               key=lambda found: plane.dot(plane.minus(found, place), direction), default=place)


def _carries(carrier: str, name: str, sketch: "Sketch") -> bool:
    """Is a body welded to another?"""
    weld = sketch.scene.bodies[name].record.get("weld")
    return weld is not None and weld.text == carrier


def unsigned(field: Any) -> Any:
    """The field without a leading minus, for the length of an arrow that points the other way."""
    text = field.text.strip()
    if not text.startswith("-") or not isinstance(field.tree, Sum) or len(field.tree.parts) != 1:
        return field
    from vibcli.language.reader import Expression

    shorter = type(field.scalar)(text[1:].strip(), field.scalar.where)
    return Expression(shorter, field.tree.parts[0][1])


def _direction(nodes: "Sequence[Node]", sketch: "Sketch") -> tuple[float, float]:
    """The direction of a force as drawn, when it first acts."""
    (x, y), = acting.values(nodes, sketch)
    size = hypot(x, y)
    return (x / size, y / size) if size else (1.0, 0.0)


def _moment(record: "Record", sketch: "Sketch", looks: "Mapping[str, Look]",
            space: "Space") -> "tuple[list[Primitive], tuple[Run, ...], list[tuple[float, float]]]":
    name = record["body"].text
    pivot = sketch.pivot(name)
    centre = sketch.now(pivot) if pivot is not None else sketch.frames[name].point(sketch.centre(name))
    radius, start, end = _freest(centre, (19.0, 27.0, 35.0, 45.0), 1.15, space)
    runs = captions.expression(record["moment"], sketch, 18) or lettering.named(record.name)
    places = [plane.polar(centre, radius, end), plane.polar(centre, radius, (start + end) / 2)]
    return arrow.round_(centre, radius, start, end, "load", 1.7), runs, places


def _freest(centre: tuple[float, float], radii: tuple[float, ...], span: float,
            space: "Space") -> tuple[float, float, float]:
    """(radius, start, end) of the arc about a centre that crosses least; `span` in units of π."""
    arcs = [(radius, start * pi, (start + span) * pi) for radius in radii for start in (0.1, 0.6, -0.4, 1.1)]
    return min(arcs, key=lambda item: space.arrow(plane.arc(centre, *item)) / item[0] * 20 + item[0] / 20)


def _unbalance(record: "Record", at: "Attachment", sketch: "Sketch",
               space: "Space") -> "tuple[list[Primitive], tuple[Run, ...], list[tuple[float, float]]]":
    """A small mass on an arm that turns."""
    centre = sketch.now(at)
    mass = plane.polar(centre, 9.0, 0.3 * pi)
    radius, start, end = _freest(centre, (13.0, 17.0, 22.0, 28.0, 35.0), 0.6, space)
    found = [Polyline((centre, mass), "load", layer=BODY), Circle(mass, 2.3, "load", "load"),
             *arrow.round_(centre, radius, start, end, "load")]
    runs = captions.expression(record["unbalance"], sketch) or lettering.named(record.name)
    return found, runs, [plane.polar(centre, radius + 1, angle) for angle in (end, (start + end) / 2)]
