"""What moves together although no element joins it: the end of a rod that stays at one place of a body which
expressions place is pinned there."""

from typing import TYPE_CHECKING

from vibcli.drawing.layout import plane
from vibcli.drawing.layout.positions import values_at
from vibcli.drawing.layout.sketch import Attachment

if TYPE_CHECKING:
    from vibcli.drawing.layout.sketch import Sketch

STEPS, INSTANT, CLOSE = (0.11, -0.07, 0.17, -0.05, 0.13), 0.23, 1e-6    # in units of the coordinates; s; in parts


def hinges(sketch: "Sketch") -> list[tuple[str, Attachment]]:
    """[(body, end of a rod that is pinned to it)], found in positions other than the drawn one."""
    bodies = [name for name in sketch.frames if _is_loose(name, sketch)]
    ends = [end for name in sketch.frames for end in _ends(name, sketch)] if bodies else []
    others = _elsewhere(sketch) if ends else []
    if not others:
        return []
    return [(name, end) for name in bodies for end in ends
            if all(_together(name, end, other) for other in others) and any(_moves(end, other) for other in others)]


def _is_loose(name: str, sketch: "Sketch") -> bool:
    """Is this a body without a shape, placed by expressions?"""
    body = sketch.scene.bodies.get(name)
    return body is not None and "move" in body.record and not {"shape", "parts"} & set(body.record)


def _ends(name: str, sketch: "Sketch") -> list[Attachment]:
    """The ends of a rod that are not its own pin."""
    body = sketch.scene.bodies.get(name)
    if body is None or body.record.get("shape") != "rod":
        return []
    pivot = sketch.pivot(name)
    places = [sketch.pair(body.record[key]) for key in ("from", "to")]
    return [Attachment(name, place) for place in places
            if pivot is None or plane.distance(place, pivot.drawn) > CLOSE * (1 + plane.distance(*places))]


def _elsewhere(sketch: "Sketch") -> "list[Sketch]":
    """The scene in two other positions, as far as its loops can follow."""
    scene, found = sketch.scene, []
    for shift in (0, 2):
        position = {q.name: sketch.values[q.name] + STEPS[(shift + i) % len(STEPS)] * scene.unit_of(q.name)
                    for i, q in enumerate(scene.q)}
        values = values_at(scene, position, INSTANT * (1 + shift))
        if values is not None:
            found.append(sketch.at(values))
    return found


def _together(name: str, end: Attachment, other: "Sketch") -> bool:
    place, here = other.now(end), other.frames[name].point(end.drawn)
    return plane.distance(place, here) < CLOSE * (1 + plane.distance(place, end.drawn))


def _moves(end: Attachment, other: "Sketch") -> bool:
    return plane.distance(other.now(end), end.drawn) > CLOSE
