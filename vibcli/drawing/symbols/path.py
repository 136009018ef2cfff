"""The curve on which a particle moves that is placed by expressions of one coordinate."""

from math import isfinite
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import SURFACE, Polyline
from vibcli.drawing.layout import plane

if TYPE_CHECKING:
    from vibcli.drawing.layout.compose import Scenery

REACH, STEPS, BENT = 75.0, 24, 1.0      # points to either side


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


def _one_way(name, stage, sense):
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
