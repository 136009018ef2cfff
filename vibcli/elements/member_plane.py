"""Members drawn in the plane: what their stations do along the line, their weight, and the tension that statics finds.

Bars are hinged at their ends and stay straight: u is linear in x, and a piece l of the length L lengthens by Δa along
the line and by its share l/L of √((L + ΔA)² + Δu²) − (L + ΔA), as the bar turns, so that tension stiffens it across.
Strings and beams without EA keep their length as a link does: all of them moves along together, and where both ends are
held to what parts along the line, that is a condition. A beam with EA stretches: along it is a bar.
"""

from typing import TYPE_CHECKING

from vibcli.elements.member_line import Station
from vibcli.elements.member_pieces import add_across, add_along, add_graded, add_piece, pieces_of, preload_of
from vibcli.elements.member_springs import mean_across, mean_along
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.elements.member import Member
    from vibcli.elements.member_places import PlaceAlong
    from vibcli.elements.member_segments import MemberSegment
    from vibcli.scene.builder import Builder
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SLACK = 2.0**-40        # of the largest tension of a string: an end with less has none


def placed(member: "Member", places: "Sequence[PlaceAlong]", held: "Sequence[Mapping[str, Node]]",
           scene: "Builder") -> "Member":
    """The Member with its Stations."""
    if member.kind.name == "bar":
        return member._replace(stations=_straight(member, places, held, scene))
    along, stretches = _along(member, places, held, scene)
    if member.name in scene.tensions and scene.tensions[member.name].shared and scene.parameters.free:
        scene.report(member.record.where, f"'{member.name}' and what its ends are held to share the loads: its tension "
                     "in letters does not work yet", "give every parameter a value, or leave out the loads")
    untold = scene.tie(member.name) is None and all("along" in held[i] for i in (0, -1))
    if member.kind.name == "string" and "preload" not in member.record and untold and scene.tensions:
        scene.report(member.record.where, f"nothing tells the tension of '{member.name}'", "give `preload: T`")
    slack = [places[i] for i in _slack(member, places, scene)]
    return member._replace(stations=[_station(member, place, motions, node, place in slack, scene) for
                                     place, motions, node in zip(places, held, along, strict=True)],
                           stretches=stretches)


def _straight(member: "Member", places: "Sequence[PlaceAlong]", held: "Sequence[Mapping[str, Node]]",
              scene: "Builder") -> list[Station]:
    """The Stations of a bar: between its ends u is linear in x."""
    first, last = (held[i]["u"] if "u" in held[i] else
                   scene.coordinates.further(f"{member.name}.across({places[i].text})") for i in (0, -1))
    found = []
    for place, motions in zip(places, held, strict=True):
        share = place.node / member.length
        u = first if place is places[0] else last if place is places[-1] else first + share * (last - first)
        along = motions["along"] if "along" in motions else scene.coordinates.further(
            f"{member.name}.u({place.text})")
        found.append(Station(place.node, place.text, u, along=along))
    return found


def _station(member: "Member", place: "PlaceAlong", motions: "Mapping[str, Node]", along: "Node", slack: bool,
             scene: "Builder") -> Station:
    """A Station of a beam or string: what is not held is a coordinate; at a `slack` end there is none to hold it by."""
    if slack:
        return Station(place.node, place.text, None, along=along)
    named = ("u", "slope") if member.kind.bends else ("u",)
    found = {motion: motions[motion] if motion in motions else
             scene.coordinates.further(f"{member.name}.{motion}({place.text})") for motion in named}
    return Station(place.node, place.text, along=along, **found)


def _along(member: "Member", places: "Sequence[PlaceAlong]", held: "Sequence[Mapping[str, Node]]",
           scene: "Builder") -> "tuple[list[Node], tuple[Node | None, ...]]":
    """(motion along of each station, coordinates by which it may be cut open) of beams and strings."""
    left, right = (held[i].get("along") for i in (0, -1))
    if member.stretching and not scene.variant.stretched:
        return [motions["along"] if "along" in motions else scene.coordinates.further(
            f"{member.name}.along({place.text})") for place, motions in zip(places, held, strict=True)], ()
    base = left if left is not None else right
    if base is None:
        base = scene.coordinates.further(f"{member.name}.along({places[0].text})")
    tied = left is not None and right is not None and (right - left).mask
    if scene.variant.stretched or (scene.variant.opened and not member.stretching):
        stretches = [None if "along" in motions else scene.coordinates.further(f"{member.name}.stretch {i}")
                     for i, motions in enumerate(held)]
        return [motions.get("along", base) if stretch is None else base + stretch
                for motions, stretch in zip(held, stretches, strict=True)], tuple(stretches)
    if tied and not member.stretching:
        scene.add_constraint(member.record, right - left, "link")
    return [base] * len(places), ()


def add_placed_pieces(member: "Member", scene: "Builder") -> None:
    """Add the pieces of a member in the plane."""
    for i, (segment, left, right) in enumerate(pieces_of(member, scene)):
        _add_placed(member, segment, left, right, i, scene)


