"""Points: fixed in the plane, or carried by a body from the place where they are drawn."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.language.document.document import Mapping
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import BODY, Many, MotionField, NameOf, Quantity
from vibcli.language.named_place import DRAWN
from vibcli.symbolic.parser import plain_name

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

MEMBER_POINT = Element("point", "A named place on a member, counted from its left end.", {
    "body": Field(NameOf("the name of a member", "members"), "the member", required=True),
    "at": Field(Quantity("m"), "the place along it, from its left end", required=True)})


class _Point(Element):
    """A Record; on a member, whose place is one number, that of a MEMBER_POINT."""

    def read(self, node: Any, reader: Any, *named: Any) -> Any:
        entries = node.entries if isinstance(node, Mapping) else {}
        carrier = entries["body"][1] if "body" in entries else None
        if plain_name(getattr(carrier, "text", "").strip()) in reader.members:
            return MEMBER_POINT.read(node, reader, *named)
        return super().read(node, reader, *named)


ELEMENT = _Point(
    "point",
    "A named place: `[x, y]` is fixed; `{body: rod, at: [x, y]}` is carried by a body, `at` being where it is drawn "
    "in the fixed frame; `{at: [x, y], moves: [ux, uy]}` is driven. On a member it is a place along it: "
    "`{body: wing, at: L/2}`.",
    {
        "at": Field(DRAWN, "where it is drawn, in the fixed frame", required=True),
        "body": Field(BODY, "the body that carries it"),
        "moves": Field(Many(MotionField("m"), 2, 2, "a displacement [ux, uy]"), "its displacement, driven by "
                       "expressions of the time: [0, Y*sin(Omega*t)]"),
    },
    short="at",
    example="hanging_rod",
)


def driven(point: "Record", drawn: "Sequence[Node]", scene: "Builder") -> "tuple[Node, Node]":
    """Where a point is that is driven, `drawn` being its place as drawn."""
    if not any(scene.lower(part).mask for part in point["moves"]):
        scene.report(point.place("moves"), f"'{point.name}' never moves: its displacement is constant",
                     "let `at` say where it is")
    x, y = (place + scene.driven_by(scene.lower(part), f"{point.name}.{axis}", f"{point.name}.drive.{axis}")
                 for axis, place, part in zip("xy", drawn, point["moves"], strict=True))
    return x, y
