"""A column of liquid that moves along a U-tube: it rises in the right leg as its coordinate grows."""

from collections.abc import Mapping
from math import pi
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import BEHIND, ELEMENT, Polygon, Polyline
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.lumped_place import Layout, LumpedPlace
from vibcli.drawing.symbols import arrow

if TYPE_CHECKING:
    from vibcli.drawing.layout.rows import LumpedRow
    from vibcli.scene.scene import Scene

HALF, HEIGHT, BORE, ABOVE, LEFT = 34.0, 34.0, 9.0, 30.0, 40.0    # of the axis of the tube; half the bore


def is_one(row: "LumpedRow", scene: "Scene") -> bool:
    """Is a row one column of liquid?"""
    return len(row.bodies) == 1 and not row.gaps and not row.lanes and (
        scene.bodies[row.bodies[0]].record.get("looks") == "tube")


def layout(row: "LumpedRow", scene: "Scene", left: float, top: float) -> Layout:
    """The Layout of a tube from the upper left corner on."""
    place = LumpedPlace((left + LEFT + HALF, top - 26 - ABOVE - HEIGHT), HALF, HEIGHT, False)
    return Layout(row, {row.bodies[0]: place}, None, None, place.middle[1] - HEIGHT - HALF, top, "tube")


def draw(layout: Layout,
         moved: Mapping[str, float]) -> tuple[list[Any], dict[str, tuple[Any, ...]]]:
    """The tube and the liquid in it; `moved`: {body: displacement in points}."""
    (name, place), = layout.places.items()
    shift = max(-0.9 * HEIGHT, min(0.9 * HEIGHT, moved.get(name, 0.0)))
    (x, y), low = place.middle, place.middle[1] - HEIGHT
    level = y + HEIGHT
    walls = [_bend(x, low, HALF + side * BORE, level + ABOVE, level + ABOVE) for side in (1, -1)]
    liquid = [*_bend(x, low, HALF + BORE, level - shift, level + shift),
              *reversed(_bend(x, low, HALF - BORE, level - shift, level + shift))]
    rest = [Polyline(((x + side * HALF - BORE - 6, level), (x + side * HALF + BORE + 6, level)), "measure", 0.8, True,
                     ELEMENT) for side in (-1, 1)]
    return [Polygon(tuple(liquid), layer=BEHIND), *(Polyline(tuple(wall), width=1.8) for wall in walls), *rest], {}


def _bend(x: float, low: float, radius: float, left: float, right: float) -> list[tuple[float, float]]:
    """Down one leg to `low`, half round and up the other, from the height `left` to the height `right`."""
    return [(x - radius, left), *plane.arc((x, low), radius, pi, 2 * pi), (x + radius, right)]


def arrow_of(place: LumpedPlace, role: str) -> tuple[list[Any], tuple[float, float]]:
    """How far the liquid rises in the right leg, and where the name of that stands."""
    x, y = place.middle[0] + HALF + BORE + 12, place.middle[1] + HEIGHT
    return [Polyline(((x - 5, y), (x + 5, y)), role, 0.9, layer=arrow.ARROW),
            *arrow.straight((x, y), (x, y + 26), role)], (x, y + 26)


def load_on(place: LumpedPlace) -> tuple[list[Any], tuple[float, float]]:
    """A load on the liquid in the left leg, and where its name stands."""
    x, y = place.middle[0] - HALF, place.middle[1] + HEIGHT
    return arrow.straight((x, y + ABOVE + 8), (x, y + 3), "load", 1.7), (x, y + ABOVE + 10)
