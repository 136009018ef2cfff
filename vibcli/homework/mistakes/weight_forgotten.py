"""The scene without gravity."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.mistake import CommonMistake

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.homework.mistakes.mistake import Part
    from vibcli.results.problem import Problem


def _changed(problem: "Problem") -> "Iterator[tuple[str, Part]]":
    if problem.spec.get("gravity") is not None:
        yield "", {"gravity": "0"}


MISTAKE = CommonMistake("the weight is forgotten: it counts in the equilibrium or in the stiffness", model=_changed)
