"""Bodies without a place that hang from one point of a member by a spring or damper alone: they are drawn there."""

from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.drawing.layout.rows import motion

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.drawing.layout.rows import LumpedRow
    from vibcli.drawing.layout.sketch import Sketch
    from vibcli.drawing.layout.strips import Strip
    from vibcli.language.reader import Expression
    from vibcli.language.spec import Spec

KEYS = {"spring": "k", "damper": "c"}


class Hung(NamedTuple):
    """A body that a coordinate `moves` at the place `at` of a member; `parts`: its fields `mass`, `k`, `c`, as those of
    an oscillator are; `ties`: the names of what it hangs by."""

    body: str
    moves: str
    member: str
    at: Any
    parts: "dict[str, Expression]"
    ties: tuple[str, ...]


def on(strip: "Strip", sketch: "Sketch") -> list[Hung]:
    """The Hung of a member, as `find` left them."""
    return [one for one in sketch.numbers.get("hung", ()) if one.member == strip.name]


def find(found: "Sequence[LumpedRow]", sketch: "Sketch") -> list[Hung]:
    """The Hung among bodies that stand alone in their row, kept in `sketch.numbers`."""
    alone = [row.bodies[0] for row in found if len(row.bodies) == 1 and not row.gaps and not row.lanes]
    hung = [one for name in alone if not _is_loaded(name, sketch.spec) and (one := _hung(name, sketch)) is not None]
    sketch.numbers["hung"] = hung
    return hung


def _hung(name: str, sketch: "Sketch") -> Hung | None:
    """The Hung of a body; None of one that more than a spring and a damper join, or that turns."""
    body, ends, parts, ties = sketch.scene.bodies[name], set(), {}, []
    if body.lumped[0] != "slide" or "mass" not in body.record or motion(body).text not in sketch.scene.coordinates:
        return None
    for record in sketch.spec.connections:
        texts = [getattr(end, "text", None) for end in record.get("between", ())]
        if name in texts:
            key = KEYS.get(record.element.name)
            if key not in record or key in parts:
                return None
            ends |= {text for text in texts if text != name}
            parts[key] = record[key]
            ties.append(record.name)
    point = (sketch.spec.get("member_points") or {}).get(ends.pop()) if len(ends) == 1 else None
    member = sketch.scene.members.get(point["body"].text) if point is not None else None
    if member is None or member.line is not None or member.kind.torsional:
        return None
    parts["mass"] = body.record["mass"]
    return Hung(name, motion(body).text, point["body"].text, point["at"], parts, tuple(ties))


def _is_loaded(name: str, spec: "Spec") -> bool:
    """Does a force act on a body?"""
    return any(getattr(record.get("at"), "text", None) == name for record in (spec.get("forces") or {}).values())
