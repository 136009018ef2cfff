"""Torsion springs, rotary dampers and their like, at the joint about which they turn."""

from collections.abc import Mapping
from math import cos, pi
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.layout import plane
from vibcli.drawing.layout.sketch import Attachment, Sketch
from vibcli.drawing.symbols.connection import symbol

if TYPE_CHECKING:
    from vibcli.drawing.canvas.primitives import Primitive
    from vibcli.drawing.symbols.look import Look
    from vibcli.language.reader import Record

NEAR = 1.0      # points from a joint that are on it


class Turn(NamedTuple):
    """What turns about a place: the direction of the body as drawn and how far it has turned, the same two of the
    other body, None of the ground; the how manieth of its kind it is there."""

    centre: tuple[float, float]
    heading: float
    moved: float
    held: tuple[float, float] | None
    rank: int


def elements(sketch: Sketch) -> "list[tuple[Record, Attachment, str, Any]]":
    """[(record, joint, body, other)] of what acts between placed bodies or on the ground."""
    found = []
    for record in sketch.spec.connections:
        if "torsion" not in record or "between" not in record:
            continue
        names = [None if end.text == "ground" else end.text for end in record["between"]]
        if any(name in sketch.frames for name in names):
            body, other = _turning(names, sketch)
            at = sketch.pivot(body)
            found.append((record, at or Attachment(body, sketch.centre(body)), body, other))
    return found


def _turning(names: list[str | None], sketch: Sketch) -> tuple[str, str | None]:
    """The body that turns about the joint, and the other one (None: the ground)."""
    one, two = names
    if one is None or one not in sketch.frames:
        return two, None
    if two is None or two not in sketch.frames:
        return one, None
    pivot = sketch.pivot(one)
    return (one, two) if pivot is not None and pivot.carrier == two else (two, one)


def _heading(body: str, joint: tuple[float, float], looks: "Mapping[str, Look]", sketch: Sketch) -> float:
    """The direction of a body from a joint, as drawn; of one without extent such that a wall a quarter turn ahead is
    where no member is."""
    away = plane.minus(plane.middle(*plane.corners([p for part in looks[body].pieces for p in part.points])), joint)
    if plane.distance(away, (0, 0)) > NEAR:
        return plane.heading(away)
    leave = _members(joint, sketch)
    free = [wall for wall in (pi, pi / 2, 0.0) if all(cos(wall - one) < cos(pi / 4) for one in leave)]
    return next(iter(free), pi) - pi / 2


def _members(joint: tuple[float, float], sketch: Sketch) -> list[float]:
    """The directions in which members leave a joint."""
    ends = [[sketch.pair(member.record[key]) for key in ("from", "to")]
            for member in sketch.scene.members.values() if "from" in member.record]
    return [plane.heading(plane.minus(other, one)) for pair in ends for one, other in (pair, pair[::-1])
            if plane.distance(one, joint) < NEAR]


def draw(sketch: Sketch,
         looks: Any) -> "tuple[list[Primitive], dict[str, tuple[Any, ...]]]":
    """The primitives of all of them, and where each is: {name: (middle, normal)}."""
    found, where, ranks = [], {}, {}
    for record, at, body, other in elements(sketch):
        key = record.element.name, round(at.drawn[0], 3), round(at.drawn[1], 3)
        rank = ranks[key] = ranks.get(key, -1) + 1
        held = None if other is None else (_heading(other, at.drawn, looks, sketch), sketch.frames[other].angle)
        turn = Turn(sketch.now(at), _heading(body, at.drawn, looks, sketch), sketch.frames[body].angle, held, rank)
        parts, where[record.name] = symbol(record).about(record, turn)
        found += parts
    return found, where
