"""The diameter for the radius in the moment of inertia of a round body."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.bodies import massive, with_inertia
from vibcli.homework.mistakes.mistake import CommonMistake

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.homework.mistakes.mistake import Part
    from vibcli.results.problem import Problem


def _changed(problem: "Problem") -> "Iterator[tuple[str, Part]]":
    for name, body in massive(problem):
        if "radius" in body.record and "inertia" not in body.record and "gyration" not in body.record:
            yield name, with_inertia(name, 4 * body.inertia)


MISTAKE = CommonMistake("diameter for radius in the moment of inertia?", model=_changed)
