"""Ropes that hang from a fixed place and that a scene does not name: a wheel goes up and down along one, about which it
turns without slip."""

from collections.abc import Sequence
from math import hypot
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.layout import implied, plane

if TYPE_CHECKING:
    from vibcli.drawing.layout.implied import Implied
    from vibcli.drawing.layout.sketch import Attachment, Sketch

ABOVE = 1.6         # radii of the wheel to the fixed place, at least


class Standing(NamedTuple):
    """A wheel, its radius on paper, where the rope is fixed, the sense in which it goes on around the wheel, and what
    is fastened to its other end, if anything."""

    wheel: str
    radius: float
    top: tuple[float, float]
    sense: int
    weight: str | None


def ropes(sketch: "Sketch", known: "list[Implied]", ends: "list[tuple[Attachment, Attachment]]") -> list[Standing]:
    """The Standing ropes of wheels that expressions move; `known`: ropes that are implied between bodies."""
    down = [sketch.scene.number(part) for part in sketch.scene.gravity or ()]
    if not down or not hypot(*down):
        return []
    up, found = plane.times(plane.unit(down), -1), []
    roped = _roped(sketch)
    for name, body in sketch.scene.bodies.items():
        free = name in sketch.frames and name not in roped and "move" in body.record
        radius = sketch.rolling_radius(name) if free else 0.0
        side = _still_side(implied.rates_of(sketch, name), up, radius / sketch.scale) if radius else 0
        if side:
            found.append(_rope(name, radius, plane.times(plane.left(up), side), up, sketch, known, ends))
    return found


def _roped(sketch: "Sketch") -> set[str]:
    """Bodies about which ropes run that the scene names."""
    stops = [stop for record in (sketch.spec.get("constraints") or {}).values() for stop in record.get("rope", ())]
    return {getattr(end, "text", None) for stop in stops if hasattr(stop, "values") for end in stop.values()}


def _still_side(rates: Sequence[tuple[float, float, float]], up: tuple[float, float], radius: float) -> int:
    """1 where the rim stands still on the left of a wheel that goes up and down, −1 on its right; 0 elsewhere."""
    moving = [rate for rate in rates if any(rate)]
    for side in (1, -1):
        if moving and all(abs(plane.across(up, (x, y))) < implied.CLOSE and abs(
                plane.dot((x, y), up) - side * radius * turn) < implied.CLOSE * hypot(x, y) for x, y, turn in moving):
            return side
    return 0


def _rope(wheel: str, radius: float, side: tuple[float, float], up: tuple[float, float], sketch: "Sketch",
          known: "Sequence[Implied]", ends: "Sequence[tuple[Attachment, Attachment]]") -> Standing:
    """The rope at one side of a wheel, as high as the highest fixed place; to what is fastened to its rim."""
    centre = sketch.rim(wheel).drawn
    high = [plane.dot(plane.minus(end.drawn, centre), up) for pair in ends for end in pair
            if sketch.is_fixed(end.carrier) or end.carrier in sketch.moving_points]
    top = plane.plus(plane.plus(centre, side, radius), up, max([ABOVE * radius, *high]))
    other = plane.plus(centre, side, -radius)
    weight = next((rope.weight for rope in known if rope.wheel == wheel and plane.distance(
        sketch.centre(rope.weight), other) < implied.CLOSE * radius), None)
    return Standing(wheel, radius, top, 1 if plane.across(side, up) < 0 else -1, weight)
