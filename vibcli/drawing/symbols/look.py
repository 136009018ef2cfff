"""What a placed body looks like: outlines as drawn, which its frame then carries along."""

from collections.abc import Sequence
from math import tau
from typing import Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.canvas.primitives import JOINT, Circle, Polygon, Polyline, Primitive
from vibcli.drawing.layout import plane

ROD, BALL = 3.2, 5.0            # half the thickness of a rod, the radius of a particle
PITCH, TOOTH = 7.0, 1.7         # of a gear: from tooth to tooth along its circle, half the height of a tooth


class Look(NamedTuple):
    """Primitives of a body as drawn; its `core` is a polygon at whose edge springs end, None where they run to the
    very place; `kind` says what it is drawn as; `angle` is that of a block."""

    pieces: list[Any]
    kind: str
    core: Sequence[tuple[float, float]] | None = None
    angle: float = 0.0
    width: float = 0.0
    height: float = 0.0

    @property
    def outlines(self) -> list[Circle | Polygon]:
        return [part for part in self.pieces if not isinstance(part, Polyline)]

    def area(self) -> float:
        return max((plane.area(list(part.points)) for part in self.outlines), default=0.0)


def ball(centre: tuple[float, float], radius: float) -> Polygon:
    return Polygon(tuple(plane.circle(centre, radius)))


def centre_mark(centre: tuple[float, float]) -> list[Primitive]:
    """The mass centre of a body."""
    return [Circle(centre, 2.0, "ink", layer=JOINT)]


def teeth(points: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """The outline of a gear about its pitch circle."""
    left, bottom, right, top = plane.bounds(points)
    centre, radius = ((left + right) / 2, (bottom + top) / 2), (right - left) / 2
    count = max(8, round(tau * radius / PITCH))
    found = []
    for i in range(count):
        for part, side in ((0.0, -1), (0.12, 1), (0.5, 1), (0.62, -1)):
            found.append(plane.polar(centre, radius + side * TOOTH, tau * (i + part) / count))
    return found
