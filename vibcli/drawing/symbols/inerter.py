"""Inerters: a rack at one end that turns a flywheel at the other one."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import ELEMENT, Circle, Polyline, Primitive
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols.damper import along_an_arc

if TYPE_CHECKING:
    from vibcli.drawing.symbols.joint import Turn
    from vibcli.language.reader import Record

NAMED_BY = "b", "torsion"
WHEEL, RACK, TEETH, TOOTH = 5.0, 11.0, 7, 1.8   # radius of the flywheel; half the rack, its teeth, their height


def between(_record: "Mapping[Any, Any] | Record", start: tuple[float, float], end: tuple[float, float],
            _drawn: float) -> list[Primitive]:
    """An inerter from one place to another."""
    return _inerter(plane.along(start, end), plane.distance(start, end))


def about(_record: "Mapping[Any, Any] | Record", turn: "Turn") -> Any:
    """The same along an arc about a joint; also where it is: (middle, normal)."""
    return along_an_arc(turn, _inerter)


def _inerter(at: Callable[..., tuple[float, float]], length: float) -> list[Primitive]:
    wheel = min(WHEEL, 0.2 * length)
    half, middle, low = min(RACK, 0.4 * length), 0.5 * length, -wheel - TOOTH
    tip = middle + half
    rack = [Polyline(_line(at, 0, middle - half) + _line(at, middle - half, tip, low), "damper")]
    step = 2 * half / TEETH
    teeth = [Polyline((at(middle - half + (i + 0.5) * step, low), at(middle - half + (i + 0.5) * step, low + TOOTH)),
                      "damper", 0.9) for i in range(TEETH)]
    return [*rack, *teeth, Circle(at(middle), wheel, "oil", "damper", layer=ELEMENT),
            Polyline(_line(at, middle, length), "damper"), Circle(at(middle), 0.25 * wheel, "damper", "damper",
                                                                  layer=ELEMENT)]


def _line(at: Callable[..., tuple[float, float]], start: float, end: float,
          offset: float = 0.0) -> tuple[tuple[float, float], ...]:
    """Places along it, beside its axis: as many as a line needs that may be bent."""
    return tuple(at(start + (end - start) * i / 6, offset) for i in range(7))
