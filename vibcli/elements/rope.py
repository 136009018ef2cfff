"""Ropes of constant length over and around pulleys and drums.

A free piece runs from a circle (centre c₁, radius r₁) to the next; σ = ±1 where the rope goes round counter-clockwise
or clockwise, 0 at a point. With w = c₂ − c₁ and ρ = σ₁r₁ − σ₂r₂ its length is ℓ = √(w² − ρ²), and with β its direction
the rope between the marks on two circles that turn by θ₁, θ₂ changes by

    δℓ + ρ δβ − σ₁r₁θ₁ + σ₂r₂θ₂ = 0.

On a body that turns the rope does not slip, so the conditions of the pieces on either side hold each for itself; over a
place or a body without rotation it slides freely, and their sum holds; so it does through a point, which holds it on
all sides as an eyelet does.
"""

from itertools import pairwise
from math import atan2, hypot, pi, sqrt, tau
from typing import TYPE_CHECKING

from vibcli.base.named_tuple import NamedTuple
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import PLACE, Many, NameOf, OneOf, Quantity, vector
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.normal_form import root_of_square, textbook

if TYPE_CHECKING:
    from vibcli.language.reader import Expression, Record, Reference
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

SIDES = {"over": (0, 1), "under": (0, -1), "left_of": (-1, 0), "right_of": (1, 0)}
ABOUT = ("a rope of constant length: [A, {under: drum}, {over: top, radius: r}, B]. Its ends are points or bodies, or "
         "a drum it is wound on; `over`, `under`, `left_of`, `right_of` say on which side it passes a body (without "
         "slip, if the body turns) or a place; through a point named without a side it slides as through an eyelet")

PULLEY = Element(
    "pulley of a rope",
    "What a rope passes, and on which side. The radius is that of the body's shape unless it is given; a place without "
    "one is a small smooth peg.",
    {side: Field(PLACE, f"the body or place that the rope passes {side.replace('_', ' ')}") for side in SIDES}
    | {"radius": Field(Quantity("m"), "the radius at which the rope runs")},
    exclusive=(tuple(SIDES),), needs=(tuple(SIDES),), example="ropes_and_links")
KIND = Many(OneOf("a point, a body, or a pulley such as {over: drum}",
                  scalar=NameOf("the name of a point or body", "points", "bodies"),
                  sequence=vector("m", "a place [x, y]"), mapping=PULLEY), 2, 50, "a list of two or more stops")


class Stop(NamedTuple):
    """A place that a rope passes or ends at: the centre of its circle now, its radius, on which side the rope passes,
    how far its rim turns, its sense σ."""

    centre: "tuple[Node, Node]"
    radius: "Node"
    side: tuple[int, int] | None
    turn: "Node | None"
    sense: int = 0

    @property
    def contact(self) -> "tuple[Node, Node]":
        """Where the rope about passes."""
        nx, ny = self.side or (0, 0)
        return self.centre[0] + self.radius * nx, self.centre[1] + self.radius * ny

    @property
    def reach(self) -> "Node":
        """σ r."""
        return self.radius * self.sense


def build(record: "Record", scene: "Builder") -> None:
    """One condition for each stretch of rope between bodies on which it does not slip."""
    stops = [_stop(item, scene) for item in record["rope"]]
    if None in stops:
        return
    stops = [stop if stop.side is None else stop._replace(sense=_sense(record, scene, stops, i))
             for i, stop in enumerate(stops)]
    if not (_sides_are_named(record, scene) and _touches(record, scene, stops)):
        return
    groups, total = [], scene.table.zero
    for one, two in pairwise(stops):
        total = total + _piece(record, scene, one, two)
        if two.turn is not None or two is stops[-1]:
            groups.append(total)
            total = scene.table.zero
    for number, node in enumerate(groups, 1):
        scene.add_constraint(record, node, "rope", f".{number}" if len(groups) > 1 else "")


def _sides_are_named(record: "Record", scene: "Builder") -> bool:
    """Is a side named of each round body that the rope passes?"""
    for item in record["rope"][1:-1]:
        body = scene.bodies.get(getattr(item, "text", None))
        if body is not None and body.rolling_radius is not None:
            scene.report(item.where, f"on which side the rope '{record.name}' passes '{body.name}' is not said",
                         f"write {{over: {body.name}}}, or under, left_of, right_of")
            return False
    return True


def _touches(record: "Record", scene: "Builder", stops: list[Stop]) -> bool:
    """Does the taut rope lie against every pulley on the side that is named, as drawn?"""
    directions = []
    for one, two in pairwise(stops):
        x, y = (scene.number(b - a) for a, b in zip(one.centre, two.centre, strict=True))
        offset = scene.number(one.reach - two.reach)
        length = sqrt(max(hypot(x, y) ** 2 - offset**2, 0.0))
        directions.append(atan2(y, x) + atan2(offset, length))
    for i, (arriving, leaving) in enumerate(pairwise(directions), 1):
        stop = stops[i]
        if stop.side is None:
            continue
        sense = stop.sense or _sense(record, scene, stops, i, peg=True)
        wrap = (leaving - arriving) * sense % tau
        if 1.25 * pi < wrap < tau - 1e-9:
            scene.report(record["rope"][i].where, f"the rope '{record.name}', drawn taut, does not touch this pulley",
                         "name the other side, or draw the pulley where the rope bends round it")
            return False
    return True


