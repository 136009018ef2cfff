"""Rotation about a pin, which may be carried by another body."""

from typing import TYPE_CHECKING

from vibcli.language.fields import Element, Field
from vibcli.language.kinds import BODY, PLACE, Flag, MotionField

if TYPE_CHECKING:
    from vibcli.elements.rigid_body import Body
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder

ELEMENT = Element(
    "pin",
    "The body turns about a point. The angle is measured in the fixed frame, as textbooks do for double pendulums, "
    "unless `relative: true`.",
    {
        "by": Field(MotionField("rad"), "the angle of rotation, counter-clockwise", required=True),
        "at": Field(PLACE, "the pin as drawn: a place or a point (default: the mass centre)"),
        "carrier": Field(BODY, "the body that carries the pin (a point that is carried needs no other)"),
        "relative": Field(Flag(), "`true`: the angle is measured from the carrier"),
    },
    short="by",
    example="double_pendulum",
    instead={"body": "did you mean 'carrier'?", "angle": "did you mean 'by'?"},
)


def build(pin: "Record", body: "Body", scene: "Builder") -> "Body":
    """A pinned body with its frame: the pin moves with its carrier, the body turns about it by φ."""
    pivot, place, carrier = scene.pivot(pin, body)
    angle = scene.change(pin["by"])
    if pin.get("relative"):
        if carrier is scene.ground:
            scene.report(pin.place("relative"), "'relative' needs a carrier",
                         "name the body that carries the pin, or leave it out")
        angle = angle + carrier.angle
    return body._replace(frame=scene.new_frame(pivot, place, angle))
