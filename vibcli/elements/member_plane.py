"""Members drawn in the plane: what their stations do along the line, their weight, and the tension that statics finds.

Bars are hinged at their ends and stay straight: u is linear in x, and a piece l of the length L lengthens by Δa along
the line and by its share l/L of √((L + ΔA)² + Δu²) − (L + ΔA), as the bar turns, so that tension stiffens it across.
Beams and strings keep their length as a link does: all of them moves along together, and where both ends are held to
what parts along the line, that is a condition.
"""

from typing import TYPE_CHECKING, Any

from vibcli.elements.member_line import Station
from vibcli.elements.member_pieces import add_across, add_piece, preload_of
from vibcli.elements.member_springs import mean_across, mean_along
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.elements.member import Member
    from vibcli.elements.member_places import PlaceAlong
    from vibcli.elements.member_segments import MemberSegment
    from vibcli.symbolic.node import Node


def placed(member: "Member", places: "Sequence[PlaceAlong]", held: "Sequence[Mapping[str, Node]]",
           scene: Any) -> "Member":
    """The Member with its Stations."""
    if member.kind.name == "bar":
        return member._replace(stations=_straight(member, places, held, scene))
    along, stretches = _along(member, places, held, scene)
    return member._replace(stations=[_station(member, place, motions, node, scene) for place, motions, node in zip(
        places, held, along, strict=True)], stretches=stretches)


def _straight(member, places, held, scene):
    """The Stations of a bar: between its ends u is linear in x."""
    first, last = (held[i]["u"] if "u" in held[i] else
                   scene.coordinates.further(f"{member.name}.u({places[i].text})") for i in (0, -1))
    found = []
    for place, motions in zip(places, held, strict=True):
        share = place.node / member.length
        u = first if place is places[0] else last if place is places[-1] else first + share * (last - first)
        along = motions["along"] if "along" in motions else scene.coordinates.further(
            f"{member.name}.along({place.text})")
        found.append(Station(place.node, place.text, u, along=along))
    return found


def _station(member, place, motions, along, scene):
    """A Station of a beam or string: what is not held is a coordinate."""
    named = ("u", "slope") if member.kind.bends else ("u",)
    found = {motion: motions[motion] if motion in motions else
             scene.coordinates.further(f"{member.name}.{motion}({place.text})") for motion in named}
    return Station(place.node, place.text, along=along, **found)


def _along(member, places, held, scene):
    """(motion along of each station, coordinates by which it may stretch) of what keeps its length."""
    left, right = (held[i].get("along") for i in (0, -1))
    base = left if left is not None else right
    if base is None:
        base = scene.coordinates.further(f"{member.name}.along({places[0].text})")
    tied = left is not None and right is not None and (right - left).mask
    if scene.variant.stretched:
        stretches = [None if "along" in motions else scene.coordinates.further(f"{member.name}.stretch {i}")
                     for i, motions in enumerate(held)]
        return [motions.get("along", base) if stretch is None else base + stretch
                for motions, stretch in zip(held, stretches, strict=True)], tuple(stretches)
    if tied:
        scene.add_constraint(member.record, right - left, "link")
    return [base] * len(places), ()


def add_placed_piece(member: "Member", segment: "MemberSegment", left: Station, right: Station, i: int,
                     scene: Any) -> None:
    """The i-th piece of a member in the plane: its springs, its inertia both ways, its weight."""
    length = right.place - left.place
    mass = segment.inertia * length
    if member.kind.name == "bar":
        _add_bar(member, segment, left, right, mass, scene)
        means = mean_along(scene, length, segment.stiffness, segment.foundation, (left.along, right.along)), (
            left.u + right.u) * HALF
    else:
        tension = scene.tension(member.name, i) or preload_of(member, scene)
        if member.kind.bends:
            add_across(segment, left, right, tension, scene)
            mean = mean_across(scene, length, segment.stiffness, tension, segment.foundation,
                               [*left.motions, *right.motions])
        else:
            if not scene.number(tension) > 0:
                scene.report(member.record.where, f"'{member.name}' is not taut: statics finds the tension "
                             f"{scene.number(tension):.6g} N in it", "let its loads, or a `preload`, pull it")
                return
            add_piece(segment, left, right, tension, [left.u, right.u], scene)
            mean = mean_along(scene, length, tension, segment.foundation, (left.u, right.u))
        scene.add_inertia(mass, right.along)
        means = right.along, mean
    if not mass.is_zero and scene.contents.gravity is not None:
        _add_weight(member, mass, (left.place + right.place) * HALF, means, scene)


def _add_bar(member, segment, left, right, mass, scene):
    """A piece of a bar with its share of what the bar lengthens as it turns; across it counts as a rigid rod."""
    first, last = member.stations[0], member.stations[-1]
    apart = member.length + (last.along - first.along)
    longer = scene.distance(apart, last.u - first.u) - apart
    add_piece(segment, left, right, segment.stiffness, [left.along, right.along], scene, preload_of(member, scene),
              (right.place - left.place) / member.length * longer)
    scene.add_inertia(mass, (left.u + right.u) * HALF)
    scene.add_inertia(mass / 12, right.u - left.u)


def _add_weight(member, mass, middle, means, scene):
    """The weight of a piece by the means of what it moves along and across."""
    (x, y), (dx, dy) = member.line.drawn(middle), member.line.displaced(*means)
    if member.kind.name != "bar":
        gx, gy = (scene.number(part) for part in scene.contents.gravity)
        pull = gx * scene.number(member.line.ex) + gy * scene.number(member.line.ey)
        if abs(pull) > 1e-12 * (gx * gx + gy * gy) ** 0.5:
            scene.report(member.record.where, f"the weight of '{member.name}' acts along it: tension that varies along "
                         "a member does not work yet", "draw it level, or leave `gravity` out")
    scene.add_weight(mass, x + dx, y + dy)
