"""Springs whose stretch is all that is said of them, and is how far a body has moved along a line: each stands between
the body and a wall behind it."""

from math import hypot
from typing import TYPE_CHECKING

from vibcli.drawing.layout import plane
from vibcli.drawing.layout.sketch import Attachment
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.language.reader import Record
    from vibcli.symbolic.node import Node

LONG, CLOSE = 60.0, 1e-9        # points from the wall to the body; by which rates may differ


def prop(record: "Record", sketch: "Sketch") -> list[Attachment] | None:
    """[the wall, the place on the body] of a spring; None of one that stretches otherwise, or whose body is held by
    what has ends."""
    if record.element.name != "spring" or "torsion" in record or "stretch" not in record:
        return None
    slopes = _slopes(sketch.scene.lower(record["stretch"]), sketch)
    held = {end.carrier for one in sketch.spec.connections for end in map(sketch.attachment, one.get("between", ()))
            if end is not None and "torsion" not in one}
    for name, body in sketch.scene.bodies.items():
        if name not in sketch.frames or name in held or not slopes or _slopes(body.frame.angle, sketch).keys() & slopes:
            continue
        x, y = (_slopes(node, sketch) for node in body.frame.place)
        if (x.keys() | y.keys()) == slopes.keys() and len(slopes) == 1:
            q, rate = next(iter(slopes.items()))
            way = x.get(q, 0.0), y.get(q, 0.0)
            if abs(hypot(*way) - abs(rate)) < CLOSE and abs(abs(rate) - 1) < CLOSE:
                place = sketch.frames[name].drawn
                return [Attachment(None, plane.plus(place, way, -LONG * rate)), Attachment(name, place)]
    return None


def _slopes(node: "Node", sketch: "Sketch") -> "dict[Node, float]":
    """{coordinate: constant slope of an expression along it}; infinite where it is none."""
    found = {q: slope for q, slope in gradient(node).items() if q in sketch.scene.q and not slope.is_zero}
    steady = {q: slope for q, slope in found.items() if not slope.mask}
    values = evaluate(list(steady.values()), Floats, sketch.values)
    return dict.fromkeys(found, float("inf")) | dict(zip(steady, values, strict=True))
