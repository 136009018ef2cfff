"""Ropes that a scene does not name: a weight moves as the rim of a wheel below whose rim it is drawn, or as the centre
of a body to which it must then be tied."""

from math import hypot
from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.drawing.layout import plane
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch

CLOSE = 1e-6


class Implied(NamedTuple):
    """A rope from a wheel of this radius (0: from the centre of a body) to a weight."""

    wheel: str
    radius: float
    weight: str


def ropes(sketch: "Sketch") -> list[Any]:
    """The Implied ropes of weights that no element ties to a moving body."""
    tied, rates, found = _tied(sketch), None, []
    for name, body in sketch.scene.bodies.items():
        slide = body.record.get("slide")
        if name not in sketch.frames or slide is None or name in tied or set(slide) & {"surface", "carrier"}:
            continue
        rates = rates or {other: _rates(sketch, other) for other in sketch.frames if other in sketch.scene.bodies}
        others = [other for other in rates if other != name]
        if not any(plane.distance(sketch.centre(other), sketch.centre(name)) < CLOSE for other in others):
            found += [rope for other in others if (rope := _between(other, name, rates, sketch))][:1]
    return found


def _tied(sketch):
    """Bodies at the ends of ropes, links and joints, and of elements whose other end moves."""
    names = set()
    for record in (sketch.spec.get("constraints") or {}).values():
        for key in ("rope", "link", "join"):
            names.update(getattr(end, "text", None) for end in record.get(key, ()))
    for record in sketch.spec.connections:
        ends = [sketch.attachment(end) for end in record.get("between", ())]
        if len(ends) == 2 and None not in ends and not any(sketch.is_fixed(end.carrier) for end in ends):
            names.update(end.carrier for end in ends if sketch.scene.bodies.get(end.carrier) is not None
                         and sketch.scene.bodies[end.carrier].mass is not None)
    return names


def _rates(sketch, name):
    """[(∂x/∂q, ∂y/∂q, ∂angle/∂q)] of the centre of a body's circle as drawn, one for each coordinate."""
    body, zero = sketch.scene.bodies[name], sketch.scene.table.zero
    rim = sketch.scene.rim(body, body.record.where)
    slopes = [gradient(node) for node in (*body.frame.point(*rim), body.frame.angle)]
    flat = evaluate([slope.get(q, zero) for q in sketch.scene.q for slope in slopes], Floats, sketch.values)
    return [tuple(flat[i:i + 3]) for i in range(0, len(flat), 3)]


def _between(wheel, weight, rates, sketch):
    """The rope between a wheel and a weight, None where they do not move as if there were one."""
    a, b = sketch.rim(wheel).drawn, sketch.centre(weight)
    moving = [(rate, mine) for rate, mine in zip(rates[wheel], rates[weight], strict=True) if hypot(*mine[:2])]
    if not moving:
        return None
    e = plane.unit(moving[0][1][:2])
    if all(hypot(rate[0] - mine[0], rate[1] - mine[1]) < CLOSE * hypot(*mine[:2]) for rate, mine in moving):
        straight = abs(plane.across(e, plane.unit(plane.minus(b, a)))) < CLOSE
        alone = any(hypot(*rate[:2]) and not hypot(*mine[:2])
                    for rate, mine in zip(rates[wheel], rates[weight], strict=True))
        return Implied(wheel, 0.0, weight) if straight and not alone and abs(e[1]) > 0.5 else None
    offset = plane.across(e, plane.minus(b, a)) / sketch.scale
    for (x, y, turn), mine in moving:
        speed = plane.dot(mine[:2], e)
        if hypot(x, y) or not turn or abs(speed + offset * turn) > CLOSE * abs(speed):
            return None
    return Implied(wheel, abs(offset) * sketch.scale, weight)
