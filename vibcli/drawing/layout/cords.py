"""Cords that a scene does not name: the stretch of an element, which is all that is said of it, is that of a cord which
a rolling wheel winds up."""

from math import hypot
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.sketch import Attachment, CordEnd
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.language.reader import Record
    from vibcli.symbolic.node import Node

CLOSE = 1e-6
FREE, LONG = 1.5, 1.6       # lengths of the cord from the wheel to the element, and of this, in radii of the wheel


class Cord(NamedTuple):
    """An element, the wheel whose cord it stretches, on which radius on paper and in which sense it is wound; where the
    cord ends, and the fixed end of the element."""

    record: "Record"
    wheel: str
    radius: float
    sense: int
    end: Attachment
    wall: Attachment


def cords(sketch: "Sketch") -> list[Cord]:
    """The Cords of a scene; their ends are places of the sketch from now on."""
    alone = [record for record in sketch.spec.connections if "stretch" in record and "between" not in record]
    return [cord for record in alone if (cord := _cord(record, sketch)) is not None]


def _cord(record: "Record", sketch: "Sketch") -> Cord | None:
    """The Cord that an element stretches as far as it says, None where there is none.

    A cord in the direction d leaves a wheel, whose centre moves by v and which turns by ω, at a distance o to the left
    of the centre; s being the stretch, ds/dq = −(v·d − o ω).
    """
    stretch = sketch.scene.lower(record["stretch"])
    slopes = {q: slope for q, slope in gradient(stretch).items() if q in sketch.scene.q}
    if len(slopes) != 1 or (slope := next(iter(slopes.values()))).mask:
        return None
    rate, = evaluate([slope], Floats, sketch.values)
    for name in sketch.frames:
        radius = sketch.rolling_radius(name)
        moves = _rolls(sketch, name, next(iter(slopes))) if radius else None
        if moves is None:
            continue
        (x, y, turn), speed = moves, hypot(*moves[:2])
        for sign in (1, -1):
            d = (-sign * x / speed, -sign * y / speed)
            offset = (rate - sign * speed) / turn * sketch.scale
            if CLOSE * radius < abs(offset) <= radius * (1 + CLOSE):
                return _placed(record, sketch, name, d, offset, stretch)
    return None


def _rolls(sketch: "Sketch", name: str, q: "Node") -> list[float] | None:
    """How a body that rolls moves with a coordinate alone: (∂x/∂q, ∂y/∂q, ∂angle/∂q) of its centre; None of others."""
    body, zero = sketch.scene.bodies.get(name), sketch.scene.table.zero
    if body is None or "roll" not in body.record:
        return None
    rim = sketch.scene.rim(body, body.record.where)
    slopes = [gradient(node) for node in (*body.frame.point(*rim), body.frame.angle)]
    if any(set(slope) & set(sketch.scene.q) - {q} for slope in slopes):
        return None
    found = evaluate([slope.get(q, zero) for slope in slopes], Floats, sketch.values)
    return found if hypot(*found[:2]) > CLOSE and abs(found[2]) > CLOSE else None


def _placed(record: "Record", sketch: "Sketch", wheel: str, d: tuple[float, float], offset: float,
            stretch: Any) -> Cord:
    """The Cord that leaves a wheel in a direction, so far to the left of its centre."""
    side, far = plane.left(d), sketch.rolling_radius(wheel)
    contact = plane.plus(sketch.rim(wheel).drawn, side, offset)
    end, wall = plane.plus(contact, d, FREE * far), plane.plus(contact, d, (FREE + LONG) * far)
    carrier = f"cord of {record.name}"      # which no body can be called
    sketch.hold(CordEnd(carrier, end, plane.times(d, -1), stretch))
    return Cord(record, wheel, abs(offset), -1 if offset > 0 else 1, Attachment(carrier, end, True),
                Attachment(None, wall))
