"""A scene on paper in one position: where its bodies are, and where the ends of its elements, in points.

Places are those of the drawing times the scale; letters stand for the sample values of the scene. What is drawn never
depends on the position, except through the frames of the bodies.
"""

from collections.abc import Iterator, Mapping, Sequence
from math import isfinite
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.layout import plane
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.elements.member import Member
    from vibcli.elements.member_line import Station
    from vibcli.language.reader import Expression, Record, Reference
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

TORN = ("the scene cannot be drawn: its places are not finite numbers", "look at the values of its parameters")


class Attachment(NamedTuple):
    """A place as drawn and what carries it: the name of a body or driven point, None of the fixed plane; `loose` at the
    edge of a box, where nothing shows that it is fastened."""

    carrier: str | None
    drawn: tuple[float, float]
    loose: bool = False


class DrawnFrame(NamedTuple):
    """Where a body's reference point was drawn and is now, and how far the body has turned."""

    drawn: tuple[float, float]
    place: tuple[float, float]
    angle: float

    def point(self, drawn: tuple[float, float]) -> tuple[float, float]:
        return plane.plus(self.place, plane.turned(plane.minus(drawn, self.drawn), self.angle))

    def turned(self, direction: tuple[float, float]) -> tuple[float, float]:
        return plane.turned(direction, self.angle)


class CordEnd(NamedTuple):
    """The end of a cord: its name among carriers, where it was drawn, the direction in which it moves away from there
    as far as an expression says."""

    carrier: str
    drawn: tuple[float, float]
    direction: tuple[float, float]
    moved: "Node"


STILL = DrawnFrame((0.0, 0.0), (0.0, 0.0), 0.0)


