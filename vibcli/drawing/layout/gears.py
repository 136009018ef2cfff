"""Gears among bodies without a place: what turns against another body in a fixed ratio, or moves a rack."""

from collections.abc import Sequence
from math import remainder, sin, tau
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.canvas.primitives import BODY, ELEMENT, Circle, Polygon, Polyline, Primitive
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.lumped_place import LumpedPlace
from vibcli.drawing.symbols.look import teeth
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

CLOSE, SUM, LEAST = 1e-9, 56.0, 0.2     # of the ratio; of two radii in points, the smaller in parts of it
PINION, PITCH, TOOTH = 12.0, 5.0, 1.7   # points


class Mesh(NamedTuple):
    """A body that turns and what it drives by its teeth, which moves `ratio` times as fast: a gear, or a rack."""

    gear: str
    mate: str
    ratio: float
    rack: bool


def meshes(scene: "Scene") -> list[Mesh]:
    """The gears of bodies without a place that are in different rows: each body that expressions of another's
    coordinate move, and that; of those that gears and belts tie the ones that gear; what slides is a rack where it
    looks like a bar."""
    lumped = {name: body for name, body in scene.bodies.items() if body.lumped is not None}
    rates = {name: _rates(body.lumped[1], scene) for name, body in lumped.items()}
    found: list[Mesh] = []
    racks: set[str] = set()
    geared, trains = _tied(scene, "gear"), _trains(_tied(scene, "gear", "belt"))
    for name, body in lumped.items():
        for other in lumped:
            ratio = None if other == name else _ratio(rates[other], rates[name])
            if ratio is None or {name, other} in [{mesh.gear, mesh.mate} for mesh in found]:
                continue
            if {name, other} not in geared and any({name, other} <= train for train in trains):
                continue
            turns = [lumped[one].lumped[0] == "turn" for one in (other, name)]
            if turns == [True, True] and ratio < 0:
                found.append(Mesh(other, name, ratio, False))
            elif turns == [True, False] and body.record.get("looks") == "bar" and name not in racks:
                racks.add(name)
                found.append(Mesh(other, name, ratio, True))
    return found


def _tied(scene: "Scene", *kinds: str) -> list[set[str]]:
    """The pairs of bodies that constraints of some kinds tie."""
    return [{name.text for name in record[kind]} for record in (scene.spec.get("constraints") or {}).values()
            for kind in kinds if kind in record]


def _trains(pairs: Sequence[set[str]]) -> list[set[str]]:
    """The sets of bodies that pairs join."""
    trains: list[set[str]] = []
    for pair in pairs:
        met = [train for train in trains if train & pair]
        trains = [train for train in trains if train not in met] + [pair.union(*met)]
    return trains


def wound(scene: "Scene") -> list[tuple[str, str]]:
    """[(what turns, what slides as far as its rim)] of bodies without a place, other than racks: a rope joins them."""
    lumped = {name: body for name, body in scene.bodies.items() if body.lumped is not None}
    rates = {name: _rates(body.lumped[1], scene) for name, body in lumped.items()}
    racks = {mesh.mate for mesh in meshes(scene) if mesh.rack}
    found = [(drum, load) for load, body in lumped.items() if body.lumped[0] == "slide" and load not in racks
             for drum, other in lumped.items() if other.lumped[0] == "turn" and _ratio(rates[drum], rates[load])]
    return list({load: (drum, load) for drum, load in reversed(found)}.values())     # the first drum of each


def _rates(node: "Node", scene: "Scene") -> list[float]:
    """How fast a body moves with each coordinate and with the time, as drawn."""
    slopes = gradient(node)
    values = {**scene.sample, **scene.drawn_values}
    return evaluate([slopes.get(q, scene.table.zero) for q in scene.q], Floats, values)


def _ratio(one: Sequence[float], two: Sequence[float]) -> float | None:
    """The factor by which one body moves faster than the other wherever either moves; None where there is none."""
    pairs = [(a, b) for a, b in zip(one, two, strict=True) if a or b]
    if not pairs or any(not a or not b for a, b in pairs):
        return None
    ratios = [b / a for a, b in pairs]
    return ratios[0] if max(ratios) - min(ratios) <= CLOSE * abs(ratios[0]) else None


def radii(mesh: Mesh) -> tuple[float, float]:
    """The radii in points of two gears: as their ratio, neither too small to be seen."""
    share = min(1 - LEAST, max(LEAST, 1 / (1 + abs(mesh.ratio))))
    return SUM * (1 - share), SUM * share


def sizes(mesh: Mesh) -> dict[str, float]:
    """The same by the names of both."""
    one, two = radii(mesh)
    return {mesh.gear: one, mesh.mate: two}


def edges(place: LumpedPlace, angle: float) -> list[Primitive]:
    """The teeth of a gear seen from the side, which go round with it."""
    (x, y), count = place.middle, max(6, round(tau * place.height / PITCH))
    turned = remainder(angle, tau) - 0.75 * tau
    angles = [turned + tau * i / count for i in range(3 * count // 2 + 1)]
    levels = [y + place.height * sin(min(tau / 4, max(-tau / 4, turn))) for turn in angles]    # those behind at the rim
    return [Polyline(((x - place.half, level), (x + place.half, level)), width=0.7, layer=BODY) for level in levels]


def rack(place: LumpedPlace, still: LumpedPlace) -> list[Any]:
    """A toothed rod on a body, and from the front the pinion on it, which turns in its place."""
    x, top = place.middle[0], place.middle[1] + place.height
    points, left = [], x - place.half
    for i in range(int(2 * place.half / PITCH)):
        a = left + i * PITCH
        points += [(a, top), (a + 0.15 * PITCH, top + 2 * TOOTH), (a + 0.5 * PITCH, top + 2 * TOOTH),
                   (a + 0.65 * PITCH, top)]
    hub = still.middle[0] - 0.5 * still.half, still.middle[1] + still.height + TOOTH + PINION
    turn = (x - still.middle[0]) / PINION
    wheel = [plane.plus(hub, plane.turned(p, turn)) for p in teeth(plane.circle((0.0, 0.0), PINION))]
    return [Polygon((*points, (x + place.half, top), (x + place.half, top - 3), (left, top - 3))),
            Polygon(tuple(wheel)), Circle(hub, 2.0, "ink", layer=ELEMENT)]
