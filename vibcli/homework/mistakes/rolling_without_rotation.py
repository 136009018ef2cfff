"""A rolling body that has no rotational energy."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.bodies import massive, without_inertia
from vibcli.homework.mistakes.mistake import CommonMistake

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.homework.mistakes.mistake import Part
    from vibcli.results.problem import Problem


def _changed(problem: "Problem") -> "Iterator[tuple[str, Part]]":
    for name, body in massive(problem):
        if "roll" in body.record:
            yield name, without_inertia(name)


MISTAKE = CommonMistake("it rolls: the energy of its rotation is forgotten", model=_changed)