def _add_placed(member: "Member", segment: "MemberSegment", left: Station, right: Station, i: int,
                scene: "Builder") -> None:
    """The i-th piece of a member in the plane: its springs, its inertia both ways, its weight."""
    length = right.place - left.place
    mass = segment.inertia * length
    if member.kind.name == "bar":
        _add_bar(member, segment, left, right, mass, scene)
        means = mean_along(scene, length, segment.stiffness, segment.foundation, (left.along, right.along)), (
            left.u + right.u) * HALF
    else:
        across = _cut if scene.variant.stretched else _add_taut
        means = (_add_along(member, segment, left, right, mass, scene),
                 across(member, segment, left, right, i, scene))
    if not mass.is_zero and scene.contents.gravity is not None:
        (x, y), (dx, dy) = (member.line.drawn((left.place + right.place) * HALF), member.line.displaced(*means))
        scene.add_weight(mass, x + dx, y + dy)


def _add_along(member: "Member", segment: "MemberSegment", left: Station, right: Station, mass: "Node",
               scene: "Builder") -> "Node":
    """What a piece of a beam or string does along the line; the motion by which its weight acts."""
    if member.stretching and not scene.variant.stretched:
        add_along(member, segment, left, right, scene)
        return (left.along + right.along) * HALF
    scene.add_inertia(mass, right.along)
    return right.along


def _cut(_member: "Member", _segment: "MemberSegment", left: Station, right: Station, _i: int,
         _scene: "Builder") -> "Node":
    """What bends plays no part in the tension."""
    return (left.u + right.u) * HALF


def _add_taut(member: "Member", segment: "MemberSegment", left: Station, right: Station, i: int,
              scene: "Builder") -> "Node":
    """A piece of a beam or string under the tension that statics finds; its mean displacement across."""
    length = right.place - left.place
    tension = scene.tension(member.name, i) or preload_of(member, scene)
    gradient = tension_gradient(member, segment, scene)
    if _is_sought(member, scene) and not _is_taut(left, right, tension, gradient * length, scene):
        tension = 1 + scene.absolute(gradient * length)
    member.tensions.append((tension, gradient, length))
    if member.kind.bends:
        if not gradient.is_zero:
            return add_graded(f"{member.name}.{i + 1}", segment, left, right, tension, gradient, scene)
        add_across(segment, left, right, tension, scene)
        return mean_across(scene, length, segment.stiffness, tension, segment.foundation,
                           [*left.motions, *right.motions])
    ends = [scene.table.zero if station.u is None else station.u for station in (left, right)]
    if not _is_taut(left, right, tension, gradient * length, scene):
        least = min(scene.number(node) for node in (tension, tension + gradient * length))
        scene.report(member.record.where, f"'{member.name}' is not taut: statics finds the tension {least:.6g} N in it",
                     "give more `preload`" if "preload" in member.record and scene.tie(member.name) is None else
                     "let its loads pull it")
    elif not gradient.is_zero and not segment.foundation.is_zero:
        scene.report(member.record.where, f"the tension of '{member.name}' varies along it, and it rests on a "
                     "foundation: this does not work yet", "leave out the weight or the foundation")
    else:
        add_piece(segment, left, right, tension, ends, scene, gradient=gradient)
        return mean_along(scene, length, tension, segment.foundation, ends, gradient)
    return scene.table.zero


def _is_taut(left: Station, right: Station, tension: "Node", change: "Node", scene: "Builder") -> bool:
    """Is a piece of a string pulled all along, but for a slack end?"""
    least, most = sorted(scene.number(node) for node in (tension, tension + change))
    return least > 0 or (most > 0 and None in (left.u, right.u))


def _is_sought(member: "Member", scene: "Builder") -> bool:
    """Is the tension of a string that of an equilibrium yet to be found, so that any will do?"""
    given = scene.variant.tensions
    return (member.kind.name == "string" and given is not None and member.name not in given
            and not scene.parameters.free and scene.tie(member.name) is not None)


def tension_gradient(member: "Member", segment: "MemberSegment", scene: "Builder | Scene") -> "Node":
    """N′ = −μ g·e, the weight along the line."""
    zero = scene.table.zero
    if scene.contents.gravity is None or segment.inertia.is_zero:
        return zero
    (gx, gy), line = scene.contents.gravity, member.line
    along = textbook(gx * line.ex + gy * line.ey)
    size = abs(scene.number(gx)) + abs(scene.number(gy))
    return zero if abs(scene.number(along)) <= 1e-12 * size else -segment.inertia * along


def _slack(member: "Member", places: "Sequence[PlaceAlong]", scene: "Builder") -> list[int]:
    """The ends, 0 or -1, of a string that bear no tension: free ones, where its weight hangs or has not begun."""
    if member.kind.name != "string" or member.name not in scene.tensions or _is_sought(member, scene):
        return []
    first, last = (scene.tension(member.name, i) for i in (0, -1))
    last = last + tension_gradient(member, member.segments[-1], scene) * (places[-1].node - places[-2].node)
    sizes = [abs(scene.number(node)) for node in (first, last)]
    return [i for i, size in zip((0, -1), sizes, strict=True) if size <= SLACK * max(sizes)]


def _add_bar(member: "Member", segment: "MemberSegment", left: Station, right: Station, mass: "Node",
             scene: "Builder") -> None:
    """A piece of a bar with its share of what the bar lengthens as it turns; across it counts as a rigid rod."""
    first, last = member.stations[0], member.stations[-1]
    apart = member.length + (last.along - first.along)
    longer = scene.distance(apart, last.u - first.u) - apart
    add_piece(segment, left, right, segment.stiffness, [left.along, right.along], scene, preload_of(member, scene),
              (right.place - left.place) / member.length * longer)
    scene.add_inertia(mass, (left.u + right.u) * HALF)
    scene.add_inertia(mass / 12, right.u - left.u)
