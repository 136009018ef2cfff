"""A wheel, pulley or drum that turns about its centre without a moment of inertia."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.bodies import is_wheel, massive, without_inertia
from vibcli.homework.mistakes.mistake import CommonMistake

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.homework.mistakes.mistake import Part
    from vibcli.results.problem import Problem


def _changed(problem: "Problem") -> "Iterator[tuple[str, Part]]":
    for name, body in massive(problem):
        if is_wheel(body):
            yield name, without_inertia(name)


MISTAKE = CommonMistake("the moment of inertia of the wheel is forgotten", model=_changed)
