"""The scene without a damper."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.mistake import CommonMistake

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.homework.mistakes.mistake import Part
    from vibcli.results.problem import Problem


def _changed(problem: "Problem") -> "Iterator[tuple[str, Part]]":
    for name, record in (problem.spec.get("dampers") or {}).items():
        if "c" in record:
            yield name, {"dampers": {name: {"c": "0"}}}


MISTAKE = CommonMistake("the damper is forgotten", model=_changed)
