"""Rotation of a body that has no place: one axis, one angle."""

from vibcli.language.kinds import MotionField

ELEMENT = MotionField("rad")
ABOUT = "The rotation of a body without a place, about the one axis: `{inertia: J, turn: phi}`."


def lump(turn, scene):
    return "turn", scene.change(turn)
