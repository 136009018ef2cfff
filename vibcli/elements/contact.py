"""Contacts of a round body with a line or a circle that it rolls on.

Each knows how far the body has `rolled` as it turns (its travel along a line, the swing of the line of centres about a
circle), its frame, the normal n from the surface to the body, and how far both have parted along n and slipped along
the tangent t, which is n turned clockwise. The slip of the body's point of contact is

    on a line   (c − c₀)·e + s r θ          on a circle   ρ ψ − σ r θ, ψ being the turn of the line of centres
"""

from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.scene.places import Frame
    from vibcli.symbolic.node import Node


class LineContact(NamedTuple):
    """With a line of unit vector e: the body, its centre drawn at `drawn`, on the side s = ±1 of its left normal."""

    carrier: "Frame"
    drawn: "tuple[Node, Node]"
    radius: "Node"
    e: "tuple[Node, Node]"
    side: int

    @property
    def reach(self) -> "Node":
        """From the place of contact to the centre of the body, along n."""
        return self.radius

    def rolled(self, turn: "Node") -> "Node":
        """The travel of the centre, from the rotation in the fixed frame."""
        return -(turn - self.carrier.angle) * self.side * self.radius

    def turn(self, travel: "Node") -> "Node":
        """The rotation in the fixed frame."""
        return self.carrier.angle - travel * self.side / self.radius

    def frame(self, travel: "Node", turn: "Node") -> "Frame":
        """That of the body."""
        place = self.carrier.point(*(x + travel * e for x, e in zip(self.drawn, self.e, strict=True)))
        return self.carrier._replace(drawn=self.drawn, place=place, angle=turn)

    def normal(self, _: "Node") -> "tuple[Node, Node]":
        """n, the travel given."""
        return self.carrier.turned(-self.side * self.e[1], self.side * self.e[0])

    def parted(self, frame: "Frame", _: "Node | None") -> "tuple[Node, Node]":
        """(gap, slip) of a body with this frame."""
        (x0, y0), (ex, ey), (x, y) = self.drawn, self.e, self.carrier.seen(*frame.place)
        slip = (x - x0) * ex + (y - y0) * ey + self.side * self.radius * (frame.angle - self.carrier.angle)
        return self.side * ((y - y0) * ex - (x - x0) * ey), self.side * slip


class CircleContact(NamedTuple):
    """With a circle about `centre`: ρ and σ as in elements/roll.py, `outward` = 1 where n points away from the centre,
    else −1; `distance` of the centres as drawn."""

    carrier: "Frame"
    drawn: "tuple[Node, Node]"
    radius: "Node"
    centre: "tuple[Node, Node]"
    arm: "Node"
    sense: int
    outward: int
    distance: "Node"

    @property
    def reach(self) -> "Node":
        """From the place of contact to the centre of the body, along n."""
        return self.radius * self.sense * self.outward

    @property
    def middle(self) -> "tuple[Node, Node]":
        """Where the centre of the circle is now."""
        return self.carrier.point(*self.centre)

    def rolled(self, turn: "Node") -> "Node":
        """The swing of the line of centres, from the rotation in the fixed frame."""
        return (turn - self.carrier.angle) * self.radius * self.sense / self.arm

    def turn(self, swing: "Node") -> "Node":
        """The rotation in the fixed frame."""
        return self.carrier.angle + swing * self.arm * self.sense / self.radius

    def _line(self, swing: "Node") -> "Frame":
        """The frame of the line of centres."""
        return self.carrier._replace(drawn=self.centre, place=self.middle, angle=self.carrier.angle + swing)

    def _away(self) -> "tuple[Node, ...]":
        """The direction from the centre to the body as drawn."""
        return tuple((x - c) / self.distance for x, c in zip(self.drawn, self.centre, strict=True))

    def frame(self, swing: "Node", turn: "Node") -> "Frame":
        """That of the body."""
        return self.carrier._replace(drawn=self.drawn, place=self._line(swing).point(*self.drawn), angle=turn)

    def normal(self, swing: "Node") -> "tuple[Node, Node]":
        """n, the swing given."""
        return self._line(swing).turned(*(self.outward * d for d in self._away()))

    def parted(self, frame: "Frame", swing: "Node | None") -> "tuple[Node, Node]":
        """(gap, slip) of a body with this frame whose centre moves about that of the circle by `swing`; None of one
        that may leave its circle, where both are right to first order in themselves, and so wherever they are zero."""
        if swing is not None:
            return self.arm.table.zero, -self.outward * (self.arm * swing - self.sense * self.radius * (
                frame.angle - self.carrier.angle))
        due = self._line(self.rolled(frame.angle))
        (dx, dy), (ux, uy) = due.turned(*self._away()), (x - c for x, c in zip(frame.place, self.middle, strict=True))
        return self.outward * (ux * dx + uy * dy - self.arm), -self.outward * (uy * dx - ux * dy)
