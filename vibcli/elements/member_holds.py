"""What holds the stations of members: {motion: what it is} of the motions u, slope and along that are not free."""

from collections.abc import Callable
from typing import TYPE_CHECKING, cast

from vibcli.elements.member_ends import CLAMPED, FREE, GUIDED, HOLDS, PINNED
from vibcli.elements.member_fields import MemberKind

if TYPE_CHECKING:
    from vibcli.elements.member import Member
    from vibcli.elements.member_line import DrawnLine
    from vibcli.elements.member_places import PlaceAlong
    from vibcli.language.reader import Record, Reference
    from vibcli.scene.builder import Builder
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

POINT = frozenset(("mass", "at", "move", "slide"))       # keys of a body that has no size
SAME = 1e-9         # of the length of a member: places nearer than that are one
HELD = {CLAMPED: ("u", "slope", "along"), PINNED: ("u", "along"), GUIDED: ("slope", "along")}


def motions_of_kind(kind: MemberKind, line: "DrawnLine | None") -> list[str]:
    """The motions that a station of a member has."""
    return ["u", *(["slope"] if kind.bends else []), *([] if line is None else ["along"])]


def held_at(place: "PlaceAlong", kind: MemberKind, line: "DrawnLine | None", scene: "Builder",
            built: "Callable[[str, Builder], Member | None]") -> "dict[str, Node]":
    """{motion: node} that ends and supports hold at a place, each once; `built(name, scene)`: another Member."""
    found, motions = {}, motions_of_kind(kind, line)
    for holds in (*(_end(end, place, kind, line, scene, built) for end in place.ends), *(
            _support(record["support"], kind, line, scene) for record in place.attached if "support" in record)):
        for motion, node in holds.items():
            if motion in found:
                where = next((r.place("support") for r in place.attached if "support" in r), place.where)
                scene.report(where, f"what stands at {place.text} is held there already", "leave one of both out")
                break
            if motion in motions:
                found[motion] = node
    return found


def _support(word: str, kind: MemberKind, line: "DrawnLine | None", scene: "Builder") -> "dict[str, Node]":
    """Supports in the plane are rollers: they act across, of a bar along."""
    if kind.name == "bar" and line is not None:
        return {"along": scene.table.zero}
    return {motion: scene.table.zero for motion in HELD[word] if motion != "along"}


def _end(end: "Record | str", place: "PlaceAlong", kind: MemberKind, line: "DrawnLine | None", scene: "Builder",
         built: "Callable[[str, Builder], Member | None]") -> "dict[str, Node]":
    zero = scene.table.zero
    if isinstance(end, str):
        return {} if end == FREE else dict.fromkeys(HELD[end if kind.bends else PINNED], zero)
    word = next((word for word in HOLDS if word in end), None)
    if word is None:
        return {}
    name, at = end[word], line and line.drawn(place.node)
    if name.text in scene.bodies:
        held = _on_lumped(name, kind, scene) if line is None else _on_placed(name, kind, line, at, scene)
    else:
        other = built(name.text, scene)
        held = _on_member(end, word, kind, line, at, scene, other) if other and other.stations else None
    return {motion: held[motion] for motion in HELD[word if kind.bends else PINNED] if motion in held} if held else {}


def beyond_reach(name: str, at: "tuple[Node, Node]", scene: "Builder | Scene") -> float:
    """How far from a body without size a place is drawn, m; 0 of what has a size, or hangs from a pin."""
    record, (x, y) = scene.spec.get("bodies")[name], scene.bodies[name].centre
    if not POINT.issuperset(record):
        return 0.0
    return cast("float", scene.number((at[0] - x) ** 2 + (at[1] - y) ** 2) ** 0.5)


def _moved(line: "DrawnLine", drawn: "tuple[Node, Node]", now: "tuple[Node, Node]", angle: "Node") -> "dict[str, Node]":
    """The motions of a place drawn at one and now at another place, which turns by an angle."""
    along, across = line.seen(now[0] - drawn[0], now[1] - drawn[1])
    return {"u": across, "slope": angle, "along": along}


