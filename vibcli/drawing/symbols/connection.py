"""Springs and dampers between places: those with the same two ends stand side by side; walls where they end."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.canvas.primitives import Polyline, Primitive
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.sketch import Attachment, Sketch
from vibcli.drawing.symbols import SYMBOLS, support
from vibcli.language.named_elements import load

if TYPE_CHECKING:
    from types import ModuleType

    from vibcli.drawing.symbols.look import Look
    from vibcli.language.reader import Record

APART, BRIDGE = 17.0, 8.0
THIN, ASIDE = ("arm", "bob"), 22.0     # looks; points from the axis of one to what would lie along it
BESIDE, MOST = 3.0, 3       # points from an axis that are on it; of nine places those that may be


class Bunch(NamedTuple):
    """The Records of elements with the same ends, between two Attachments at the edges of bodies; `aside`: how far on
    the left of these they lie, as they would lie along a body."""

    members: "list[Record]"
    one: Attachment
    two: Attachment
    aside: float = 0.0

    def offsets(self) -> list[float]:
        """How far across each of its members lies."""
        from vibcli.drawing.symbols.parts import offsets

        return [t + self.aside for t in offsets(self.members, APART)]


def symbol(record: "Record") -> "ModuleType":
    """The module that draws what joins two ends: `between(record, start, end, drawn)` from one place to another,
    `drawn` being their distance as drawn, and `about(record, turn)` at the joint about which it turns; `NAMED_BY`: the
    keys whose quantity stands beside it."""
    return load(SYMBOLS[record.element.name][0], "drawing.symbols")


def between(record: "Record", start: tuple[float, float], end: tuple[float, float], drawn: float,
            gap: float | None) -> list[Any]:
    """What joins two places; gap: that of a spring in motion, in points."""
    found: list[Any] = symbol(record).between(record, start, end, drawn, *(() if gap is None else (gap,)))
    return found


def bunches(sketch: Sketch, looks: "Mapping[str, Look]") -> list[Bunch]:
    """The Bunches of all elements that run between two places."""
    found = {}
    for record in sketch.spec.connections:
        ends = _ends(record, sketch)
        if None in ends or plane.distance(ends[0].drawn, ends[1].drawn) < 1e-9:
            continue
        key = tuple(sorted((end.carrier or "", round(end.drawn[0], 3), round(end.drawn[1], 3)) for end in ends))
        found.setdefault(key, (ends, []))[1].append(record)
    return [_beside_bodies(Bunch(members, *_at_edges(ends, looks)), looks) for ends, members in found.values()]


def _beside_bodies(bunch: Bunch, looks: "Mapping[str, Look]") -> Bunch:
    """The Bunch, from the ground to a thin body along which it would run on the right of that."""
    at, length = plane.along(bunch.one.drawn, bunch.two.drawn), plane.distance(bunch.one.drawn, bunch.two.drawn)
    carried = [end.carrier for end in (bunch.one, bunch.two) if end.carrier is not None]
    look = looks.get(carried[0]) if len(carried) == 1 else None
    if look is None or look.kind not in THIN or not isinstance(look.pieces[0], Polyline):
        return bunch
    axis = look.pieces[0].points
    places = [at(0.1 * i * length) for i in range(1, 10)]
    if sum(plane.distance(place, plane.nearest_on(place, *axis)) < BESIDE for place in places) <= MOST:
        return bunch
    return bunch._replace(aside=ASIDE if bunch.two.drawn[1] < bunch.one.drawn[1] else -ASIDE)


def _ends(record: "Record", sketch: Sketch) -> list[Attachment | None]:
    """The Attachments of an element, None among them if it has no two places."""
    if "torsion" in record:
        return [None]
    if "between" in record:
        return [sketch.attachment(end) for end in record["between"]]
    from vibcli.drawing.layout.props import prop

    return prop(record, sketch) or [None]


def _at_edges(ends: list[Attachment], looks: "Mapping[str, Look]") -> tuple[Attachment, Attachment]:
    """The ends where they leave the bodies as drawn."""
    one, two = _on_planks(ends, looks)
    return _edge(one, two.drawn, looks), _edge(two, one.drawn, looks)


def _on_planks(ends: list[Attachment], looks: "Mapping[str, Look]") -> list[Attachment]:
    """Ends on the upper edge of a plank moved into it, the fixed other end with it."""
    for i, end in enumerate(ends):
        look, other = looks.get(end.carrier), ends[1 - i]
        if look is not None and look.kind == "platform" and other.carrier is None and not look.angle and abs(
                end.drawn[1] - other.drawn[1]) < 1e-6:
            y = sum(corner[1] for corner in look.core[:4]) / 4
            if abs(y - end.drawn[1]) <= look.height:
                return [part._replace(drawn=(part.drawn[0], y)) for part in ends]
    return ends


def _edge(end: Attachment, other: tuple[float, float], looks: "Mapping[str, Look]") -> Attachment:
    look = looks.get(end.carrier)
    if look is None or look.core is None or not plane.inside(end.drawn, look.core):
        return end
    if look.kind == "rectangle" and plane.distance(end.drawn, plane.middle(look.core[0], look.core[2])) > 1e-6:
        return end
    edge = plane.leaves(end.drawn, plane.unit(plane.minus(other, end.drawn)), look.core)
    near = plane.distance(end.drawn, edge) < plane.distance(end.drawn, other) - 8
    return Attachment(end.carrier, edge, True) if near else end


def draw(bunch: Bunch, sketch: Sketch) -> tuple[list[Any], dict[str, tuple[Any, ...]]]:
    """The primitives of a Bunch, and where each member is: {name: (middle, normal)}."""
    from vibcli.drawing.symbols import parts

    a, b = sketch.now(bunch.one), sketch.now(bunch.two)
    length, at = plane.distance(a, b), plane.along(a, b)
    count, drawn = len(bunch.members), plane.distance(bunch.one.drawn, bunch.two.drawn)
    if length < 1e-6:
        return [], {}
    bridge = min(BRIDGE, 0.15 * drawn) if count > 1 else 0.0
    found, where = [], {}
    sides = bunch.offsets()
    for record, t in zip(bunch.members, sides, strict=True):
        start, end = at(bridge, t), at(length - bridge, t)
        found += between(record, start, end, drawn - 2 * bridge, sketch.gap(record, sketch.scale))
        where |= named(record, start, end, plane.left(plane.unit(plane.minus(b, a))), *parts.sides(t, sides))
    for held, place in ((bunch.one, a), (bunch.two, b)):
        if held.carrier is not None and held.carrier not in sketch.moving_points and not held.loose:
            found += support.dot(place)
    if count > 1 or bunch.aside:
        low, high = max(sides[0], 0.0), min(sides[-1], 0.0)
        found += [Polyline(line, "spring") for line in (
            (a, at(bridge)), (at(bridge, low), at(bridge, high)),
            (at(length - bridge, low), at(length - bridge, high)), (at(length - bridge), b))]
    return found, where


def named(record: "Record", start: tuple[float, float], end: tuple[float, float],
          *beside: Any) -> dict[Any, tuple[Any, ...]]:
    """{its name: (middle, normal, sides)} of what joins two places, for labels; {(name, "gap"): …} of its gap too."""
    found: dict[Any, tuple[Any, ...]] = {record.name: (plane.middle(start, end), *beside)}
    if "gap" in record:
        from vibcli.drawing.symbols.one_sided import sign

        at, length = plane.along(start, end), plane.distance(start, end)
        found[record.name, "gap"] = at(sign(record, at, length, length).gap), *beside
    return found


def outline(bunch: Bunch, sketch: Sketch) -> list[Any]:
    """The corners of a Bunch, from the middle of its first element to that of its last."""
    a, b = sketch.now(bunch.one), sketch.now(bunch.two)
    at, length, sides = plane.along(a, b), plane.distance(a, b), bunch.offsets()
    return [at(s, t) for s, t in ((0.0, sides[0]), (length, sides[0]), (length, sides[-1]), (0.0, sides[-1]))]


def walls(places: Sequence[tuple[Attachment, tuple[float, float]]], sketch: Sketch) -> list[Primitive]:
    """The ground at fixed ends: `places` [(Attachment, direction into the ground)], the same place once."""
    groups = {}
    for end, outward in places:
        key = end.carrier, round(end.drawn[0], 3), round(end.drawn[1], 3)
        groups.setdefault(key, (end, []))[1].append(outward)
    found = []
    for end, directions in groups.values():
        total = (sum(d[0] for d in directions), sum(d[1] for d in directions))
        outward = snapped(plane.unit(total, directions[0]))
        draw_wall = support.wall if sketch.is_fixed(end.carrier) else support.shaken_wall
        found += draw_wall(sketch.now(end), outward)
    return found


def snapped(direction: tuple[float, float]) -> tuple[float, float]:
    """A direction along the nearest axis where it is within some degrees of it."""
    x, y = direction
    if min(abs(x), abs(y)) < 0.12:
        return (round(x), 0) if abs(x) > abs(y) else (0, round(y))
    return direction
