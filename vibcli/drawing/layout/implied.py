"""Ropes that a scene does not name: a weight moves as the rim of a wheel below whose rim it is drawn, or as the centre
of a body to which it must then be tied."""

from collections.abc import Mapping, Sequence
from math import hypot
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.layout import plane
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch

CLOSE = 1e-6


class Implied(NamedTuple):
    """A rope from a wheel of this radius (0: from the centre of a body) to a weight, or to another wheel, which it
    meets on the same side at the distance `over` from its centre."""

    wheel: str
    radius: float
    weight: str
    over: float = 0.0
    side: tuple[float, float] | None = None


def ropes(sketch: "Sketch") -> list[Any]:
    """The Implied ropes of weights that no element ties to a moving body."""
    tied, rates, found = _tied(sketch), None, []
    for name, body in sketch.scene.bodies.items():
        slide = body.record.get("slide")
        if name not in sketch.frames or slide is None or name in tied or set(slide) & {"surface", "carrier"}:
            continue
        rates = rates or {other: rates_of(sketch, other) for other in sketch.frames if other in sketch.scene.bodies}
        others = [other for other in rates if other != name]
        if not any(plane.distance(sketch.centre(other), sketch.centre(name)) < CLOSE for other in others):
            found += [rope for other in others if (rope := _between(other, name, rates, sketch))][:1]
    pulleys = dict.fromkeys(rope.wheel for rope in found if rope.radius)
    return found + [rope for name in pulleys for rope in _onward(name, found, rates, sketch)]


def _onward(pulley: str, known: Sequence[Implied], rates: Mapping[str, Sequence[tuple[float, float, float]]],
            sketch: "Sketch") -> list[Implied]:
    """The rope over a pulley in a fixed axle, which hangs on no coordinate of its own, to the wheel that turns it."""
    weights = {rope.weight for rope in known}
    radius = sketch.rolling_radius(pulley)
    if not radius or any(hypot(x, y) > CLOSE for x, y, _ in rates[pulley]) or pulley in _tied(sketch):
        return []
    a = sketch.rim(pulley).drawn
    for other in rates:
        if other == pulley or other in weights or not any(turn for _, _, turn in rates[other]):
            continue
        for side in ((0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0)):
            e, b = plane.times(plane.left(side), -1), sketch.rim(other).drawn
            over = radius - plane.dot(plane.minus(b, a), side)
            if over > CLOSE and _is_wheel(other, over / sketch.scale, rates, sketch) and any(
                    hypot(*rate[:2]) > CLOSE for rate in rates[other]) and _taut(
                    pulley, other, rates, e, radius / sketch.scale, over / sketch.scale):
                return [Implied(pulley, radius, other, over, side)]
    return []


def _tied(sketch: "Sketch") -> set[str | None]:
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


def rates_of(sketch: "Sketch", name: str) -> list[tuple[float, float, float]]:
    """[(∂x/∂q, ∂y/∂q, ∂angle/∂q)] of the centre of a body's circle as drawn, one for each coordinate."""
    body, zero = sketch.scene.bodies[name], sketch.scene.table.zero
    rim = sketch.scene.rim(body, body.record.where)
    slopes = [gradient(node) for node in (*body.frame.point(*rim), body.frame.angle)]
    flat = evaluate([slope.get(q, zero) for q in sketch.scene.q for slope in slopes], Floats, sketch.values)
    return list(zip(flat[::3], flat[1::3], flat[2::3], strict=True))


def _between(wheel: str, weight: str, rates: Mapping[str, Sequence[tuple[float, float, float]]],
             sketch: "Sketch") -> Implied | None:
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
    if not offset or not _is_wheel(wheel, abs(offset), rates, sketch) or not _taut(wheel, weight, rates, e, offset):
        return None
    return Implied(wheel, abs(offset) * sketch.scale, weight)


def _is_wheel(name: str, offset: float, rates: Mapping[str, Sequence[tuple[float, float, float]]],
              sketch: "Sketch") -> bool:
    """Does a body turn, about its fixed centre or with a circle that reaches to a rope?"""
    moves = any(hypot(x, y) > CLOSE for x, y, _ in rates[name])
    reach = sketch.rolling_radius(name) / sketch.scale if moves else offset
    return any(turn for _, _, turn in rates[name]) and offset <= reach * (1 + CLOSE)


def _taut(one: str, two: str, rates: Mapping[str, Sequence[tuple[float, float, float]]], e: tuple[float, float],
          offset: float, over: float = 0.0) -> bool:
    """Do two bodies move equally fast along a line of direction e, `offset` to the left of the one's centre and `over`
    to the left of the other's? All places of a rigid body on a line have the same speed along it."""
    pairs = [(plane.dot(a[:2], e) - offset * a[2], plane.dot(b[:2], e) - over * b[2])
             for a, b in zip(rates[one], rates[two], strict=True)]
    return all(abs(a - b) <= CLOSE * max(abs(a), abs(b)) for a, b in pairs)
