"""One of several coordinates held as drawn."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.mistake import CommonMistake

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.homework.mistakes.mistake import Part
    from vibcli.results.problem import Problem


def _changed(problem: "Problem") -> "Iterator[tuple[str, Part]]":
    names = list(problem.scene.coordinates)
    for name in names if len(names) > 1 else ():
        yield name, {"constraints": {"held_fast": {"equation": f"{name} = 0"}}}


MISTAKE = CommonMistake("this holds one of the coordinates fast", model=_changed)
