"""Stations of members, and the line in the plane along which they are drawn."""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node


class Station(NamedTuple):
    """A place on a member, as it is written, and its motions: u or φ, the slope of beams, and in the plane that along
    (None where there is none)."""

    place: "Node"
    text: str
    u: "Node | None"
    slope: "Node | None" = None
    along: "Node | None" = None

    @property
    def motions(self) -> "list[Node]":
        """(u,), of beams (u, slope)."""
        return [self.u] if self.slope is None else [self.u, self.slope]

    @property
    def nodes(self) -> "list[Node]":
        """The motions that it has."""
        return [node for node in (self.u, self.slope, self.along) if node is not None]

    def over(self, new: "Mapping[Node, Node]") -> "Station":
        """Itself with its motions replaced, {node: node}."""
        u, slope, along = (None if node is None else new[node] for node in (self.u, self.slope, self.along))
        return self._replace(u=u, slope=slope, along=along)


class DrawnLine(NamedTuple):
    """From the place `start` along the unit vector (ex, ey); u counts to the left of it, along (−ey, ex)."""

    start: "tuple[Node, Node]"
    ex: "Node"
    ey: "Node"
    length: "Node"

    def drawn(self, place: "Node") -> "tuple[Node, Node]":
        """Where a place along it is drawn."""
        return self.start[0] + place * self.ex, self.start[1] + place * self.ey

    def displaced(self, along: "Node", across: "Node") -> "tuple[Node, Node]":
        """(x, y) of a displacement along and across."""
        return along * self.ex - across * self.ey, along * self.ey + across * self.ex

    def seen(self, x: "Node", y: "Node") -> "tuple[Node, Node]":
        """(along, across) of a displacement (x, y)."""
        return x * self.ex + y * self.ey, y * self.ex - x * self.ey


def line_of(record: "Record", scene: "Builder") -> DrawnLine | None:
    """The DrawnLine of a member drawn `from` a place `to` another; None of one without a place."""
    if "from" not in record:
        return None
    (x0, y0), (x1, y1) = scene.pair(record["from"]), scene.pair(record["to"])
    ex, ey = scene.unit(x1 - x0, y1 - y0, record.place("to"))
    return DrawnLine((x0, y0), ex, ey, scene.distance(x1 - x0, y1 - y0))
