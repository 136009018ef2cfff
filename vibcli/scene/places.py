"""Where the bodies and points of a scene are, as drawn and now."""

from collections.abc import Callable, Mapping, Sequence
from math import inf
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.base.errors import Where
    from vibcli.elements.member import Member
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Expression, Record, Reference
    from vibcli.language.spec import Spec
    from vibcli.scene.expressions import Expressions
    from vibcli.symbolic.node import Node


class Frame(NamedTuple):
    """Where a body was drawn and is now: a reference point drawn at `drawn`, now at `place`, and the rotation `angle`:
    all expressions."""

    drawn: "tuple[Node, Node]"
    place: "tuple[Node, Node]"
    angle: "Node"

    @property
    def nodes(self) -> "list[Node]":
        """The expressions of the coordinates that it is made of."""
        return [*self.place, self.angle]

    def over(self, new: "Mapping[Node, Node]") -> "Frame":
        """Itself with its expressions replaced, {node: node}."""
        return self._replace(place=(new[self.place[0]], new[self.place[1]]), angle=new[self.angle])

    def point(self, x: "Node", y: "Node") -> "tuple[Node, Node]":
        """Where the body's point drawn at (x, y) is now: place + R(angle)·(its offset as drawn)."""
        dx, dy = x - self.drawn[0], y - self.drawn[1]
        if self.angle.is_zero:
            return self.place[0] + dx, self.place[1] + dy
        dx, dy = self.turned(dx, dy)
        return self.place[0] + dx, self.place[1] + dy

    def turned(self, x: "Node", y: "Node") -> "tuple[Node, Node]":
        """R(angle)·(x, y): a direction that the body carries."""
        cos, sin = self.angle.table.call("cos", self.angle), self.angle.table.call("sin", self.angle)
        return x * cos - y * sin, x * sin + y * cos

    def seen(self, x: "Node", y: "Node") -> "tuple[Node, Node]":
        """Where the body, were it still as drawn, would have the place that is now (x, y): the inverse of `point`."""
        dx, dy = x - self.place[0], y - self.place[1]
        cos, sin = self.angle.table.call("cos", self.angle), self.angle.table.call("sin", self.angle)
        return self.drawn[0] + dx * cos + dy * sin, self.drawn[1] + dy * cos - dx * sin


