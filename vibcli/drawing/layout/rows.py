"""Bodies without a place, laid out in rows along their axis: who stands where, and which element runs in which lane."""

from collections.abc import Mapping, Sequence
from itertools import permutations
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.layout.captions import raw

if TYPE_CHECKING:
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Expression, Record
    from vibcli.scene.scene import Scene

BRUTE = 6       # bodies of a row up to which every order is tried


class Edge(NamedTuple):
    """What joins two lumped bodies; None is the ground."""

    record: Any
    one: str | None
    two: str | None


class LumpedRow(NamedTuple):
    """Bodies from left to right, `gaps`: {i: edges} between column i − 1 and i (0: at the left wall, n: at the right
    one), `lanes`: [(column, column, edge)] of what runs over bodies, −1 and n being the walls."""

    bodies: list[str]
    gaps: "dict[int, list[Edge]]"
    lanes: "list[tuple[int, int, Edge]]"


def edges(scene: "Scene") -> list[Edge]:
    """The Edges of a scene."""
    found = []
    for record in scene.spec.connections:
        ends = _ends(record, scene)
        if ends is not None:
            found.append(Edge(record, *ends))
    return found


def _ends(record: "Record", scene: "Scene") -> tuple[str | None, str | None] | None:
    """The two ends of an element among lumped bodies; None of one that is elsewhere."""
    if "between" in record:
        names = [getattr(end, "text", None) for end in record["between"]]
        lumped = [name for name in names if name in scene.bodies and scene.bodies[name].lumped is not None]
        if not lumped or not all(name in lumped or name == "ground" for name in names):
            return None
        return tuple(name if name in lumped else None for name in names)
    stretch = raw(record["stretch"], scene).mask
    moving = [name for name, body in scene.bodies.items() if body.lumped is not None
              and raw(motion(body), scene).mask & stretch]
    if not moving or len(moving) > 2:
        return None
    return (None, moving[0]) if len(moving) == 1 else (moving[0], moving[1])


def motion(body: "Body") -> "Expression":
    """The field that moves a lumped body."""
    found: Expression = body.record[body.lumped[0]]["by"]
    return found


def carrier(body: "Body") -> str | None:
    """The name of the lumped body from which its motion is measured; None of the ground."""
    found: str | None = getattr(body.record[body.lumped[0]].get("carrier"), "text", None)
    return found


def rows(scene: Any) -> list[LumpedRow]:
    """The Rows of a scene, in the order of the file."""
    every = edges(scene)
    names = [name for name in scene.spec.get("bodies") or {} if scene.bodies[name].lumped is not None]
    group = {name: name for name in names}
    pairs = [(edge.one, edge.two) for edge in every] + [(carrier(scene.bodies[name]), name) for name in names]
    for one, two in pairs:
        if one is not None and two is not None:
            old, new = group[two], group[one]
            group = {name: new if own == old else own for name, own in group.items()}
    found = []
    for leader in dict.fromkeys(group.values()):
        members = [name for name in names if group[name] == leader]
        massless = [name for name in members if scene.bodies[name].mass is None and scene.bodies[name].inertia is None]
        found.append(_row(members, [edge for edge in every if (edge.one or edge.two) in members], massless))
    return found


def _row(members: list[str], edges: list[Edge], massless: list[str]) -> LumpedRow:
    orders = permutations(members) if len(members) <= BRUTE else [tuple(members)]
    best = min(orders, key=lambda order: _cost(order, members, edges, massless))
    place = {name: i for i, name in enumerate(best)}
    gaps, lanes = {}, []
    for edge in edges:
        low, high = _columns(edge, place)
        if high - low == 1:
            gaps.setdefault(high, []).append(edge)
        else:
            lanes.append((low, high, edge))
    lanes.sort(key=lambda lane: lane[1] - lane[0])
    return LumpedRow(list(best), gaps, lanes)


def _columns(edge: Edge, place: Mapping[str, int]) -> tuple[int, int]:
    """The columns of an edge, the nearer wall for the ground: the left one unless the right one is next to it."""
    n = len(place)
    if edge.one is None or edge.two is None:
        own = place[edge.one or edge.two]
        return (own, n) if own == n - 1 and own > 0 else (-1, own)
    first, last = sorted((place[edge.one], place[edge.two]))
    return first, last


def _cost(order: tuple[str, ...], members: Sequence[str], edges: Sequence[Edge],
          massless: Sequence[Any] = ()) -> tuple[float, list[int]]:
    place = {name: i for i, name in enumerate(order)}
    cost = 0.0
    for edge in edges:
        low, high = _columns(edge, place)
        cost += high - low - 1 + 0.01 * (high == len(order))
        if edge.one and edge.two:
            cost += 0.001 * (place[edge.one] > place[edge.two])
    cost += sum(0.1 for name in order[:-1] if name in massless)
    return cost, [members.index(name) for name in order]
