"""Ropes and belts: tangents between circles, arcs around them."""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import sqrt, tau
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.canvas.primitives import Polyline
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.sketch import Attachment, Sketch
from vibcli.drawing.layout.ties import SIDES, Ties
from vibcli.drawing.symbols import support

if TYPE_CHECKING:
    from vibcli.drawing.layout.cords import Cord
    from vibcli.drawing.layout.implied import Implied
    from vibcli.drawing.layout.standing import Standing
    from vibcli.drawing.symbols.look import Look
    from vibcli.language.reader import Record

ROOM = -0.3     # the cosine of the angle between two pieces of a rope, between which there is room
NORMAL = dict(zip(SIDES, ((0, 1), (0, -1), (-1, 0), (1, 0)), strict=True))


class DrawnStop(NamedTuple):
    """A place that a rope passes or ends at: its radius, the sense in which the rope goes round it (0 at a place)."""

    at: Attachment
    radius: float = 0.0
    sense: int = 0


def ropes(sketch: Sketch, looks: "Mapping[str, Look]", ties: Ties) -> dict[str, list[DrawnStop]]:
    """{name: the Stops} of the ropes of a scene, named and not."""
    found = {name: stops(record, sketch, looks)
             for name, record in (sketch.spec.get("constraints") or {}).items() if "rope" in record}
    for number, rope in enumerate(ties.implied):
        found[f"implied {number}"] = implied(rope, sketch, looks)
    found |= {f"standing {rope.wheel}": standing(rope, sketch) for rope in ties.standing}
    return found | {cord.end.carrier: wound(cord, sketch) for cord in ties.cords}


def ends(ropes: Mapping[str, Sequence[DrawnStop]], sketch: Sketch) -> list[tuple[Attachment, tuple[float, float]]]:
    """[(where a rope ends, the direction in which it would go on)]."""
    found = []
    for chain in ropes.values():
        for stop, other in ((chain[0], chain[1]), (chain[-1], chain[-2])):
            if not stop.sense:
                free = draw([stop, other], sketch)[0].points
                found.append((stop.at, plane.unit(plane.minus(free[0], free[1]))))
    return found


def stops(record: "Record", sketch: Sketch, looks: "Mapping[str, Look]") -> list[DrawnStop]:
    """The Stops of a rope as drawn."""
    raw: list[Any] = []
    for item in record["rope"]:
        if not hasattr(item, "values"):
            raw.append((sketch.attachment(item), 0.0, None))
        else:
            side = next(side for side in SIDES if side in item)
            radius = (sketch.length(item["radius"]) if "radius" in item else
                      sketch.rolling_radius(getattr(item[side], "text", None)))
            raw.append((sketch.rim(item[side]), radius, NORMAL[side]))
    found = []
    for i, (at, radius, side) in enumerate(raw):
        before, after = raw[max(i - 1, 0)], raw[min(i + 1, len(raw) - 1)]
        travel = plane.minus(_contact(after), _contact(before)) if i not in (0, len(raw) - 1) else plane.minus(
            after[0].drawn, before[0].drawn)
        sense = 0 if side is None or not radius else 1 if plane.across(side, travel) > 0 else -1
        found.append(DrawnStop(at, radius, sense))
    last = found[-2]._replace(sense=-found[-2].sense)
    return [_edge(found[0], found[1], looks), *found[1:-1], _edge(found[-1], last, looks)]


def _edge(stop: DrawnStop, other: DrawnStop, looks: "Mapping[str, Look]") -> DrawnStop:
    """The end of a rope where it meets a body."""
    look = looks.get(stop.at.carrier)
    if stop.sense or look is None or look.core is None or not plane.inside(stop.at.drawn, look.core):
        return stop
    ends = _tangent(stop.at.drawn, stop, other.at.drawn, other)
    direction = plane.unit(plane.minus(ends[1], ends[0]))
    return stop._replace(at=Attachment(stop.at.carrier, plane.leaves(stop.at.drawn, direction, look.core)))


def _contact(raw: tuple[Attachment, float, tuple[int, int] | None]) -> tuple[float, float]:
    at, radius, side = raw
    return plane.plus(at.drawn, side, radius) if side else at.drawn


def _tangent(a: tuple[float, float], one: DrawnStop, b: tuple[float, float],
             two: DrawnStop) -> tuple[tuple[float, float], tuple[float, float]]:
    """Where the free piece between two circles leaves one and meets the other."""
    w = plane.minus(b, a)
    square = plane.dot(w, w)
    rho = one.sense * one.radius - two.sense * two.radius
    free = sqrt(max(square - rho * rho, 0.0))
    if not square:
        return a, b
    ex, ey = (free * w[0] - rho * w[1]) / square, (free * w[1] + rho * w[0]) / square
    return (plane.plus(a, (ey, -ex), one.sense * one.radius), plane.plus(b, (ey, -ex), two.sense * two.radius))


