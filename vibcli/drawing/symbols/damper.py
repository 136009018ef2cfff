"""Dampers: a dashpot between two ends, or a pad on a plate where its friction is dry; both also bent about a joint."""

from collections.abc import Callable, Mapping
from math import pi, tau
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import ELEMENT, Polygon, Polyline, Primitive
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols import parts, support

if TYPE_CHECKING:
    from vibcli.drawing.symbols.joint import Turn
    from vibcli.language.reader import Record

NAMED_BY = "c", "torsion", "friction"
CUP, HALF = 13.0, 5.5
PAD, PLATE = 11.0, 26.0         # lengths of what rubs
ARC, SPAN = 24.0, 0.62 * pi     # the radius of an arc about a joint, its angle


def between(record: "Mapping[Any, Any] | Record", start: tuple[float, float], end: tuple[float, float],
            drawn: float) -> list[Primitive]:
    """A damper from one place to another, or its parts."""
    shape = _pad if "friction" in record else _dashpot

    def single(start: "tuple[float, float]", end: "tuple[float, float]", _drawn: float,
               scale: float) -> "list[Primitive]":
        return shape(plane.along(start, end), plane.distance(start, end), scale)

    return parts.between(record, start, end, drawn, "damper", single)


def about(record: "Record", turn: "Turn") -> tuple[list[Any], tuple[plane.Place, plane.Place]]:
    """The same along an arc about a joint; also where it is: (middle, normal)."""
    return along_an_arc(turn, _pad if "friction" in record else _bent)


def along_an_arc(turn: "Turn", drawn: Callable[[Callable[..., plane.Place], float],
                                               list[Primitive]]) -> tuple[list[Any], tuple[plane.Place, plane.Place]]:
    """What `drawn(at, length)` draws along an arc about a joint, to a wall on the ground; also where it is."""
    start, held = turn.held or (0.0, 0.0)
    span = (start - turn.heading) % tau
    span = span if turn.held and 0.3 * pi < span < 1.7 * pi else SPAN
    begin, end = turn.heading - span + held, turn.heading + turn.moved
    wall = [] if turn.held else support.wall(plane.polar(turn.centre, ARC, begin),
                                             plane.polar((0.0, 0.0), 1.0, begin - pi / 2), 6.0)
    middle = (begin + end) / 2
    where = plane.polar(turn.centre, ARC + 7, middle), plane.polar((0, 0), 1.0, middle)
    return [*drawn(plane.around(turn.centre, ARC, begin), ARC * (end - begin)), *wall], where


def _bent(at: Callable[..., tuple[float, float]], length: float) -> list[Primitive]:
    found = _dashpot(at, length)
    rod = found[-1]
    steps = [length * i / 12 for i in range(13)]
    back = rod.points[0]
    lead = tuple(at(s) for s in steps if s < 0.35 * length)
    tail = (back, *(at(s) for s in steps if s > 0.6 * length))
    return [found[0]._replace(points=(*lead, found[0].points[-1])), *found[1:-1], rod._replace(points=tail)]


def _dashpot(at: Callable[..., tuple[float, float]], length: float, scale: float = 1.0) -> list[Primitive]:
    cup, half = min(CUP, 0.5 * length), scale * HALF
    near, far = 0.5 * (length - cup), 0.5 * (length + cup)
    piston = near + 0.55 * cup
    inner = Polygon((at(near, half), at(far, half), at(far, -half), at(near, -half)), "oil", "oil", 0.1, layer=ELEMENT)
    return [Polyline((at(0), at(near)), "damper"), inner,
            Polyline((at(far, half), at(near, half), at(near, -half), at(far, -half)), "damper"),
            Polyline((at(piston, half - 1.2), at(piston, 1.2 - half)), "damper", 1.8),
            Polyline((at(piston), at(length)), "damper")]


def _pad(at: Callable[..., tuple[float, float]], length: float, scale: float = 1.0) -> list[Primitive]:
    """A pad at the far end that is pressed on a plate at the near one."""
    pad, plate, low = min(PAD, 0.3 * length), min(PLATE, 0.7 * length), -scale * HALF
    middle, foot = 0.5 * length, 0.4 * low
    left, right = middle - 0.5 * plate, middle + 0.5 * plate
    near, far = middle - 0.5 * pad, middle + 0.5 * pad
    return [Polyline(tuple(at(s) for s in _steps(0.0, left)) + tuple(at(s, foot) for s in _steps(left, right)),
                     "damper"),
            Polygon((at(near, -low), at(far, -low), at(far, foot), at(near, foot)), "oil", "damper", layer=ELEMENT),
            Polyline(tuple(at(s) for s in _steps(far, length)), "damper")]


def _steps(start: float, end: float) -> list[float]:
    """Places along it: as many as a line needs that may be bent."""
    return [start + (end - start) * i / 6 for i in range(7)]
