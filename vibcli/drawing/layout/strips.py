"""Members on paper: those in the plane where they are drawn, the others below one another, each along its own line."""

from bisect import bisect_right
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.layout import plane
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.elements.member import Member
    from vibcli.scene.scene import Scene

LONGEST, LEAST, ROW, MARGIN = 250.0, 110.0, 96.0, 50.0     # points: lengths of members without a place, their distance
SAME = 1e-9                                                 # of a length: nearer places are one
STEPS = 60                                                  # places along a member at which its curve is drawn
THICK, THINNEST = 3.6, 0.45                                 # half the thickness, the thinnest segment in its parts
POWERS = {"bar": 0.5, "shaft": 0.25, "beam": 0.25}          # of the stiffness that the thickness shows


class Strip(NamedTuple):
    """A member on paper: from `start` along the unit vector `e`, `length` points long, one metre being `scale` points;
    `places` of its stations and `segments` [(from, to, half the thickness)] in metres; `placed` in the plane?"""

    name: str
    member: Any
    start: tuple[float, float]
    e: tuple[float, float]
    scale: float
    metres: float
    places: list[float]
    segments: list[tuple[float, float, float]]
    placed: bool

    def at(self, x: float, side: float = 0.0, along: float = 0.0) -> tuple[float, float]:
        """The place on paper of x metres from the left end, `side` points to the left of the line."""
        return plane.plus(plane.plus(self.start, self.e, x * self.scale + along), plane.left(self.e), side)

    @property
    def end(self) -> tuple[float, float]:
        return self.at(self.metres)

    def half(self, x: float) -> float:
        """Half the thickness at a place."""
        return next((half for _, high, half in self.segments if x <= high * (1 + 1e-9)), self.segments[-1][2])

    @property
    def sideways(self) -> bool:
        """Does it move across its line as drawn?"""
        return self.member.kind.name in ("beam", "string")

    @property
    def bedded(self) -> bool:
        """Does it press springs on the ground as it moves?"""
        return self.sideways and not all(part.foundation.is_zero for part in self.member.segments)


def strips(sketch: "Sketch", left: float, top: float) -> list[Strip]:
    """The Strips of all members; those without a place from the corner (left, top) downwards."""
    found, free = [], []
    scene = sketch.scene
    for name, member in scene.members.items():
        if member is not None and member.lengthwise and not member.turns:
            continue        # a beam as it stretches, which is drawn as it bends too
        if member is not None and member.line is not None:
            line = member.line
            x, y, ex, ey = (scene.number(part) for part in (*line.start, line.ex, line.ey))
            found.append(_strip(name, member, (x * sketch.scale, y * sketch.scale), (ex, ey), sketch.scale, scene))
        elif member is not None:
            free.append((name, member))
    most = max((scene.number(member.length) for _, member in free), default=1.0)
    y = top - ROW / 2
    for name, member in free:
        metres = scene.number(member.length)
        points = max(LEAST, LONGEST * metres / most)
        found.append(_strip(name, member, (left + MARGIN, y), (1.0, 0.0), points / metres, scene))
        y -= ROW
    return found


def _strip(name: str, member: "Member", start: tuple[float, float], e: tuple[float, float], scale: float,
           scene: "Scene") -> Strip:
    number = scene.number
    sizes = [1.0 if part.stiffness is None else max(number(part.stiffness), 1e-300) for part in member.segments]
    power, most = POWERS.get(member.kind.name, 0.0), max(sizes)
    thick = THICK * (1.5 if len(set(sizes)) > 1 else 1.0)
    segments = [(number(part.start), number(part.end), thick * max(THINNEST, (size / most) ** power))
                for part, size in zip(member.segments, sizes, strict=True)]
    return Strip(name, member, start, e, scale, number(member.length),
                 [number(station.place) for station in member.stations], segments, member.line is not None)


def resting(strip: Strip, values: Mapping[str, float]) -> Callable[[Sequence[float]], list[tuple[float, float]]]:
    """[(along, u)] in metres or radians at places of a member, as its stations are at `values` and it is without
    inertia: beams as cubics, what does not bend straight between."""
    member = strip.member
    zero = member.length.table.zero
    nodes = [zero if node is None else node for station in member.stations
             for node in (station.along, station.u, station.slope)]
    flat = evaluate(nodes, Floats, values)
    rows = [flat[i:i + 3] for i in range(0, len(flat), 3)]

    def at(places: "Sequence[float]") -> "list[tuple[float, float]]":
        return [_between(strip.places, rows, x, member.kind.bends) for x in places]

    return at


def _between(places: list[float], rows: Sequence[list[float]], x: float, bends: bool) -> tuple[float, float]:
    if len(places) < 2:
        return (rows[0][0], rows[0][1]) if rows else (0.0, 0.0)
    i = min(max(bisect_right(places, x) - 1, 0), len(places) - 2)
    (a0, u0, s0), (a1, u1, s1) = rows[i], rows[i + 1]
    length = places[i + 1] - places[i]
    t = (x - places[i]) / length
    along = a0 + t * (a1 - a0)
    if not bends:
        return along, u0 + t * (u1 - u0)
    h = t * t * (3 - 2 * t)
    return along, u0 + h * (u1 - u0) + length * (t * (1 - t) ** 2 * s0 - t * t * (1 - t) * s1)


def grid(strip: Strip, more: Sequence[float] = ()) -> list[float]:
    """Places along a member, its stations among them."""
    places = sorted({*(strip.metres * i / STEPS for i in range(STEPS + 1)), *strip.places, *more})
    return [x for i, x in enumerate(places) if not i or x - places[i - 1] > SAME * strip.metres]
