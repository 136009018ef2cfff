"""A body clamped rigidly to the ground or to another body: it has no motion of its own, but the clamp has forces."""

from typing import TYPE_CHECKING

from vibcli.language.fields import Element, Field
from vibcli.language.kinds import BODY, PLACE

if TYPE_CHECKING:
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder

ELEMENT = Element(
    "clamp",
    "The body is clamped at a place, to the ground or to the body that carries it: `clamp: [0, 0]`. Its reactions "
    "there are `B.reaction.x`, `.y` and the clamping moment `.moment`; what is merely welded has none.",
    {
        "at": Field(PLACE, "where it is clamped, as drawn: a place or a point", required=True),
        "carrier": Field(BODY, "the body that it is clamped to (a point that is carried needs no other)"),
    },
    short="at",
    example="clamped_bracket",
)


def build(clamp: "Record", body: "Body", scene: "Builder") -> "Body":
    """A clamped body with its frame: that of its carrier, with the clamp as reference point."""
    drawn, place, carrier = scene.pivot(clamp, body)
    return body._replace(frame=scene.new_frame(drawn, place, carrier.angle))