class Places:
    """The frames, circles, places and turns of `bodies` and of the points of a scene.

    `points`: {name: (drawn, present)} of those that are known, to which a scene that is built adds;
    `driven(record, drawn)`: where in it a point is that moves; `build(name)`: the member of that name.
    """

    __slots__ = (
        "bodies",
        "build",
        "driven",
        "expressions",
        "ground",
        "members",
        "points",
        "report",
        "spec",
        "table",
    )

    def __init__(self, spec: "Spec", expressions: "Expressions", bodies: "dict[str, Body]",
                 points: "dict[str, tuple[tuple[Node, Node], tuple[Node, Node]]]", members: "Mapping[str, Member]",
                 driven: "Callable[[Record, tuple[Node, Node]], tuple[Node, Node]] | None" = None,
                 build: "Callable[[str], Member] | None" = None) -> None:
        self.members, self.build = members, build
        self.spec, self.expressions, self.bodies, self.points, self.driven = spec, expressions, bodies, points, driven
        self.table, self.report = expressions.table, expressions.reports.report
        self.ground = self.still((self.table.zero, self.table.zero))

    def still(self, drawn: "tuple[Node, Node]") -> Frame:
        """The frame of what does not move."""
        return Frame(drawn, drawn, self.table.zero)

    def frame(self, name: "Reference") -> Frame:
        """That of a body, which must have a place."""
        frame = self.bodies[name.text].frame
        if frame is None:
            self.report(name.where, f"'{name.text}' has no place, so it carries nothing that has one",
                        "say where it is drawn with `at: [x, y]`")
        return frame or self.ground

    def carrier(self, record: "Record", key: str = "carrier") -> Frame:
        """The frame of the body that a record names, or the ground."""
        return self.frame(record[key]) if key in record else self.ground

    def along_axis(self, motion: "Record", kind: str) -> "Node":
        """How far the carrier of a body without a place slides or turns along the axis of both; zero of the ground."""
        if "carrier" not in motion:
            return self.table.zero
        carrier = self.bodies[motion["carrier"].text]
        if carrier.lumped is not None and carrier.lumped[0] == kind:
            return carrier.lumped[1]
        self.report(motion["carrier"].where, *(
            (f"'{carrier.name}' has a place, so it carries nothing that has none", "say where both are drawn with `at: "
             "[x, y]`") if carrier.lumped is None else
            (f"'{carrier.name}' {carrier.lumped[0]}s: it carries nothing that {kind}s",
             "leave `carrier` out; where one drives the other write an equation between both under `constraints`")))
        return self.table.zero

    def rim(self, body: "Body", where: "Where") -> "tuple[Node, Node]":
        """The centre as drawn of the circle about which a body rolls, meshes and carries ropes; of one that is not
        round its pin, or else its mass centre."""
        if len(body.rims) > 1:
            self.report(where, f"which circle of '{body.name}' is meant is not clear: its parts have several",
                        "give the body, beside its `parts`, the centre of that circle: `at: [x, y]`")
        if body.rims:
            return body.rims[0]
        return body.frame.drawn if "pin" in body.record else body.centre

    def place_of(self, end: "list[Expression] | Reference") -> "tuple[Node, Node]":
        """Where an end is now: a place [x, y], or a named point or body."""
        return self.expressions.pair(end) if isinstance(end, list) else self.place(end)[1]

    def pivot(self, pin: "Record", body: "Body") -> "tuple[tuple[Node, Node], tuple[Node, Node], Frame]":
        """(pin as drawn, pin now, frame that carries it)."""
        carrier = self.carrier(pin)
        at = pin.get("at")
        if at is None:
            drawn = body.centre
        elif isinstance(at, list):
            drawn = self.expressions.pair(at)
        else:
            drawn, place, frame = self.place(at)
            if "carrier" not in pin:
                return drawn, place, frame
        return drawn, carrier.point(*drawn), carrier

    def place(self, name: "Reference") -> "tuple[tuple[Node, Node], tuple[Node, Node], Frame]":
        """(drawn, present, carrying frame) of a named point or body."""
        if name.text in self.bodies:
            body = self.bodies[name.text]
            if body.frame is None:
                self.report(name.where, f"'{name.text}' has no place", "say where it is drawn with `at: [x, y]`")
                return self.ground.drawn, self.ground.drawn, self.ground
            return body.centre, body.frame.point(*body.centre), body.frame
        if name.text in (self.spec.get("member_points") or {}):
            return self._on_member(name)
        record = self.spec.get("points")[name.text]
        drawn, present = self.points.get(name.text) or self._located(record)
        if self.driven is not None:
            self.points[name.text] = drawn, present
        return drawn, present, self.carrier(record, "body")

    def _on_member(self, name: "Reference") -> "tuple[tuple[Node, Node], tuple[Node, Node], Frame]":
        """(drawn, present, frame) of a point on a member."""
        record = self.spec.get("member_points")[name.text]
        member = self.members.get(record["body"].text) or (self.build and self.build(record["body"].text))
        if not member or member.line is None or not member.stations:
            if member and member.line is None:
                self.report(name.where, f"'{name.text}' is on a member that has no place", "draw the member `from` a "
                            "place `to` another")
            return self.ground.drawn, self.ground.drawn, self.ground
        station = member.at(self.expressions, self.expressions.lower(record["at"]))
        drawn, present = member.line.drawn(station.place), member.position(station)
        if self.driven is not None:
            self.points[name.text] = drawn, present
        angle = self.table.zero if station.slope is None else station.slope
        return drawn, present, Frame(drawn, present, angle)

    def _located(self, record: "Record") -> "tuple[tuple[Node, Node], tuple[Node, Node]]":
        """(drawn, present) of a point."""
        drawn = self.expressions.pair(record["at"])
        place = self.driven(record, drawn) if "moves" in record else drawn
        return drawn, self.frame(record["body"]).point(*place) if "body" in record else place

    def extent(self, values: Mapping[str, float]) -> float:
        """The size of the drawn figure in metres, {name: float} given; 0 where nothing has a place."""
        places = [body.centre for body in self.bodies.values() if body.frame is not None]
        places += [self.expressions.pair(end) for record in (self.spec.get("springs") or {}).values()
                   for end in record.get("between", ()) if isinstance(end, list)]
        found: list[float] = evaluate([node for place in places for node in place], Floats, values)
        if not found:
            return 0.0
        size = max(max(found[0::2]) - min(found[0::2]), max(found[1::2]) - min(found[1::2]))
        return size or max(map(abs, found))

    def unit_of(self, name: str) -> float:
        """A natural size of a coordinate: 1 of an angle, the extent of the figure of a length."""
        sample = self.expressions.sample
        return (self.extent(sample) or 1.0) if self.spec.dimensions.of(name) else 1.0

    def units_of(self, names: Sequence[str]) -> list[float]:
        """Powers of two next to the natural sizes of coordinates: by them slopes are alike in all units."""
        lengths = [bool(self.spec.dimensions.of(name)) for name in names]
        if all(lengths) or not any(lengths):
            return [1.0] * len(lengths)
        size = _power_above(self.extent(self.expressions.sample) or 0.5)
        return [size if length else 1.0 for length in lengths]


def _power_above(x: float) -> float:
    """The least power of two above a positive number, found by comparing."""
    size = 1.0
    while size <= x < inf:
        size *= 2.0
    while x < 0.5 * size:
        size *= 0.5
    return size
