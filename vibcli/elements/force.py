"""Loads: forces at points, moments on bodies, generalised forces; their virtual work is δA = Σ F δs = Σ Q_q δq.

A force with a `carrier` keeps its direction in that body (a follower force). An unbalance e of mass m₀ turning at Ω
acts as the pure force m₀ e Ω² (cos Ωt, sin Ωt).
"""

from typing import TYPE_CHECKING, Any

from vibcli.elements.ends import angle_of, axis_of, slope_of, station_of
from vibcli.elements.rigid_body import carriers
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import BODY, Load, NameOf, OneOf, Quantity, vector
from vibcli.language.named_elements import load

if TYPE_CHECKING:
    from vibcli.language.reader import Reader, Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

_AT = OneOf("the name of a point or body (name a place under `points`)",
            scalar=NameOf("the name of a point or body", "points", "bodies"))




class _BodyOrMember(NameOf):
    """A body; in a scene with members one of them, along which a load is spread."""

    def __init__(self) -> None:
        super().__init__(BODY.wants, "bodies")
        self.other = NameOf("the name of a body or member", "bodies", "members")

    def read(self, node: Any, reader: Any) -> Any:
        return self.other.read(node, reader) if reader.members else super().read(node, reader)


def _settle(record: "Record", reader: "Reader") -> None:
    if "per_length" in record:
        reader.name_within(record["per_length"], "x", "m")
    for key in ("from", "to"):
        if key in record.places and "per_length" not in record.places:
            reader.report(record.place(key), f"'{key}' says where a load along a member acts", "write `per_length:`")
    if "speed" in record.places and "unbalance" not in record.places:
        reader.report(record.place("speed"), "'speed' is that of an unbalance, and there is none", "leave it out")
    turned = () if "at" in record.places else ("body",)
    for first, others in (("force", ("at",)), ("moment", turned), ("value", ("coordinate",)), ("per_length", ("body",)),
                          ("unbalance", ("at", "speed"))):
        for key in others if first in record.places else ():
            if key not in record.places:
                reader.report(record.where, f"a force with '{first}' needs '{key}'",
                              f"{key}: {ELEMENT.fields[key].about}")
    if "carrier" in record and "force" not in record.places:
        reader.report(record.place("carrier"), "'carrier' turns a force with a body: here is no `force`",
                      "leave it out")


ELEMENT = Element(
    "force",
    "A load, any expression of the time t, coordinates and velocities: a force [Fx, Fy] at a point or body (one number "
    "on a body without a place), a moment on a body, a generalised force on a coordinate, or a rotating unbalance.",
    {
        "at": Field(_AT, "the point or body that it acts on"),
        "force": Field(OneOf("a force, or its components [Fx, Fy]", scalar=Load("N"),
                             sequence=vector("N", "components [Fx, Fy]", Load)),
                       "the force, as 3 N, [0, -9.81 N] or 3 N*cos(2 rad/s*t)"),
        "carrier": Field(BODY, "the body with which the force turns (a follower force); fixed without it"),
        "body": Field(_BodyOrMember(), "the body that a moment acts on"),
        "moment": Field(Load("N*m"), "the moment, counter-clockwise"),
        "coordinate": Field(NameOf("the name of a coordinate", "coordinates"), "the coordinate of a generalised force"),
        "value": Field(Load(), "the generalised force: its work is value·δq"),
        "per_length": Field(Load(), "a load along the member `body` in the sense of its u, per length, x its place: "
                                    "q0*sin(pi*x/L)*cos(Omega*t), a sum of such products in time; frf[…] to it is that "
                                    "to a load of this form whose largest value is 1 N/m"),
        "from": Field(Quantity("m"), "where it begins (default: the left end)"),
        "to": Field(Quantity("m"), "where it ends (default: the right end)"),
        "unbalance": Field(Quantity("kg*m"), "a rotating unbalance: mass times eccentricity"),
        "speed": Field(Quantity("rad/s"), "its angular speed"),
    },
    exclusive=(("force", "moment", "value", "unbalance", "per_length"), ("at", "body", "coordinate")),
    needs=(("force", "moment", "value", "unbalance", "per_length"),),
    settle=_settle,
    example="forces",
    instead={"angle": "a force has components: [F*cos(alpha), F*sin(alpha)]", "torque": "did you mean 'moment'?",
             "F": "did you mean 'force'?", "point": "did you mean 'at'?",
             "on": "did you mean 'at'?"},
)


def build(record: "Record", scene: "Builder") -> None:
    """Add the virtual work of a load to the scene."""
    if "value" in record:
        scene.add_force(*scene.load(record["value"]), scene.symbol(record["coordinate"].text))
    elif "moment" in record:
        angle = _turning(record, scene)
        if angle is not None:
            scene.add_force(*scene.load(record["moment"]), angle)
    elif "per_length" in record:
        member = scene.members.get(record["body"].text)
        if member is None:
            scene.report(record.place("body"), f"'{record['body'].text}' is a body, which a load per length does not "
                         "act on", "name a bar, shaft, beam or string")
        elif member.stations:
            load("member_loads").add_spread_load(record, member, scene)
    elif "unbalance" in record:
        _unbalance(record, scene)
    else:
        _force(record, scene)


