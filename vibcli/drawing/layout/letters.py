"""Values of letters that make a good figure: those of the scene, unless bodies or fixed places then lie over others."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import SpecError
from vibcli.base.units import LENGTH
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols.bodies import fixed_pivots
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.drawing.layout.compose import Scenery
    from vibcli.drawing.layout.sketch import Attachment, Sketch
    from vibcli.drawing.symbols.look import Look
    from vibcli.scene.scene import Scene

TRIES, ENOUGH, SAME, OUTSIDE = 8, 0.05, 1e-9, 0.4
FACTORS = Fraction(2), Fraction(1, 2), Fraction(3)      # by which single lengths are drawn otherwise
NEAR = 8.0          # points from a bearing that are on it


def pleasing(problem: Any, stage_of: type[Any]) -> "Scenery":
    """The stage (`stage_of(scene)`) whose letters draw the scene best; only that of the problem where it has none."""
    stage: Scenery = stage_of(problem.scene)
    if not problem.numeric.has_free_symbols or crowding(stage) <= ENOUGH:
        return stage
    best = crowding(stage), stage
    for tries in (_anew, _stretched):
        for scene in tries(best[1].scene):
            if _same(problem.scene, scene):
                other = stage_of(scene)
                best = min(best, (crowding(other), other), key=lambda pair: pair[0])
                if best[0] <= ENOUGH:
                    found: Scenery = best[1]
                    return found
    result: Scenery = best[1]
    return result


def _anew(scene: "Scene") -> "Iterator[Scene]":
    """The scene with other values of all its letters."""
    for _ in range(TRIES):
        try:
            scene = scene.drawn_anew(scene.attempt + 1)
        except SpecError:
            return
        yield scene


def _stretched(scene: "Scene") -> "Iterator[Scene]":
    """The scene with one of its lengths without value longer or shorter."""
    letters = {name: Fraction(scene.sample[name]) for name in scene.parameters.free}
    for name in letters:
        for factor in FACTORS if scene.spec.dimensions.of(name) == LENGTH else ():
            try:
                yield scene.drawn_with({**letters, name: letters[name] * factor})
            except SpecError:
                continue


def _same(scene: "Scene", other: "Scene") -> bool:
    """Do two scenes of one file move alike, with the values of the second?"""
    values = [_rates(one, other.sample) for one in (scene, other)]
    sizes = [1.0 + max(map(abs, row), default=0.0) for row in values]
    return len(values[0]) == len(values[1]) and all(
        abs(a - b) <= SAME * min(sizes) for a, b in zip(*values, strict=True))


def _rates(scene: "Scene", sample: dict[str, float]) -> list[float]:
    """How the places and angles of all bodies change with the coordinates, as drawn."""
    nodes = [node for body in scene.bodies.values() if body.frame is not None
             for node in (*body.frame.place, body.frame.angle)]
    slopes = [gradient(node).get(q, scene.table.zero) for node in nodes for q in scene.q]
    symbols = {node.name: value for node, value in scene.drawn.items()}
    drawn = dict(zip(symbols, evaluate(list(symbols.values()), Floats, sample), strict=True))
    rates = {v.name: 0.0 for v in scene.v}
    return evaluate(slopes, Floats, {**sample, **drawn, **rates, scene.time.name: 0.0})


def crowding(stage: "Scenery") -> float:
    """How much bodies overlap that are not joined, how many fixed places lie within bodies, and how many mass centres
    lie beyond all places of their bodies; how many bearings stand in the way of springs."""
    sketch, looks = stage.sketch, stage.looks
    total = OUTSIDE * sum(_is_outside(name, stage) for name in looks)
    names = list(looks)
    for i, one in enumerate(names):
        for two in names[i + 1:]:
            if not _joined(one, two, sketch):
                total += _overlap(looks[one], looks[two])
    total += sum(_shared(one, two) for one, two in combinations(_pulleys(stage), 2))
    bearings = fixed_pivots(sketch)
    for pair in stage.ties.ends:
        total += sum(_runs_through(place, pair) for place in bearings)
        for end in pair:
            for name, look in looks.items():
                if look.kind == "frame":    # which is about what is in it
                    continue
                if end.carrier != name and any(plane.inside(end.drawn, list(part.points)) for part in look.outlines):
                    total += not _joined(name, end.carrier, sketch) or end.carrier is None
    return total


def _runs_through(place: tuple[float, float], pair: "tuple[Attachment, Attachment]") -> bool:
    """Does a bearing stand in the way of what is joined between two ends?"""
    one, two = (end.drawn for end in pair)
    return min(plane.distance(place, one), plane.distance(place, two)) > NEAR and plane.distance(
        place, plane.nearest_on(place, one, two)) < NEAR


def _pulleys(stage: "Scenery") -> list[tuple[float, float, float, float]]:
    """The boxes of pulleys without a body, and of bodies that ropes run about."""
    circles = [(at.drawn, radius) for at, radius in stage.ties.pegs]
    circles += [(stage.sketch.rim(name).drawn, max(radii)) for name, radii in stage.ties.radii.items()
                if name in stage.sketch.frames and stage.looks[name].kind == "wheel"]
    return [plane.bounds(plane.circle(*circle)) for circle in circles]


def _is_outside(name: str, stage: "Scenery") -> bool:
    """Does the mass centre of a body lie beyond the box about its pin and the places that it carries?"""
    pivot, places = stage.sketch.pivot(name), stage.ties.carried.get(name, ())
    if pivot is None or len(places) < 2:
        return False
    (left, bottom), (right, top) = plane.corners([pivot.drawn, *places])
    x, y = stage.sketch.centre(name)
    room = SAME * (right - left + top - bottom)
    return not (left - room <= x <= right + room and bottom - room <= y <= top + room)


def _joined(one: str, two: str | None, sketch: "Sketch") -> bool:
    """Is one of two bodies carried by the other, or drawn at the same place?"""
    if two is None or two not in sketch.scene.bodies:
        return False
    for a, b in ((one, two), (two, one)):
        record = sketch.scene.bodies[a].record
        pivot = sketch.pivot(a)
        if (pivot is not None and pivot.carrier == b) or ("weld" in record and record["weld"].text == b):
            return True
        surfaces = [sketch.scene.surfaces[name] for name in sketch.scene.bodies[a].touched]
        if any("body" in surface and surface["body"].text == b for surface in surfaces):
            return True
        for key in ("slide", "move"):
            if key in record and "carrier" in record[key] and record[key]["carrier"].text == b:
                return True
    return plane.distance(sketch.centre(one), sketch.centre(two)) < 1e-6


def _overlap(one: "Look", two: "Look") -> float:
    """The part of the smaller body that the boxes of two bodies share; thin rods and frames count for nothing."""
    if {"rod", "frame"} & {one.kind, two.kind} or not (one.outlines and two.outlines):
        return 0.0
    return _shared(*(plane.bounds([p for part in look.outlines for p in part.points]) for look in (one, two)))


def _shared(a: tuple[float, float, float, float], b: tuple[float, float, float, float]) -> float:
    """The part of the smaller of two boxes that they share."""
    wide, high = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
    if wide <= 1.0 or high <= 1.0:
        return 0.0
    return wide * high / max(1.0, min((c[2] - c[0]) * (c[3] - c[1]) for c in (a, b)))
