"""Looks of bodies without a shape that turn about a pin: pendulums, hubs, arms."""

from collections.abc import Sequence
from math import tau
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import BEHIND, BODY, Polygon, Polyline, Primitive
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols.look import BALL, ROD, Look, ball, centre_mark

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.drawing.layout.ties import Ties
    from vibcli.elements.rigid_body import Body

HUB, BEYOND = 11.0, 26.0
STRAIGHT = 1.0 - 1e-6       # the cosine of the angle between places on one line


def pinned(body: "Body", centre: Any, pivot: Any, sketch: "Sketch", ties: "Ties") -> Look:
    """A pendulum, a hub or an arm."""
    carried = [place for place in ties.carried.get(body.name, ()) if plane.distance(place, centre) > 1e-6]
    slots = ties.slots.get(body.name, ())
    if plane.distance(centre, pivot) < 1e-6:
        far = sorted(plane.distance(centre, place) for place in carried)
        if body.name in ties.arms:
            return Look([Polygon(tuple(plane.capsule(centre, place, ROD + 1))) for place in carried] or
                        [ball(centre, HUB)], "arm")
        if far and not slots and far[-1] - far[0] < 1e-6 * far[-1]:
            return Look([ball(centre, far[0] + 5)], "wheel")
        radius = HUB if body.inertia is not None or not slots else 3.0
        return Look([*rail(centre, slots), ball(centre, radius)], "hub")
    if body.mass is None and body.inertia is None:
        along = plane.unit(plane.minus(centre, pivot))
        beyond = [place for place in carried if plane.dot(plane.unit(plane.minus(place, pivot)), along) > STRAIGHT]
        end = max([centre, *beyond], key=lambda place: plane.distance(pivot, place))
        return Look([Polyline((pivot, end), width=2.4, layer=BODY), *rail(centre, slots)], "arm")
    if {"inertia", "gyration"} & set(body.record):
        return _blob(pivot, centre)
    bob = ball(centre, BALL + 1.5)
    return Look([Polyline((pivot, centre), width=1.6, layer=BEHIND), bob, *rail(centre, slots)], "bob", bob.points)


def _blob(pivot: tuple[float, float], centre: tuple[float, float]) -> Look:
    """A body of any form about its pin and its mass centre."""
    length = plane.distance(pivot, centre)
    low, high = -10.0, length + min(40.0, max(12.0, 0.35 * length))
    a, b = (high - low) / 2, min(40.0, max(12.0, 0.26 * (high - low)))
    at = plane.along(pivot, centre)
    points = [at((low + high) / 2 + a * x, b * y * (1 + 0.35 * x)) for x, y in
              [plane.polar((0, 0), 1.0, tau * i / 60) for i in range(60)]]
    return Look([Polygon(tuple(points)), *centre_mark(centre)], "blob")


def rail(origin: tuple[float, float],
         slots: Sequence[tuple[tuple[float, float], tuple[float, float]]]) -> list[Primitive]:
    """The straight rods along which others slide."""
    if not slots:
        return []
    direction = slots[0][1]
    reach = [plane.dot(plane.minus(place, origin), direction) for place, _ in slots]
    low, high = min([0.0, *reach]), max([0.0, *reach])
    if high - low < 1e-6:
        low, high = -2 * BEYOND, 2 * BEYOND
    else:
        low, high = (low - BEYOND if low < 0 else 0.0), (high + BEYOND if high > 0 else 0.0)
    offset = plane.minus(slots[0][0], origin)
    base = plane.plus(origin, plane.minus(offset, plane.times(direction, plane.dot(offset, direction))))
    return [Polyline((plane.plus(base, direction, low), plane.plus(base, direction, high)), width=2.4, layer=BEHIND)]
