"""A mode shape on the scene: the position of equilibrium in grey, the displaced one over it."""

from collections.abc import Mapping
from math import pi
from typing import TYPE_CHECKING, Any

from vibcli.drawing.canvas.primitives import BODY, Polyline, Primitive, extent, ghost
from vibcli.drawing.layout import compose, lettering
from vibcli.drawing.symbols import arrow, bodies, path
from vibcli.drawing.vibration import Vibration, caption, mode

if TYPE_CHECKING:
    from vibcli.drawing.layout.compose import Scenery
    from vibcli.drawing.layout.sketch import Sketch

QUIET = ("spring", "damper", "oil", "ground", "fixed", "rope", "belt")     # roles that stay out of the grey position


def draw(problem: Any, index: int, both: bool = False, normalise: str = "first") -> list[Any]:
    """The primitives of a mode; `both`: also displaced the other way, dashed."""
    stage = compose.Scenery(problem.scene)
    vibration = Vibration(problem, index, stage, normalise)
    unit, room = vibration.unit, vibration.room
    still = frame(stage, vibration.rest, unit, room, vibration.bends(None))
    found = path.draw(stage) + ghost(part for part in still if part.role not in QUIET)
    if both:
        other = frame(stage, vibration.at(pi), unit, room, vibration.bends(pi))
        found += [part._replace(dashed=True, width=0.8) for part in ghost(
            part for part in other if part.role not in QUIET)]
    moved = vibration.at(0.0)
    found += frame(stage, moved, unit, room, vibration.bends(0.0)) + _arrows(stage, vibration.rest, moved, unit)
    box = extent(found)
    return [*found, lettering.text(lettering.words(caption(mode(problem, index))), box[0], box[1] - 24)]


def frame(stage: "Scenery", sketch: "Sketch", unit: float, room: Mapping[str, tuple[float, float]],
          bends: Any = None) -> list[Any]:
    """One position, with a mark on what is round."""
    found, _ = compose.figure(stage, sketch, unit, room, bends)
    return found + bodies.marks(sketch, stage.looks)


def _arrows(stage: "Scenery", rest: "Sketch", moved: "Sketch", unit: float) -> "list[Primitive]":
    """The displacements of lumped bodies that slide."""
    found: list[Primitive] = []
    for layout in stage.rows:
        for name, place in layout.places.items():
            if not place.turns and moved.lumped[name] != rest.lumped[name]:    # a driven one stands still
                x, y = place.middle[0] + rest.lumped[name] * unit, place.middle[1] + place.height + 9
                tip = place.middle[0] + moved.lumped[name] * unit
                found.append(Polyline(((x, y - 5), (x, y + 5)), "coordinate", 0.9, layer=BODY))
                if abs(tip - x) > 2.0:
                    found += arrow.straight((x, y), (tip, y), "coordinate")
    return found