def _on_placed(name: "Reference", kind: MemberKind, line: "DrawnLine", at: "tuple[Node, Node]",
               scene: "Builder") -> "dict[str, Node] | None":
    """Those of a place carried by a body; None where it does not reach there, or moves on and on, which is reported."""
    frame = scene.frame(name)
    now, off = frame.point(*at), beyond_reach(name.text, at, scene)
    turns = scene.turns(scene.bodies[name.text]._replace(frame=frame))
    if off > SAME * scene.number(line.length) and (turns or not kind.bends):
        scene.report(name.where, f"this end and '{name.text}', which is a point, are {off:.6g} m apart as drawn",
                     "draw them at the same place, or give it a size, as in `shape: rectangle, width: 2 m, "
                     "height: 1 m`")
        return None
    if any(scene.drifts(node) for node in (*now, frame.angle)):
        _reports_drift(name, scene)
        return None
    return _moved(line, at, now, frame.angle)


def _reports_drift(name: "Reference", scene: "Builder") -> None:
    scene.report(name.where, f"'{name.text}' moves on and on, and members have small motions about their drawn "
                 "line", "hold the member to what rests or is shaken")


def _on_lumped(name: "Reference", kind: MemberKind, scene: "Builder") -> "dict[str, Node] | None":
    """Those of a body without a place; None where it does not fit, which is reported."""
    body, zero = scene.bodies[name.text], scene.table.zero
    if body.lumped is None:
        scene.report(name.where, f"'{name.text}' has a place, and this member has none",
                     "lump the body, `slide: x` or `turn: phi`, or draw the member `from` a place `to` another")
        return None
    moves, motion = body.lumped
    if scene.drifts(motion):
        _reports_drift(name, scene)
        return None
    if kind.bends:
        return {"u": motion, "slope": zero} if moves == "slide" else {"u": zero, "slope": motion}
    if (moves == "turn") != kind.torsional:
        way = "turns, and bars and strings move along one axis" if moves == "turn" else "slides, and shafts turn"
        scene.report(name.where, f"'{name.text}' {way}", "let it " + ("turn: `turn: phi`" if kind.torsional else
                                                                      "slide: `slide: x`"))
        return None
    return {"u": motion}


def _on_member(end: "Record", word: str, kind: MemberKind, line: "DrawnLine | None", at: "tuple[Node, Node] | None",
               scene: "Builder", other: "Member") -> "dict[str, Node] | None":
    """Those of another member at a place; None where it does not fit, which is reported."""
    name = end[word]
    if "at" not in end:
        scene.report(name.where, f"where on '{name.text}' is not said", "give the place: `at: L/2`")
        return None
    if (other.line is None) != (line is None):
        scene.report(name.where, f"of this member and '{name.text}' one has a place and one has none",
                     "draw both `from` a place `to` another")
        return None
    if other.kind.torsional != kind.torsional:
        scene.report(name.where, f"a {kind.name} and a {other.kind.name} have no motion in common",
                     "shafts are held to shafts")
        return None
    if word == CLAMPED and kind.bends and other.kind.name == "string":
        scene.report(name.where, "a string holds no slope", f"write `{{pinned: {name.text}, at: …}}`")
        return None
    station = other.at(scene, scene.lower(end["at"]))
    slope = scene.table.zero if station.slope is None else station.slope
    if line is None:
        return {"u": station.u, "slope": slope}
    there = other.line.drawn(station.place)
    off = scene.number((there[0] - at[0]) ** 2 + (there[1] - at[1]) ** 2) ** 0.5
    if off > SAME * scene.number(line.length + other.length):
        scene.report(name.where, f"this end and that place on '{name.text}' are {off:.6g} m apart as drawn",
                     "draw them at the same place")
        return None
    x, y = other.line.displaced(station.along, station.u)
    return _moved(line, (scene.table.zero, scene.table.zero), (x, y), slope)
