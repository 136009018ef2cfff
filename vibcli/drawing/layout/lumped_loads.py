"""Loads on bodies in rows: their arrows, and the room that these take above the elements on the right of a body."""

from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import Circle, Polyline, Run
from vibcli.drawing.layout import captions, lettering, plane, tube
from vibcli.drawing.symbols import arrow

if TYPE_CHECKING:
    from vibcli.drawing.layout.lumped_place import Layout
    from vibcli.drawing.layout.rows import LumpedRow
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.language.reader import Record
    from vibcli.scene.scene import Scene

PUSH, ABOVE, SUNK, APART, MARGIN = 30.0, 17.0, 0.7, 14.0, 12.0


def _forces(name: str, scene: "Scene") -> "list[Record]":
    """The Records of the forces on a body, in the order of the file."""
    return [record for record in (scene.spec.get("forces") or {}).values()
            if "force" in record and getattr(record.get("at"), "text", None) == name]


def height(row: "LumpedRow", scene: "Scene") -> float:
    """How much higher bodies are, half of it, for arrows above the elements of a row."""
    counts = [len(_forces(name, scene)) for i, name in enumerate(row.bodies) if i + 1 in row.gaps]
    most = max(counts, default=0)
    return ABOVE + APART / 2 * (most - 1) if most else 0.0


def width(row: "LumpedRow", column: int, sketch: "Sketch") -> float:
    """The room for arrows, and their names behind them, in a gap of a row."""
    forces = _forces(row.bodies[column - 1], sketch.scene) if column else []
    return max((PUSH + MARGIN + lettering.size(_runs(record, "force", sketch))[0] for record in forces), default=0.0)


def _runs(record: "Record", key: str, sketch: "Sketch") -> tuple[Run, ...]:
    return captions.expression(record[key], sketch, 18) or lettering.named(record.name)


def draw(record: "Record", layout: "Layout",
         sketch: "Sketch") -> list[tuple[list[Any], tuple[Run, ...], list[Any], str]]:
    """[(primitives, runs, places for them, role)] of a load where it acts on a body of a row."""
    name = getattr(record.get("at", record.get("body")), "text", None)
    if name not in layout.places:
        return []
    place = layout.places[name]
    x, y = place.middle
    if "moment" in record:
        y += place.height + 22
        return [(arrow.over((x, y), "load", 1.7), _runs(record, "moment", sketch), [(x + 10, y + 6)], "load")]
    if "unbalance" in record:
        mass = (x + 8, y + 10)
        parts = [Polyline((place.middle, mass), "load"), Circle(mass, 2.3, "load", "load")]
        return [(parts, _runs(record, "unbalance", sketch), [mass], "load")]
    if layout.kind == "tube":
        parts, tip = tube.load_on(place)
        return [(parts, _runs(record, "force", sketch), [tip], "load")]
    down = APART * [one.name for one in _forces(name, sketch.scene)].index(record.name)
    start = (x + place.half, y + place.height - 5 - down)
    if layout.kind == "frame":
        start = (x - place.half - PUSH - 2, y - down)
    tip = plane.plus(start, (PUSH, 0.0))
    crowded = down or (layout.kind == "row" and layout.row.bodies.index(name) + 1 in layout.row.gaps)
    places = [plane.plus(tip, (2.0, 0.0))] if crowded else [plane.plus(start, (16.0, 3.0))]
    return [(arrow.straight(start, tip, "load", 1.7), _runs(record, "force", sketch), places, "load")]
