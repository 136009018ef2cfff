"""Loads spread along members: what they put on the stations, by virtual work with the deflection between them.

On a piece without tension that is no string, or a bar or shaft, Σ Fᵢ δsᵢ with Fᵢ = ∫ q Nᵢ dx, Nᵢ linear, of beams
Hermite's cubics, integrated by parts. An even load acts on the mean deflection, under tension and on foundations too.
Pieces without inertia and drag deflect at all times as at rest, under what varies in time too; on all others that is a
SpreadForce.
"""

from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.elements.member_pieces import pieces_of
from vibcli.elements.member_places import ROUNDING
from vibcli.elements.member_springs import mean_across, mean_along
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.separated_products import products_of

if TYPE_CHECKING:
    from vibcli.elements.member import Member
    from vibcli.language.reader import Record
    from vibcli.symbolic.node import Node


class SpreadLoad(NamedTuple):
    """The load q per length of an element `owner` on a member, from one place to another, steady; x is the place in
    it, in_time what varies in time besides."""

    owner: str
    member: str
    start: Any
    end: Any
    q: Any
    in_time: Any
    x: Any
    where: Any

    @property
    def even(self) -> bool:
        """Is it the same all along?"""
        return not (self.q.mask | self.in_time.mask) & self.x.mask


def add_spread_load(record: "Record", member: "Member", scene: Any) -> None:
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
    vibrates = _on_slack(member, low, high, scene)      # between a station and a slack end
    if vibrates and not q.is_zero:
        _not_yet(record, scene)
        return
    for i, (segment, left, right) in enumerate(pieces_of(member, scene)):
        middle = (scene.number(left.place) + scene.number(right.place)) / 2
        if low < middle < high:
            is_light = segment.inertia.is_zero and segment.drag.is_zero
            vibrates = vibrates or not is_light
            _on_piece(record, load if is_light else load._replace(in_time=scene.table.zero), member, segment, left,
                      right, member.tension(i, segment, scene), scene)
    if vibrates:
        _vibrating(record, load, scene)


def _on_slack(member, low, high, scene):
    """Does a load reach beyond the stations, to an end that bears no tension?"""
    first, last = (scene.number(member.stations[end].place) for end in (0, -1))
    slack = ROUNDING * scene.number(member.length)
    return low < first - slack or high > last + slack


def _vibrating(record, load, scene):
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


def _on_piece(record, load, member, segment, left, right, tension, scene):
    if load.q.is_zero and load.in_time.is_zero:
        return None
    length = right.place - left.place
    ends = [*member.motions(left), *member.motions(right)]
    bends, foundation = member.kind.bends, segment.foundation
    if load.even:
        mean = (mean_across(scene, length, segment.stiffness, tension[0], foundation, ends) if bends else
                mean_along(scene, length, tension[0], foundation, ends, tension[1]))
        if bends and not tension[1].is_zero:
            return _not_yet(record, scene)
        scene.add_force(load.q * length, load.in_time * length, mean)
        return None
    if not foundation.is_zero or not tension[1].is_zero or (bends and not tension[0].is_zero):
        return _not_yet(record, scene)
    xi = scene.table.variable("the place on a piece")
    parts = substitute([load.q, load.in_time], {load.x: left.place + xi})
    for shape, end in zip(_shapes(scene, xi / length, length, bends), ends, strict=True):
        found = [_integral(part, shape, xi, length, scene, record) for part in parts]
        if None in found:
            return None
        scene.add_force(*found, end)
    return None


def _not_yet(record, scene):
    scene.report(record["per_length"].where, "such a load on a member under tension or on a foundation does not work "
                 "yet", "let forces act at points of the member")


def _shapes(scene, r, length, bends):
    """Nᵢ of (u₀, u_l), of beams (u₀, θ₀, u_l, θ_l), r = x/l."""
    if not bends:
        return [1 - r, r]
    return [1 - 3 * r**2 + 2 * r**3, length * (r - 2 * r**2 + r**3), 3 * r**2 - 2 * r**3, length * (r**3 - r**2)]


def _integral(q: "Node", shape: "Node", x: "Node", length: "Node", scene: Any, record: "Record") -> "Node | None":
    """∫₀ˡ q N dx by parts, N being a polynomial: Σ (−1)ᵏ N⁽ᵏ⁾ q₍₋ₖ₋₁₎ between the ends."""
    total, sign = scene.table.zero, 1
    while not shape.is_zero:
        q = scene.integrated(q, x, record["per_length"].where)
        if q is None:
            return None
        there, here = (substitute([shape * q], {x: place})[0] for place in (length, scene.table.zero))
        total = total + sign * (there - here)
        shape, sign = gradient(shape).get(x, scene.table.zero), -sign
    return total
