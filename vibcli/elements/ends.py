"""What springs and dampers join: places, bodies and the ground, and how far their ends are apart."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Literal

    from vibcli.elements.member import Member, Station
    from vibcli.language.reader import Expression, Record, Reference
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

TURNING = "torsion acts between two bodies, or a body and `ground`"


def station_of(point: str, scene: "Builder") -> "tuple[Member, Station] | None":
    """The Member and Station of a point on a member; None of any other name."""
    record = (scene.spec.get("member_points") or {}).get(point)
    if record is None:
        return None
    member = scene.members[record["body"].text]
    return member, member.at(scene, scene.lower(record["at"]))


def axis_of(name: str, scene: "Builder") -> "tuple[str, Node] | None":
    """(slide or turn, motion) of a body without a place or of a point on a member; None of what has a place."""
    if name in scene.bodies:
        return scene.bodies[name].lumped
    found = station_of(name, scene)
    if found is None or found[0].line is not None:
        return None
    return "turn" if found[0].kind.torsional else "slide", found[1].u


def stretch(record: "Record", scene: "Builder", torsion: bool) -> "Node | None":
    """The stretch of a spring or damper since the drawn position; None where it was reported as wrong."""
    if "stretch" in record:
        return moving(record, scene, scene.lower(record["stretch"]))
    if torsion:
        angles = [_angle(end, scene) for end in record["between"]]
        return None if None in angles else moving(record, scene, angles[1] - angles[0])
    lumped = [_lumped(end, scene) for end in record["between"]]
    if lumped == [0, 0] or any(lumped):
        return moving(record, scene, _lumped_stretch(record, scene, lumped))
    dx, dy = span(record, scene)
    found = None if dx is None else length(record, scene, dx, dy)
    return None if found is None else moving(record, scene, found - scene.at_drawn(found)[0])


def length(record: "Record", scene: "Builder", dx: "Node", dy: "Node") -> "Node | None":
    """The distance of two ends; None where they coincide as drawn, which is reported."""
    found = scene.distance(dx, dy)
    if scene.number(found) > 0:
        return found
    scene.report(record.where, f"the ends of '{record.name}' coincide as drawn: its direction is not defined",
                 "draw them apart" + (", or give `free_length: 0`" if "k" in record else ""))
    return None


def moving(record: "Record", scene: "Builder", found: "Node | None") -> "Node | None":
    """The stretch; None where it never changes, which is reported."""
    if found is not None and not found.mask:
        hint = "check its ends, or take it out"
        if any(isinstance(end, list) for end in record.get("between", ())):
            hint = "a place [x, y] is fixed; a point of a body is P: {body: name, at: [x, y]} under `points`"
        if not scene.coordinates.q:
            hint = "nothing moves: a coordinate is a name that is no parameter"
        scene.report(record.where, f"the stretch of '{record.name}' never changes", hint)
        return None
    return found


def span(record: "Record", scene: "Builder") -> "tuple[Node | None, Node | None]":
    """(dx, dy) from the first end to the second; (None, None) where an end has no place."""
    places = [_place_of(end, record, scene) for end in record["between"]]
    if None in places:
        return None, None
    (ax, ay), (bx, by) = places
    return bx - ax, by - ay


def _place_of(end: "list[Expression] | Reference", record: "Record", scene: "Builder") -> "tuple[Node, Node] | None":
    if isinstance(end, list):
        return scene.pair(end)
    if end.text == "ground":
        scene.report(end.where, f"'{record.name}' joins a place and bare ground", "say where on the ground: [x, y]")
        return None
    if axis_of(end.text, scene) is not None:
        scene.report(end.where, f"'{end.text}' is lumped: it has no place, so '{record.name}' has no free length",
                     "give `preload` instead, or say where the body is drawn with `at`")
        return None
    return scene.place(end)[1]


def _lumped(end: "list[Expression] | Reference", scene: "Builder") -> "tuple[str, Node] | Literal[0] | None":
    """(kind, motion) of a lumped body, 0 for the ground, None for what has a place."""
    if isinstance(end, list):
        return None
    if end.text == "ground":
        return 0
    return axis_of(end.text, scene)


def _lumped_stretch(record: "Record", scene: "Builder",
                    lumped: "list[tuple[str, Node] | Literal[0] | None]") -> "Node | None":
    motions = []
    for end, part in zip(record["between"], lumped, strict=True):
        if part is None:
            where = end[0].where if isinstance(end, list) else end.where
            scene.report(where, f"'{record.name}' joins a lumped body and a place",
                         "lumped bodies are joined with each other or with `ground`")
            return None
        if part and part[0] == "turn":
            scene.report(end.where, f"'{end.text}' turns: '{record.name}' must be a torsion element",
                         "write `torsion:` instead")
            return None
        motions.append(part[1] if part else scene.table.zero)
    return motions[1] - motions[0]


def _angle(end: "list[Expression] | Reference", scene: "Builder") -> "Node | None":
    """The rotation of an end; None where it has none."""
    if isinstance(end, list):
        scene.report(end[0].where, "a place does not turn", TURNING)
        return None
    if end.text == "ground":
        return scene.table.zero
    if end.text not in scene.bodies:
        found = station_of(end.text, scene)
        if found is not None:
            return slope_of(end, *found, scene)
        scene.report(end.where, f"the point '{end.text}' does not turn", TURNING)
        return None
    return angle_of(end, scene, "write `k` or `c` instead of `torsion`")


def slope_of(end: "Reference", member: "Member", station: "Station", scene: "Builder",
             hint: str = TURNING) -> "Node | None":
    """The turn of a shaft or beam at a point; None of a bar or string, which is reported."""
    if member.kind.torsional:
        return station.u
    if station.slope is None:
        scene.report(end.where, f"'{end.text}' is on a {member.kind.name}, which does not turn", hint)
    return station.slope


def angle_of(end: "Reference", scene: "Builder",
             hint: str = "give it a `turn`, or a place and a `pin`") -> "Node | None":
    """The rotation of a body; None where it has none, which is reported."""
    body = scene.bodies[end.text]
    if body.frame is not None:
        return body.frame.angle
    if body.lumped[0] == "slide":
        scene.report(end.where, f"'{end.text}' slides: it has no rotation", hint)
        return None
    return body.lumped[1]