class Sketch:
    """The scene at `values` ({symbol: number}), one metre being `scale` points; `numbers` are kept from one position
    to the next."""

    def __init__(self, scene: "Scene", values: Mapping[str, float], scale: float = 1.0, numbers: Any = None) -> None:
        self.scene, self.spec, self.values, self.scale = scene, scene.spec, values, scale
        self.numbers = {} if numbers is None else numbers
        self.moving_points = {name: record for name, record in (scene.spec.get("points") or {}).items()
                              if "moves" in record}
        self.frames, self.lumped = self._frames()

    def _member_points(self) -> "Iterator[tuple[str, Member, Station]]":
        """(name, Member, Station) of points on members in the plane."""
        for name, record in (self.spec.get("member_points") or {}).items():
            member = self.scene.members.get(record["body"].text)
            if member is not None and member.line is not None:
                yield name, member, member.nearest(self.scene, self.scene.lower(record["at"]))

    def at(self, values: Mapping[str, float]) -> "Sketch":
        """The same in another position."""
        return Sketch(self.scene, values, self.scale, self.numbers)

    def _frames(self) -> tuple[dict[str, DrawnFrame], dict[str, float]]:
        """({name: Frame} of bodies and driven points, {name: motion} of lumped bodies)."""
        scene, nodes, names, lumps = self.scene, [], [], []
        for name, body in scene.bodies.items():
            if body.frame is not None:
                names.append(name)
                nodes += [*body.frame.drawn, *body.frame.place, body.frame.angle]
            else:
                lumps.append((name, body.lumped[1]))
        for name, record in self.moving_points.items():
            names.append(name)
            drawn = scene.pair(record["at"])
            nodes += [*drawn, *(x + scene.lower(part) for x, part in zip(drawn, record["moves"], strict=True)),
                      scene.table.zero]
        for name, member, station in self._member_points():
            names.append(name)
            nodes += [*member.line.drawn(station.place), *member.position(station), station.slope or scene.table.zero]
        flat = evaluate([*nodes, *(node for _, node in lumps)], Floats, self.values)
        if not all(map(isfinite, flat)):
            raise PhysicsError(*TORN)
        frames = {end.carrier: self._cord_end(end) for end in self.numbers.get("cords", ())}
        for i, name in enumerate(names):
            x0, y0, x, y, angle = flat[5 * i:5 * i + 5]
            frames[name] = DrawnFrame((x0 * self.scale, y0 * self.scale), (x * self.scale, y * self.scale), angle)
        return frames, dict(zip([name for name, _ in lumps], flat[5 * len(names):], strict=True))

    def hold(self, end: CordEnd) -> None:
        """Know the end of a cord as a carrier, here and in other positions."""
        self.numbers.setdefault("cords", []).append(end)
        self.frames[end.carrier] = self._cord_end(end)

    def _cord_end(self, end: CordEnd) -> DrawnFrame:
        moved, = evaluate([end.moved], Floats, self.values)
        return DrawnFrame(end.drawn, plane.plus(end.drawn, end.direction, moved * self.scale), 0.0)

    def number(self, expression: "Expression") -> float:
        """The value of a field as drawn."""
        key = id(expression)
        if key not in self.numbers:
            value = self.scene.number(self.scene.lower(expression))
            if not isfinite(value):
                raise PhysicsError(*TORN, expression.where)
            self.numbers[key] = value
        found: float = self.numbers[key]
        return found

    def length(self, expression: "Expression") -> float:
        return self.number(expression) * self.scale

    def gap(self, record: "Record", unit: float) -> float | None:
        """The gap of an element on paper, one metre being `unit` points; None of one without, and at rest, where its
        size is not that of a motion."""
        factor: float | None = self.numbers.get("magnified")
        return None if factor is None or "gap" not in record else self.number(record["gap"]) * factor * unit

    def pair(self, expressions: "Sequence[Expression]") -> tuple[float, float]:
        return self.length(expressions[0]), self.length(expressions[1])

    def centre(self, name: str) -> tuple[float, float]:
        """The mass centre of a body as drawn."""
        return self._kept(("centre", name), self.scene.bodies[name].centre)

    def _kept(self, key: tuple[str, str], place: "tuple[Node, Node]") -> tuple[float, float]:
        """A place as drawn, evaluated once."""
        if key not in self.numbers:
            self.numbers[key] = [self.scene.number(part) for part in place]
        x, y = self.numbers[key]
        return x * self.scale, y * self.scale

    def rolling_radius(self, name: str) -> float:
        """The radius of a body's circle on paper; 0 of what has none."""
        body = self.scene.bodies.get(name)
        return self.scene.number(body.rolling_radius) * self.scale if body and body.rolling_radius else 0.0

    def rim(self, end: "str | Reference") -> Attachment | None:
        """The Attachment of what a rope, belt or gear runs about: the centre of a body's circle, or another place."""
        body = self.scene.bodies.get(end if isinstance(end, str) else getattr(end, "text", None))
        if body is None or body.name not in self.frames:
            return self.attachment(end)
        place = self._kept(("rim", body.name), self.scene.rim(body, body.record.where))
        return Attachment(body.name, place)

    def attachment(self, end: Any) -> Attachment | None:
        """The Attachment of an end: a place [x, y], or the name of a point or body; None without a place."""
        if isinstance(end, list):
            return Attachment(None, self.pair(end))
        if end.text in self.scene.bodies:
            return Attachment(end.text, self.centre(end.text)) if end.text in self.frames else None
        record = (self.spec.get("points") or {}).get(end.text)
        if record is None:
            return Attachment(end.text, self.frames[end.text].drawn) if end.text in self.frames else None
        carrier = record["body"].text if "body" in record else end.text if "moves" in record else None
        return Attachment(carrier, self.pair(record["at"]))

    def pivot(self, name: str) -> Attachment | None:
        """The Attachment of a body's pin, None of a body without one."""
        record = self.scene.bodies[name].record
        pin = record.get("pin")
        if pin is None:
            return None
        carrier = pin["carrier"].text if "carrier" in pin else None
        if "at" not in pin:
            return Attachment(carrier, self.centre(name))
        found = self.attachment(pin["at"])
        return Attachment(carrier or found.carrier, found.drawn)

    def pivots(self) -> dict[str, Attachment]:
        """{name: the Attachment of its pin} of bodies that have a place."""
        found = {name: self.pivot(name) for name in self.scene.bodies if name in self.frames}
        return {name: pivot for name, pivot in found.items() if pivot is not None}

    def frame(self, carrier: str | None) -> DrawnFrame:
        return STILL if carrier is None else self.frames[carrier]

    def now(self, attachment: Attachment) -> tuple[float, float]:
        """Where an Attachment is in this position."""
        return self.frame(attachment.carrier).point(attachment.drawn)

    def is_fixed(self, carrier: str | None) -> bool:
        """Does a carrier never move?"""
        return carrier is None or (carrier in self.scene.bodies and not self.scene.bodies[carrier].moves)