def _turning(record: "Record", scene: "Builder") -> "Node | None":
    """The rotation that a moment acts on, of a body or of a point on a shaft or beam."""
    if "body" in record:
        if record["body"].text in scene.members:
            scene.report(record.place("body"), f"'{record['body'].text}' is a member: a moment acts at a place",
                         "name a point of it: `at: P`, P: {body: …, at: …} under `points`")
            return None
        return angle_of(record["body"], scene, "write `at:` and `force:`")
    found = station_of(record["at"].text, scene)
    if found is None:
        scene.report(record.place("at"), "a moment acts on a body, or at a point of a shaft or beam",
                     "write `body:` in place of `at:`")
        return None
    return slope_of(record["at"], *found, scene, "moments act on bodies, and at points of shafts and beams")


def _force(record: "Record", scene: "Builder") -> None:
    given, axis = record["force"], _axis(record, scene)
    if (axis is not None) == isinstance(given, list):
        where = given[0].where if isinstance(given, list) else given.where
        message, hint = (("has no place: its force is one number", "write `force: F`") if axis is not None else
                         ("has a place: its force has two components", "write `[Fx, Fy]`"))
        scene.report(where, f"'{record['at'].text}' {message}", hint)
    elif axis is not None:
        if "carrier" in record:
            scene.report(record.place("carrier"), f"'{record['at'].text}' has no place: its force does not turn",
                         "leave `carrier` out")
        scene.add_force(*scene.load(given), axis)
    else:
        parts = list(zip(*map(scene.load, given), strict=True))        # (x, y) of the steady part, of that in time
        if "carrier" in record:
            frame = scene.frame(record["carrier"])
            parts = [frame.turned(*part) for part in parts]
        _at_point(record, scene, *zip(*parts, strict=True))


def _axis(record: "Record", scene: "Builder") -> "Node | None":
    """The displacement of a lumped body that a force acts on; None of what has a place."""
    name = record["at"].text
    axis = axis_of(name, scene)
    if axis is not None and axis[0] == "turn":
        scene.report(record.place("at"), f"'{name}' turns: what acts on it is a moment",
                     f"write `{'body' if name in scene.bodies else 'at'}:` and `moment:`")
    return axis and axis[1]


def _at_point(record: "Record", scene: "Builder", fx: "tuple[Node, Node]", fy: "tuple[Node, Node]") -> None:
    """A force of two components, each (steady part, part in time)."""
    x, y = scene.place(record["at"])[1]
    if not (x.mask or y.mask or _on_clamped(record["at"].text, scene)):
        _does_no_work(record, scene)
    scene.add_force(*fx, x)
    scene.add_force(*fy, y)


def _on_clamped(name: str, scene: "Builder") -> bool:
    """Does a clamp carry a point or body, directly or through others, so that a load on it has reactions?"""
    point = (scene.spec.get("points") or {}).get(name)
    if point is not None:
        return "body" in point and _on_clamped(point["body"].text, scene)
    if name not in scene.bodies:        # a point of a member, where that is held
        return False
    record = scene.bodies[name].record
    return "clamp" in record or any(_on_clamped(carrier, scene) for carrier in carriers(record, scene.spec))


def _does_no_work(record: "Record", scene: "Builder") -> None:
    """Say which point does not move: of a body it is the mass centre, about which the body may turn."""
    name = record["at"].text
    body, point, hint = scene.bodies.get(name), f"'{name}'", "let it move, or take the force out"
    if body is None and "body" not in (scene.spec.get("points") or {}).get(name, ("body",)):
        hint = "a point of a body is P: {body: name, at: [x, y]} under `points`"
    elif body is not None and scene.turns(body):
        point = f"the mass centre of {point}"
        hint = f"a point off it is P: {{body: {name}, at: [x, y]}} under `points`; a moment needs `body` and `moment`"
    scene.report(record.place("at"), f"{point} never moves: this force does no work", hint)


def _unbalance(record: "Record", scene: "Builder") -> None:
    """m₀ e Ω² (cos Ωt, sin Ωt); along the one axis of a lumped body m₀ e Ω² sin Ωt."""
    speed, axis = scene.lower(record["speed"]), _axis(record, scene)
    size, phase = scene.lower(record["unbalance"]) * speed * speed, speed * scene.time
    sin, cos = scene.table.call("sin", phase), scene.table.call("cos", phase)
    zero = scene.table.zero
    if axis is not None:
        scene.add_force(zero, size * sin, axis)
    else:
        _at_point(record, scene, (zero, size * cos), (zero, size * sin))