def implied(found: "Implied", sketch: Sketch, looks: "Mapping[str, Look]") -> list[DrawnStop]:
    """The Stops of a rope that the motions imply."""
    wheel, weight = sketch.rim(found.wheel), Attachment(found.weight, sketch.centre(found.weight))
    offset = plane.minus(weight.drawn, wheel.drawn)
    if found.side is not None:
        other = sketch.rim(found.weight)
        sense = 1 if plane.across(found.side, plane.minus(other.drawn, wheel.drawn)) > 0 else -1
        return [DrawnStop(wheel, found.radius, sense), DrawnStop(other, found.over, sense)]
    if not found.radius:
        return [DrawnStop(wheel), _edge(DrawnStop(weight), DrawnStop(wheel), looks)]
    turn = 1 if abs(abs(offset[0]) - found.radius) < abs(abs(offset[1]) - found.radius) else 0
    side = (offset[0], 0.0) if turn else (0.0, offset[1])
    sense = 1 if plane.across(side, plane.minus(offset, side)) > 0 else -1
    start = DrawnStop(wheel, found.radius, sense)
    return [start, _edge(DrawnStop(weight), start._replace(sense=-sense), looks)]


def standing(found: "Standing", sketch: Sketch) -> list[DrawnStop]:
    """The Stops of a rope from a fixed place about a wheel that goes up and down along it."""
    stops = [DrawnStop(Attachment(None, found.top)), DrawnStop(sketch.rim(found.wheel), found.radius, found.sense)]
    return stops if found.weight is None else [*stops, DrawnStop(Attachment(found.weight, sketch.centre(found.weight)))]


def wound(cord: "Cord", sketch: Sketch) -> list[DrawnStop]:
    """The Stops of a cord that a wheel winds up."""
    return [DrawnStop(sketch.rim(cord.wheel), cord.radius, cord.sense), DrawnStop(cord.end)]


def draw(chain: Sequence[DrawnStop], sketch: Sketch, role: str = "rope", closed: bool = False) -> list[Any]:
    """The primitives of a rope through Stops."""
    places = [sketch.now(stop.at) for stop in chain]
    found, ends = [], []
    for (a, one), (b, two) in pairwise(zip(places, chain, strict=True)):
        ends.append(_tangent(a, one, b, two))
        found.append(Polyline(ends[-1], role, 1.4))
    corners = list(zip(ends, ends[1:], places[1:-1], chain[1:-1], strict=False))
    if closed:
        corners.append((ends[-1], ends[0], places[0], chain[0]))
    for arriving, leaving, centre, stop in corners:
        if stop.sense:
            start = plane.heading(plane.minus(arriving[1], centre))
            turn = stop.sense * (plane.heading(plane.minus(leaving[0], centre)) - start) % tau
            if turn < tau - 1e-6:
                arc = plane.arc(centre, stop.radius, start, start + stop.sense * turn)
                found.append(Polyline(tuple(arc), role, 1.6))
    return found


def held(chain: Sequence[DrawnStop], sketch: Sketch) -> list[Any]:
    """What holds the fixed pegs of a rope: between its two pieces where there is room, else beyond them."""
    found = []
    for before, stop, after in zip(chain, chain[1:], chain[2:], strict=False):
        if not stop.radius and sketch.is_fixed(stop.at.carrier):
            one, two = (plane.unit(plane.minus(other.at.drawn, stop.at.drawn)) for other in (before, after))
            inward = plane.unit(plane.plus(one, two), (0.0, 1.0))
            side = 1.0 if plane.dot(one, two) < ROOM else -1.0
            found += support.bearing(sketch.now(stop.at), plane.times(inward, side))
    return found


def belt(record: "Record", sketch: Sketch) -> list[Any]:
    """A belt round two wheels that have a place."""
    ends = [sketch.rim(name) for name in record["belt"]]
    if None in ends:
        return []
    radii = [sketch.length(radius) for radius in record.get("radii", ())] or [
        sketch.rolling_radius(name.text) for name in record["belt"]]
    second = -1 if record.get("crossed") else 1
    chain = [DrawnStop(ends[0], radii[0], 1), DrawnStop(ends[1], radii[1], second), DrawnStop(ends[0], radii[0], 1)]
    return draw(chain, sketch, "belt", closed=True)
