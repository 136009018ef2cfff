"""Springs: a zigzag between two ends, an elastic shaft, a spiral about a joint."""

from math import pi, tau
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import ELEMENT, Polygon, Polyline, Primitive
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols import parts, support

if TYPE_CHECKING:
    from vibcli.drawing.symbols.joint import Turn
    from vibcli.language.reader import Record

WIDTH, COIL, LEAD, MOST = 5.0, 6.5, 7.0, 16     # half the width of a zigzag, a coil, a straight end; coils
NAMED_BY = "k", "torsion"
SHAFT, SPIRAL = 2.4, 12.5      # half the thickness of a shaft, the radius of a spiral


def between(record: "Record", start: tuple[float, float], end: tuple[float, float],
            drawn: float, gap: float | None = None) -> list[Primitive]:
    """A zigzag, with its gap, which in motion is so many points wide; an elastic shaft from the side where it is
    twisted; its parts, if it has any."""
    if "torsion" in record:
        return _shaft(start, end)
    if "acts" not in record and "gap" not in record:
        return parts.between(record, start, end, drawn, "spring", _zigzag)
    from vibcli.drawing.symbols.one_sided import sign

    at = plane.along(start, end)
    shown = sign(record, at, plane.distance(start, end), drawn, gap)
    free = drawn - shown.room
    return shown.parts + parts.between(record, start, at(free + shown.stretch), free, "spring", _zigzag)


def about(_record: Any,
          turn: "Turn") -> tuple[list[Primitive], tuple[tuple[float, float], tuple[float, float]]]:
    """A spiral about a joint, to a wall where the ground holds it; also where it is: (middle, normal)."""
    radius = SPIRAL + 6.0 * turn.rank
    start, held = turn.held or (turn.heading + pi / 2 + 0.35 * pi * turn.rank, 0.0)
    found = _spiral(turn.centre, turn.heading + turn.moved, start + held, radius)
    if turn.held is None:
        found += support.wall(plane.polar(turn.centre, radius, start), plane.polar((0.0, 0.0), 1.0, start), 6.0)
    beside = start + pi / 3
    return found, (plane.polar(turn.centre, radius + 3, beside), plane.polar((0, 0), 1.0, beside))


def _shaft(start: tuple[float, float], end: tuple[float, float]) -> list[Primitive]:
    at, length = plane.along(start, end), plane.distance(start, end)
    return [Polygon((at(0, SHAFT), at(length, SHAFT), at(length, -SHAFT), at(0, -SHAFT)), "paper", "spring",
                    layer=ELEMENT)]


def _zigzag(start: tuple[float, float], end: tuple[float, float], drawn: float, scale: float = 1.0) -> list[Primitive]:
    """The coils and straight ends that fit the length `drawn`."""
    length, at = plane.distance(start, end), plane.along(start, end)
    coils = max(3, min(MOST, round(drawn / COIL) - 2))
    lead = min(max(LEAD, (drawn - 1.2 * COIL * MOST) / 2), 0.15 * drawn if drawn < 80 else 0.4 * drawn)
    lead = min(lead, 0.4 * length)
    step = (length - 2 * lead) / coils
    points = [start, at(lead)]
    for i in range(coils):
        points += [at(lead + (i + 0.25) * step, scale * WIDTH), at(lead + (i + 0.75) * step, -scale * WIDTH)]
    return [Polyline((*points, at(length - lead), end), "spring")]


def _spiral(centre: tuple[float, float], from_angle: float, to_angle: float, radius: float) -> list[Primitive]:
    """From its core to the two that it turns."""
    turns = tau + (to_angle - from_angle) % tau
    turns += tau * (turns < 3 * pi)
    count = 70
    points = [plane.polar(centre, 4.0 + (radius - 4.0) * i / count, from_angle + turns * i / count)
              for i in range(count + 1)]
    return [Polyline(tuple(points), "spring")]
