"""Rotation of a body that has no place: one axis, one angle."""

from typing import TYPE_CHECKING, Any

from vibcli.language.fields import Element, Field
from vibcli.language.kinds import BODY, MotionField

if TYPE_CHECKING:
    from vibcli.scene.builder import Builder
    from vibcli.symbolic.node import Node

ELEMENT = Element(
    "turn",
    "The rotation of a body without a place, about the one axis: `{inertia: J, turn: phi}`.",
    {
        "by": Field(MotionField("rad"), "the angle: a coordinate, or an expression of coordinates", required=True),
        "carrier": Field(BODY, "the body without a place from which the angle is measured; the ground without it"),
    },
    short="by",
    example="discs_on_a_shaft",
)


def lump(turn: Any, scene: "Builder") -> "tuple[str, Node]":
    return "turn", scene.along_axis(turn, "turn") + scene.change(turn["by"])
