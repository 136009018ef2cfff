"""Points: fixed in the plane, or carried by a body from the place where they are drawn."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.language.fields import Element, Field
from vibcli.language.kinds import BODY, Many, MotionField
from vibcli.language.named_place import DRAWN

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.symbolic.node import Node

ELEMENT = Element(
    "point",
    "A named place: `[x, y]` is fixed; `{body: rod, at: [x, y]}` is carried by a body, `at` being where it is drawn "
    "in the fixed frame; `{at: [x, y], moves: [ux, uy]}` is driven.",
    {
        "at": Field(DRAWN, "where it is drawn, in the fixed frame", required=True),
        "body": Field(BODY, "the body that carries it"),
        "moves": Field(Many(MotionField("m"), 2, 2, "a displacement [ux, uy]"), "its displacement, driven by "
                       "expressions of the time: [0, Y*sin(Omega*t)]"),
    },
    short="at",
    example="hanging_rod",
)


def driven(point: "Record", drawn: "Sequence[Node]", scene: Any) -> "tuple[Node, Node]":
    """Where a point is that is driven, `drawn` being its place as drawn."""
    if not any(scene.lower(part).mask for part in point["moves"]):
        scene.report(point.place("moves"), f"'{point.name}' never moves: its displacement is constant",
                     "let `at` say where it is")
    return tuple(place + scene.driven_by(scene.lower(part), f"{point.name}.{axis}", f"{point.name}.drive.{axis}")
                 for axis, place, part in zip("xy", drawn, point["moves"], strict=True))
