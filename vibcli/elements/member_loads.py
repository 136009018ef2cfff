"""Loads spread along members: what they put on the stations, by virtual work with the deflection between them.

On a piece without tension that is no string, or a bar or shaft, Σ Fᵢ δsᵢ with Fᵢ = ∫ q Nᵢ dx, Nᵢ linear, of beams
Hermite's cubics, integrated by parts. An even load acts on the mean deflection, under tension and on foundations too.
Pieces without inertia and drag deflect at all times as at rest, under what varies in time too; on all others that is a
SpreadForce.
"""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.elements.graded_beam import graded_mean
from vibcli.elements.loaded_rest import by_parts, end_forces
from vibcli.elements.member_pieces import pieces_of
from vibcli.elements.member_places import ROUNDING
from vibcli.elements.member_springs import mean_across, mean_along
from vibcli.elements.rest_shapes import RestPiece
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.separated_products import products_of
from vibcli.symbolic.smooth_panels import NotSmooth

if TYPE_CHECKING:
    from vibcli.base.errors import Where
    from vibcli.elements.member import Member
    from vibcli.elements.member_line import Station
    from vibcli.elements.member_segments import MemberSegment
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node


class SpreadLoad(NamedTuple):
    """The load q per length of an element `owner` on a member, from one place to another, steady; x is the place in
    it, in_time what varies in time besides."""

    owner: str
    member: str
    start: "Node"
    end: "Node"
    q: "Node"
    in_time: "Node"
    x: "Node"
    where: "Where"

    @property
    def even(self) -> bool:
        """Is it the same all along?"""
        return not (self.q.mask | self.in_time.mask) & self.x.mask


def add_spread_load(record: "Record", member: "Member", scene: "Builder") -> None:
    """Add the load of a record, per length of a member."""
    table = scene.table
    x = table.variable("the place")
    q, in_time = scene.load(record["per_length"], ("x", x))
    if any(node.mask and node is not x and node is not scene.time for node in (*gradient(q), *gradient(in_time))):
        scene.report(record["per_length"].where, "a load along a member depends on the place and the time alone",
                     "write it in x and t")
        return
    in_time = scene.terms_with(in_time)     # of 1 + x cos t the integral by x has cos t in no denominator
    start = scene.lower(record["from"]) if "from" in record else table.zero
    end = scene.lower(record["to"]) if "to" in record else member.length
    load = SpreadLoad(record.name, member.name, start, end, q, in_time, x, record.where)
    scene.contents.spread_loads.append(load)
    low, high = scene.number(start), scene.number(end)
    if not low < high:
        scene.report(record.where, f"'{record.name}' acts from {low:.6g} m to {high:.6g} m", "`from` is left of `to`")
        return
    hanging = _hanging(member, low, high, scene)
    vibrates = bool(hanging)
    for first, last, station in hanging if not q.is_zero else ():
        if not load.even:
            _on_slack_end(record, scene)
            return
        scene.add_force(q * (last - first), table.zero, member.motions(station)[0], resting=True)
    for i, (segment, left, right) in enumerate(pieces_of(member, scene)):
        middle = (scene.number(left.place) + scene.number(right.place)) / 2
        if low < middle < high:
            is_light = segment.inertia.is_zero and segment.drag.is_zero
            vibrates = vibrates or not is_light
            _on_piece(record, load, member, i, (segment, left, right), is_light, scene)
    if vibrates:
        _vibrating(record, load, scene)


def _hanging(member: "Member", low: float, high: float, scene: "Builder") -> "list[tuple[Node, Node, Station]]":
    """[(start, end, the Station that it hangs on)] of what a load acts on between a station and an end without
    tension; where a load begins or ends is a station."""
    first, last, slack = member.stations[0], member.stations[-1], ROUNDING * scene.number(member.length)
    beyond = (scene.table.zero, first.place, first), (last.place, member.length, last)
    return [(start, end, station) for start, end, station in beyond
            if min(high, scene.number(end)) - max(low, scene.number(start)) > slack]


def _vibrating(record: "Record", load: SpreadLoad, scene: "Builder") -> None:
    """Add the SpreadForces of what varies in time; of a steady load one that rests, beside which an input stands."""
    found = [(load.q, scene.table.zero)]
    if not load.in_time.is_zero:
        found = products_of(load.in_time, load.x, scene.time)
    if found is None:
        scene.report(record["per_length"].where, "this load is no sum of products f(x)*g(t) of what varies along a "
                     "member and what varies in time", "write it as such a sum, as in q0*sin(pi*x/L)*cos(Omega*t)")
        return
    for along, moving in found:
        scene.add_spread_force(load.member, load.start, load.end, along, moving, load.x)


def _on_piece(record: "Record", load: SpreadLoad, member: "Member", i: int,
              placed: "tuple[MemberSegment, Station, Station]", is_light: bool, scene: "Builder") -> None:
    segment, left, right = placed
    load = load if is_light else load._replace(in_time=scene.table.zero)
    if load.q.is_zero and load.in_time.is_zero:
        return
    tension = member.tension(i, segment, scene)
    length = right.place - left.place
    ends = [*member.motions(left), *member.motions(right)]
    piece = RestPiece(length, member.kind.bends, segment.stiffness, *tension, segment.foundation)
    if load.even:
        mean = _mean(scene, f"{member.name}.{i + 1}", piece, ends)
        scene.add_force(load.q * length, load.in_time * length, mean, not is_light)
        return
    xi = scene.table.variable("the place on a piece")
    try:
        for part, in_time in ((load.q, False), (load.in_time, True)):
            for end, force in zip(ends, _put(scene, piece, part, left.place, load, xi), strict=True):
                parts = (scene.table.zero, force) if in_time else (force, scene.table.zero)
                scene.add_force(*parts, end, not is_light)
    except NotSmooth as error:
        scene.report(record["per_length"].where, f"'{record.name}' {error.message}", error.hint)


def _mean(scene: "Builder", owner: str, piece: RestPiece, ends: "list[Node]") -> "Node":
    """∫ u dx/l without loads of its own, by which loads spread evenly act."""
    length, bends, *stiff = piece
    if piece.graded:
        return graded_mean(scene, owner, piece.numbers, ends)
    B, tension, gradient, foundation = stiff
    if bends:
        return mean_across(scene, length, B, tension, foundation, ends)
    return mean_along(scene, length, tension, foundation, ends, gradient)


def _put(scene: "Builder", piece: RestPiece, part: "Node", start: "Node", load: SpreadLoad, xi: "Node") -> "list[Node]":
    """What a part of a load puts on the ends of a piece from `start` on."""
    if part.is_zero:
        return [part] * (4 if piece.bends else 2)
    counted, = substitute([part], {load.x: start + xi})
    whole = by_parts(scene, piece, counted, xi) if piece.plain else None
    if whole is not None:
        return whole
    found = products_of(counted, xi, scene.time)
    if found is None:
        raise NotSmooth("is no sum of products f(x)*g(t) of what varies along a member and what varies in time",
                        "write it as such a sum, as in q0*sin(pi*x/L)*cos(Omega*t)")
    rows = end_forces(scene, piece, [along for along, _ in found], xi)
    return [scene.table.total([moving * row[i] for (_, moving), row in zip(found, rows, strict=True)])
            for i in range(len(rows[0]))]


def _on_slack_end(record: "Record", scene: "Builder") -> None:
    scene.report(record["per_length"].where, "a steady load that is uneven next to an end of a string that bears no "
                 "tension is not found", "let it act evenly, or let forces act at points of the string")
