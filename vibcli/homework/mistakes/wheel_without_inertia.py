"""A wheel, pulley or drum that turns about its centre without a moment of inertia."""

from vibcli.homework.mistakes.bodies import is_wheel, massive, without_inertia
from vibcli.homework.mistakes.mistake import CommonMistake


def _changed(problem):
    for name, body in massive(problem):
        if is_wheel(body):
            yield name, without_inertia(name)


MISTAKE = CommonMistake("the moment of inertia of the wheel is forgotten", model=_changed)
