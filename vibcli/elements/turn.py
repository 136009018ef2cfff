"""Rotation of a body that has no place: one axis, one angle."""

from vibcli.language.fields import Element, Field
from vibcli.language.kinds import MotionField

ELEMENT = Element(
    "turn",
    "The rotation of a body without a place, about the one axis: `{inertia: J, turn: phi}`.",
    {"by": Field(MotionField("rad"), "the angle: a coordinate, or an expression of coordinates", required=True)},
    short="by",
    example="discs_on_a_shaft",
)


def lump(turn, scene):
    return "turn", scene.change(turn["by"])
