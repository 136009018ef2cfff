"""Springs that act on one side or beyond a gap: what stands between the end of their coils and what they act on.

A plate before another one pushes when they meet, a cord pulls once it is taut, a pin in a slot does both at its ends.
"""

from math import pi, sin, sqrt
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.canvas.primitives import ELEMENT, JOINT, Circle, Polygon, Polyline
from vibcli.drawing.layout import plane

if TYPE_CHECKING:
    from collections.abc import Callable

    from vibcli.language.reader import Record

GAP, TOUCHING, PLATE, THICK = 12.0, 2.2, 6.0, 2.0   # a clearance as drawn, none; half a plate, its width
CORD, SLACK, SHORT, WAVE = 24.0, 0.35, 0.7, 5.5     # a cord; what it has to spare and may lose, in parts; its wave
STEPS = 16          # of which a cord consists, slack or taut
PIN, SLOT, STEM, LEAST = 1.7, 3.4, 5.0, 1.0     # the radius of a pin, half the width of its slot, what that is on; play


class Sign(NamedTuple):
    """What takes `room` at the end of a spring as drawn: how far in motion its coils are stretched, where the middle of
    the gap is, the primitives."""

    room: float
    stretch: float
    gap: float
    parts: list[Any]


def sign(record: "Record", at: "Callable[..., Any]", length: float, drawn: float, gap: float | None = None) -> Sign:
    """The Sign of a spring `length` long, `drawn` as drawn, at(s, t) being places along it and to its left; gap: as
    many points as it is in motion, none at rest, where it is only to be seen."""
    apart = "gap" in record
    if record.get("acts") == "compression":
        return _plates(at, length, drawn, min(GAP if apart else TOUCHING, 0.25 * drawn) if gap is None else
                       max(TOUCHING, min(gap, 0.5 * drawn)))
    room = min(CORD, 0.4 * drawn)
    if "acts" in record:
        return _cord(at, length - drawn, drawn - room, room, SLACK * room * apart if gap is None else gap)
    return _slot(at, length, drawn, min(GAP, 0.2 * drawn) / 2 if gap is None else max(LEAST, min(gap, 0.2 * drawn)))


def _plates(at: "Callable[..., tuple[float, float]]", length: float, drawn: float, play: float) -> Sign:
    stretch = min(length - drawn + play, 0.0)
    near = drawn - play + stretch
    return Sign(play, stretch, (near + length) / 2, [Polyline((at(s, PLATE), at(s, -PLATE)), "spring", THICK)
                                                     for s in (near, length)])


def _cord(at: "Callable[..., tuple[float, float]]", moved: float, free: float, room: float, spare: float) -> Sign:
    stretch = max(moved - spare, min(0.0, moved + SHORT * room))
    near, way = free + stretch, room + moved - stretch
    wave = min(sqrt(way * max(room + spare - way, 0.0)) / pi, WAVE)
    line = tuple(at(near + way * i / STEPS, wave * sin(2 * pi * i / STEPS)) for i in range(STEPS + 1))
    return Sign(room, stretch, near + way / 2, [Polyline(line, "rope", 1.4),
                                                Circle(at(near), 1.3, "ink", "ink", layer=JOINT)])


def _slot(at: "Callable[..., tuple[float, float]]", length: float, drawn: float, play: float) -> Sign:
    middle, moved = length - STEM - play - SLOT, length - drawn
    stretch, room = moved - max(-play, min(moved, play)), length - middle + play + SLOT + PIN
    pin = drawn - room + stretch + play + SLOT + PIN
    caps = [plane.arc((middle + side * play, 0.0), SLOT, (side - 2) * pi / 2, side * pi / 2) for side in (1, -1)]
    return Sign(room, stretch, middle, [
        Polygon(tuple(at(*place) for cap in caps for place in cap), "paper", "spring", layer=ELEMENT),
        Polyline((at(drawn - room + stretch), at(pin)), "spring"), Polyline((at(length - STEM), at(length)), "spring"),
        Circle(at(pin), PIN, "ink", "ink", layer=JOINT)])
