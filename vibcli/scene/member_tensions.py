"""The tension along beams and strings in the plane, as it is found in statics, by virtual work.

A scene whose members are cut open at their stations has for each a coordinate t along the line; as drawn the force
F = −∂V/∂t + Σ Q ∂s/∂t of all that hangs there on the member balances the tensions left and right of it, Nⱼ₊₁ = Nⱼ − F.
Where both ends are held, statics leaves N open but for the `preload` N₀; between ends at rest the sum of what the
pieces lengthen under their loads is zero, Σ (N̄ − N₀) l/EA = 0, and a member that keeps its length is the limit EA → ∞
of one alike all along: N₀ is then the mean of N.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.elements.member_ends import HOLDS
from vibcli.elements.member_fields import holds_along
from vibcli.elements.member_pieces import pieces_of
from vibcli.elements.member_plane import tension_gradient
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.normal_form import is_zero, textbook

if TYPE_CHECKING:
    from collections.abc import Mapping
    from fractions import Fraction
    from typing import TypeVar

    from vibcli.elements.member import Member
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

    Number = TypeVar("Number", float, Node)

LOOSE = 1e-9
SAME = 1e-9             # of the largest tension along a member: a preload that differs by less is it


class Tensions(NamedTuple):
    """N of each piece of a member as drawn, whether it is the same wherever the scene rests, and where both its ends
    are held to what parts along it the multiplier of that condition, else None; `shared`: is the member one that
    stretches, both ends held to what moves, under loads, so that others take a share of them?"""

    pieces: "list[Node]"
    settled: bool
    tie: "Node | None"
    shared: bool = False


def tensions(scene: "Scene") -> dict[str, Tensions]:
    """{name: Tensions} of a scene that is `stretched`."""
    cuts = {t: scene.table.zero for member in scene.members.values() for t in member.stretches if t is not None}
    ties = _ties(scene, cuts)
    found = {name: _found(scene, member, cuts, ties.get(name)) for name, member in scene.members.items()
             if member.stretches}
    between = [name for name in found if scene.members[name].stretching and is_held_along(scene.members[name])]
    loaded = any("preload" in scene.members[name].record for name in between) or any(
        not force.is_zero for q in scene.q for force in scene.at_drawn(force_along(scene, q)))
    if not (between and loaded):
        return found
    return found | {name: _stretched(scene, scene.members[name], found[name]) for name in between}


def placed_members(scene: "Scene") -> "list[Member]":
    """The beams and strings in the plane."""
    return [member for member in scene.members.values() if member.line is not None and member.kind.name != "bar"]


def statics_tells(scene: "Scene") -> bool:
    """Does statics alone, of members that neither bend nor stretch, tell the tension of all of them?"""
    members = placed_members(scene)
    if any(member.tie is not None or member.stretching or not member.settled for member in members):
        return False
    return not members or not (scene.constraints or any(_carries(member, other) for member in members
                                                        for other in members))


def _carries(member: "Member", other: "Member") -> bool:
    """Is an end of another member held to this one?"""
    ends = [other.record.get(side) for side in ("left", "right")]
    return any(end[word].text == member.name for end in ends if end is not None and not isinstance(end, str)
               for word in HOLDS if word in end)


def require_preloads(scene: "Scene") -> None:
    """Report a `preload` of a member that keeps its length and rests under another tension."""
    for member in placed_members(scene):
        between = is_between_fixed(member)
        if "preload" not in member.record or member.stretching or between:
            continue
        sizes = [scene.number(node) for node in along_member(member, scene)]
        given, slack = scene.number(scene.lower(member.record["preload"])), SAME * max(map(abs, sizes), default=0.0)
        if sizes and not min(sizes) - slack <= given <= max(sizes) + slack:
            told = " to ".join(dict.fromkeys(f"{x:.6g}" for x in (min(sizes), max(sizes))))
            rests = f"{given:.6g} N, and it rests under {told} N" if not scene.parameters.free else \
                "not the tension under which it rests"
            scene.report(member.record.place("preload"), f"the preload of '{member.name}' is {rests}: what holds it "
                         "tells its tension", "leave `preload` out")


def along_member(member: "Member", scene: "Scene") -> "list[Node]":
    """The tension at the left and right end of each piece, from left to right."""
    return [node for tension, gradient, length in member.tensions for node in (tension, tension + gradient * length)]


def is_between_fixed(member: "Member") -> bool:
    """Are both its ends held along it, and nothing parts there, so that its preload alone tells its tension?"""
    left, right = (member.record.get(side, "free") for side in ("left", "right"))
    return all(holds_along(end) for end in (left, right)) and member.tie is None


def under(found: "Mapping[str, Tensions]", given: "Mapping[str, list[Fraction]]") -> "dict[str, Tensions]":
    """The same with tensions that are given, {name: [N of each piece]}."""
    changed = {name: found[name]._replace(pieces=[found[name].pieces[0].table.number(x) for x in numbers])
               for name, numbers in given.items()}
    return {**found, **changed}


def is_held_along(member: "Member") -> bool:
    """Are both its ends held along it?"""
    return member.stretches[0] is None and member.stretches[-1] is None


def _stretched(scene: "Scene", member: "Member", found: Tensions) -> Tensions:
    """The Tensions of a beam that stretches between two ends that are held."""
    first, last = member.stations[0].along, member.stations[-1].along
    if first.mask or last.mask:
        return found._replace(shared=True)
    longer = softness = scene.table.zero
    start = scene.lower(member.record["preload"]) if "preload" in member.record else scene.table.zero
    for (segment, left, right), tension in zip(pieces_of(member, scene), found.pieces, strict=True):
        length = right.place - left.place
        mean = tension - start + tension_gradient(member, segment, scene) * length / 2
        longer, softness = longer + mean * length / segment.axial, softness + length / segment.axial
    return found._replace(pieces=[textbook(tension - longer / softness) for tension in found.pieces])


def _found(scene: "Scene", member: "Member", cuts: "dict[Node, Node]", tie: "Node | None") -> Tensions:
    whole, forces = _whole(scene, member, cuts), _forces(scene, member, cuts)
    settled = all(node is None or is_zero(node - force) for node, force in zip(whole, forces, strict=True))
    return Tensions(_as_drawn(scene, member, forces, tie), settled, tie)


def _whole(scene: "Scene", member: "Member", cuts: "dict[Node, Node]") -> "list[Node | None]":
    """The force along each station, None at ends that are held."""
    return [None if t is None else substitute([force_along(scene, t)], cuts)[0] for t in member.stretches]


def _forces(scene: "Scene", member: "Member", cuts: "dict[Node, Node]") -> "list[Node | None]":
    """The same as drawn."""
    return [None if node is None else textbook(scene.at_drawn(node)[0]) for node in _whole(scene, member, cuts)]


def _ties(scene: "Scene", cuts: "dict[Node, Node]") -> "dict[str, Node]":
    """{name: λ} of the members both of whose ends are held to what parts along them, as drawn: Σ λₖ ∂Gₖ/∂q is the force
    along q, Gₖ = 0 the conditions that they and the constraints make."""
    ends = {name: (member.stations[0].along, member.stations[-1].along) for name, member in scene.members.items()
            if member.stretches and is_held_along(member)}
    gaps = {name: right - left for name, (left, right) in ends.items() if (right - left).mask}
    if not gaps:
        return {}
    conditions = [*gaps.values(), *(constraint.node for constraint in scene.constraints)]
    rows = []
    for q in scene.q:
        slopes = [gradient(node).get(q, scene.table.zero) for node in conditions]
        if q not in cuts and any(slopes):
            rows.append(scene.at_drawn(*slopes, force_along(scene, q)))
    given = _given(scene, list(gaps), rows, cuts)
    for k, tension in given.items():
        rows = [[*row[:k], scene.table.zero, *row[k + 1:-1], row[-1] - row[k] * tension] for row in rows]
    found = _solved(scene, rows, len(conditions)) | given
    return {name: textbook(found.get(k, scene.table.zero)) for k, name in enumerate(gaps)}


def _given(scene: "Scene", names: Sequence[str], rows: "Sequence[list[Node]]",
           cuts: "dict[Node, Node]") -> "dict[int, Node]":
    """{number of the condition: tension} of the members whose preload tells what statics leaves open."""
    from vibcli.scene.self_stress import pinned

    numbers = [[scene.number(node) for node in row] for row in rows]
    kept = [k for k, name in enumerate(names) if not scene.members[name].stretching]
    columns = [*kept, *range(len(names), len(numbers[0]) - 1 if numbers else 0)]
    if not kept or not numbers:
        return {}
    members = [scene.members[names[k]] for k in kept]
    found = pinned(scene, members, [[row[k] for k in columns] for row in numbers], [row[-1] for row in numbers])
    return {kept[k]: _as_drawn(scene, members[k], _forces(scene, members[k], cuts), None)[-1] for k in found}


def _as_drawn(scene: "Scene", member: "Member", forces: "list[Node | None]", tie: "Node | None") -> "list[Node]":
    """N of each piece, by the forces along its stations as drawn."""
    zero = scene.table.zero
    preload = scene.lower(member.record["preload"]) if "preload" in member.record else zero
    spans = [(tension_gradient(member, segment, scene), right.place - left.place)
             for segment, left, right in pieces_of(member, scene)]
    return [textbook(node) for node in along_pieces(forces, tie, preload, spans, zero)]


def _solved(scene: "Scene", rows: "Sequence[list[Node]]", count: int) -> "dict[int, Node]":
    """{unknown: value} of linear equations [coefficients, right side]; unknowns that they leave open are left out."""
    pivots, work = {}, [list(row) for row in rows]
    for k in range(count):
        sizes = [(abs(scene.number(row[k])), i) for i, row in enumerate(work) if i not in pivots.values()]
        size, i = max(sizes, default=(0.0, None))
        if size <= LOOSE:
            continue
        pivots[k] = i
        for j, row in enumerate(work):
            if j != i and not row[k].is_zero:
                factor = row[k] / work[i][k]
                work[j] = [a - factor * b for a, b in zip(row, work[i], strict=True)]
    return {k: work[i][-1] / work[i][k] for k, i in pivots.items()}


def along_pieces(forces: list[Any], tie: Any, preload: Any, spans: list[Any], zero: Any) -> list[Any]:
    """N at the left end of each piece, by the forces along its stations, None at ends that are held: from a free end;
    from the `tie` in the last one; or from the preload, the mean of N. spans: (N′, length) of each piece. Nodes or
    numbers."""
    if forces[-1] is not None:
        return _summed(forces[:0:-1], zero)[::-1]
    if forces[0] is not None:
        return [-node for node in _summed(forces[:-1], zero)]
    if tie is not None:
        return _summed([tie, *forces[-2:0:-1]], zero)[::-1]
    beyond = [zero, *(-node for node in _summed(forces[1:-1], zero))]
    area = sum(((N + slope * length / 2) * length for N, (slope, length) in zip(beyond, spans, strict=True)), zero)
    start = preload - area / sum((length for _, length in spans), zero)
    return [start + N for N in beyond]


def _summed(forces: "Sequence[Number]", total: "Number") -> "list[Number]":
    found = []
    for force in forces:
        total = total + force
        found.append(total)
    return found


def force_along(scene: "Scene", t: "Node") -> "Node":
    """What pulls the station along, but for the member itself: −∂V/∂t and steady loads."""
    zero = scene.table.zero
    parts = [-(term.force(scene) * gradient(term.s).get(t, zero)) for term in scene.springs]
    parts += [-(term.weight * gradient(term.s).get(t, zero)) for term in scene.weights]
    parts += [term.steady * gradient(term.s).get(t, zero) for term in scene.forces]
    return scene.table.total([*parts, -gradient(scene.energies["V"]).get(t, zero)])
