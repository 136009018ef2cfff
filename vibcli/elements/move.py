"""General plane motion: displacement of the mass centre and rotation, each a coordinate or an expression."""

from typing import TYPE_CHECKING, Any

from vibcli.language.document.document import Scalar, Sequence
from vibcli.language.fields import Element, Field
from vibcli.language.kinds import BODY, Kind, MotionField

if TYPE_CHECKING:
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder

_LENGTH, _ANGLE = MotionField("m"), MotionField("rad")


class _Displacements(Kind):
    wants = "displacements [x, y, phi], or [x, y] of what does not turn"

    def read(self, node: Any, reader: Any) -> Any:
        if not isinstance(node, Sequence) or len(node.items) not in (2, 3):
            return reader.expected(node, self.wants)
        items = [*node.items, Scalar("0", node.where)][:3]
        values = [kind.read(item, reader) for kind, item in zip((_LENGTH, _LENGTH, _ANGLE), items, strict=True)]
        return None if any(value is None for value in values) else values

    def schema(self) -> dict[str, Any]:
        return {"type": "array", "items": _LENGTH.schema(), "minItems": 2, "maxItems": 3}


ELEMENT = Element(
    "move",
    "General plane motion: the displacement of the body's mass centre in x and y and its rotation, each a coordinate "
    "or an expression of coordinates, counted from the drawn position.",
    {
        "by": Field(_Displacements(), "displacement of the mass centre and rotation; 0 what is held; [x, y] of a "
                    "particle", required=True),
        "carrier": Field(BODY, "the body relative to which it moves; axes and angle turn with it"),
    },
    short="by",
    example="bounce_and_pitch",
    instead={"body": "did you mean 'carrier'?"},
)


def build(move: "Record", body: "Body", scene: "Builder") -> "Body":
    """The body with its frame, moved by (Δx, Δy, Δφ) in its carrier."""
    dx, dy, turn = map(scene.change, move["by"], (".x", ".y", ".moment"))
    carrier = scene.carrier(move)
    x0, y0 = body.centre
    frame = scene.new_frame((x0, y0), carrier.point(x0 + dx, y0 + dy), carrier.angle + turn)
    return body._replace(frame=frame)
