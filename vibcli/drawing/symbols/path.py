"""The curve on which a particle moves that is placed by expressions of one coordinate."""

from math import isfinite
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import SURFACE, Polyline
from vibcli.drawing.layout import plane
from vibcli.drawing.symbols import tracks

if TYPE_CHECKING:
    from vibcli.drawing.layout.compose import Scenery
    from vibcli.drawing.layout.sketch import Sketch

REACH, STEPS, BENT = 75.0, 24, 1.0      # points to either side
GROWTH = 1.12


def draw(stage: "Scenery") -> list[Any]:
    """The dashed paths of particles under `move`, where they are curved."""
    found = []
    if stage.scene.loops is not None or len(stage.scene.q) != 1:
        return found
    for name, look in stage.looks.items():
        if "move" in stage.scene.bodies[name].record and look.kind == "ball":
            points = _one_way(name, stage, -1)[::-1] + _one_way(name, stage, 1)[1:]
            chord = (points[0], points[-1])
            if len(points) > 2 and max(plane.distance(p, plane.nearest_on(p, *chord)) for p in points) > BENT:
                found.append(Polyline(tuple(points), "measure", 0.8, True, SURFACE))
    return found


def half_width(sketch: "Sketch") -> float | None:
    """Half the width in metres on which the path of a particle under `move` rises or falls by about that much, as is
    drawn of curves; None where there is no such path."""
    paths = [name for name, body in sketch.scene.bodies.items() if "move" in body.record and name in sketch.frames]
    if len(paths) != 1 or len(sketch.scene.q) != 1 or sketch.scene.loops is not None:
        return None
    q, centre = sketch.scene.q[0].name, sketch.centre(paths[0])

    def place(displacement: float) -> "tuple[float, float]":
        found = sketch.at({**sketch.values, q: sketch.values[q] + displacement})
        return plane.times(found.frames[paths[0]].point(centre), 1.0 / sketch.scale)

    start = place(0.0)
    for i in range(300):
        far = 1e-6 * sketch.scene.unit_of(q) * GROWTH**i
        ends = place(-far), place(far)
        half = plane.distance(*ends) / 2
        if not isfinite(half):
            return None
        if plane.distance(start, plane.middle(*ends)) > tracks.STEEP * half:
            return half
    return None


def _one_way(name: str, stage: "Scenery", sense: int) -> list[tuple[float, float]]:
    """Places on the path as the coordinate grows, or falls, until they are far."""
    q = stage.scene.q[0].name
    start, centre = stage.sketch.values[q], stage.sketch.centre(name)
    step = sense * stage.scene.unit_of(q) * 0.02
    points = [stage.sketch.frames[name].point(centre)]
    length = 0.0
    for i in range(1, 20 * STEPS):
        sketch = stage.at({q: start + i * step})
        place = sketch.frames[name].point(centre) if sketch is not None else (float("nan"), 0.0)
        if not all(map(isfinite, place)):
            break
        length += plane.distance(points[-1], place)
        points.append(place)
        if length > REACH:
            break
    return points[::max(1, len(points) // STEPS)]
