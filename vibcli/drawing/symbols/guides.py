"""Guides that a scene does not name: an end of a rod that expressions move keeps to a level or upright line."""

from typing import TYPE_CHECKING, Any

from vibcli.drawing.layout import plane
from vibcli.drawing.symbols import support
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.drawing.canvas.primitives import Primitive
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.elements.rigid_body import Body

SHIFTS = 0.11, -0.17, 0.29      # of each coordinate, at which an end is on its guide if it has one
CLOSE, HALF, END = 1e-9, 46.0, 6.0     # of a length; points of a guide to either side of an end, beyond it at least


def draw(sketch: "Sketch") -> list[Any]:
    """Rollers and pieces of ground at the ends of rods, in scenes without constraints."""
    found: list[Any] = []
    if sketch.spec.get("constraints"):
        return found
    for name, body in sketch.scene.bodies.items():
        if name in sketch.frames and "move" in body.record and body.record.get("shape") == "rod":
            for key in ("from", "to"):
                found += _guide(body, sketch.pair(body.record[key]), sketch)
    return found


def _guide(body: "Body", end: tuple[float, float], sketch: "Sketch") -> "list[Primitive]":
    """What an end slides along, on the side where the rod is not; nothing where it moves otherwise, or rests."""
    places = [_place(body, end, shift, sketch) for shift in (0.0, *SHIFTS)]
    room = CLOSE * (1.0 + max(abs(x) for place in places for x in place))
    still = [max(abs(place[k] - places[0][k]) for place in places) < room for k in (0, 1)]
    if still.count(True) != 1:
        return []
    away = plane.minus(end, sketch.centre(body.name))
    outward = (1.0 if away[0] > 0 else -1.0, 0.0) if still[0] else (0.0, 1.0 if away[1] > 0 else -1.0)
    now = sketch.frames[body.name].point(end)
    ground = plane.plus(end, outward, 2 * support.ROLLER)
    return [*support.roller(plane.plus(now, outward, support.ROLLER)),
            *support.floor(ground, plane.left(outward), max(HALF, END + plane.distance(now, end)))]


def _place(body: "Body", end: tuple[float, float], shift: float, sketch: "Sketch") -> tuple[float, float]:
    """Where an end is, with all coordinates farther by `shift`."""
    moved = {q.name: sketch.values[q.name] + shift for q in sketch.scene.q}
    x0, y0, x, y, angle = evaluate([*body.frame.drawn, *body.frame.place, body.frame.angle], Floats,
                                   {**sketch.values, **moved})
    arm = plane.turned(plane.minus(end, (x0 * sketch.scale, y0 * sketch.scale)), angle)
    return plane.plus((x * sketch.scale, y * sketch.scale), arm)