def _stop(item: "Record | list[Expression] | Reference", scene: "Builder") -> Stop | None:
    """A Stop; None where it was reported as wrong."""
    if not isinstance(item, dict):
        return Stop(scene.place_of(item), scene.table.zero, None, None)
    side = next(side for side in SIDES if side in item)
    body = scene.bodies.get(getattr(item[side], "text", None))
    radius = body.rolling_radius if body is not None else scene.table.zero
    if "radius" in item:
        radius = scene.positive(item["radius"], "the radius of a pulley")
    if radius is None:
        scene.report(item.where, f"'{item[side].text}' has no radius for the rope", "give `radius`, or a round shape")
        return None
    if body is None or body.frame is None:
        return Stop(scene.place_of(item[side]), radius, SIDES[side], None)
    centre = body.frame.point(*scene.rim(body, item.where))
    return Stop(centre, radius, SIDES[side], body.frame.angle if scene.turns(body) else None)


def _sense(record: "Record", scene: "Builder", stops: list[Stop], i: int, peg: bool = False) -> int:
    """+1 where the rope goes round counter-clockwise, from its first end to its last; 0 of a peg without radius."""
    if not (peg or scene.number(stops[i].radius)):
        return 0
    before, after = stops[max(i - 1, 0)], stops[min(i + 1, len(stops) - 1)]
    if i in (0, len(stops) - 1):
        dx, dy = (scene.number(b - a) for a, b in zip(before.centre, after.centre, strict=True))
    else:
        dx, dy = (scene.number(b - a) for a, b in zip(before.contact, after.contact, strict=True))
    nx, ny = stops[i].side
    across = nx * dy - ny * dx
    if abs(across) <= 1e-9 * (abs(dx) + abs(dy)):
        scene.report(record.where, f"which way the rope '{record.name}' goes round its pulley is not clear",
                     "name another side: over, under, left_of, right_of")
    return 1 if across > 0 else -1


def _piece(record: "Record", scene: "Builder", one: Stop, two: Stop) -> "Node":
    """δℓ + ρ δβ − σ₁r₁θ₁ + σ₂r₂θ₂ of a free piece."""
    wx, wy = (b - a for a, b in zip(one.centre, two.centre, strict=True))
    offset = one.reach - two.reach
    x0, y0 = scene.at_drawn(wx, wy)
    square = textbook(x0 * x0 + y0 * y0)
    if not scene.number(square - offset * offset) > 0:
        scene.report(record.where, f"the rope '{record.name}' has no free piece between two of its stops as drawn",
                     "draw them farther apart, or mind the radii")
        return scene.table.zero
    drawn = _root(scene, textbook(square - offset * offset))
    ex, ey = _direction(scene, textbook(drawn * x0 - offset * y0) / square, textbook(drawn * y0 + offset * x0) / square)
    across, = substitute([wx * ey - wy * ex - offset], dict.fromkeys(scene.supports, scene.table.zero))
    if scene.vanishes(across):      # what supports give way by lengthens it along itself, to first order
        along = textbook(wx * ex + wy * ey)
        change = along - scene.at_drawn(along)[0]
    elif offset.is_zero:
        change = scene.distance(wx, wy) - drawn
    else:
        table = scene.table
        length = _root(scene, textbook(wx * wx + wy * wy - offset * offset))
        turned = table.call("atan2", x0 * wy - y0 * wx, x0 * wx + y0 * wy)
        change = length - drawn + offset * (turned + table.call("atan2", offset, length)
                                            - table.call("atan2", offset, drawn))
    for stop, sign in ((one, -1), (two, 1)):
        if stop.turn is not None:
            change = change + sign * stop.reach * stop.turn
    return change


def _direction(scene: "Builder", ex: "Node", ey: "Node") -> "tuple[Node, Node]":
    """A unit vector, exactly along an axis where it is so but for rounding."""
    table, (x, y) = scene.table, (scene.number(ex), scene.number(ey))
    if abs(x) <= 1e-12:
        return table.zero, table.number(1 if y > 0 else -1)
    if abs(y) <= 1e-12:
        return table.number(1 if x > 0 else -1), table.zero
    return ex, ey


def _root(scene: "Builder", square: "Node") -> "Node":
    """√square, without a root where it is a perfect square."""
    root = root_of_square(square)
    return square.table.sqrt(square) if root is None else scene.absolute(root)
