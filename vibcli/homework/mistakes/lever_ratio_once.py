"""The ratio of a spring's stretch to the coordinate once, for its square."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.mistake import CommonMistake
from vibcli.homework.mistakes.springs import lever_ratio

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.homework.mistakes.mistake import Part
    from vibcli.results.problem import Problem


def _changed(problem: "Problem") -> "Iterator[tuple[str, Part]]":
    for name, record in (problem.spec.get("springs") or {}).items():
        ratio = lever_ratio(problem, name) if "k" in record else None
        if ratio is not None:
            yield name, {"springs": {name: {"k": f"({record['k'].text})/({ratio})"}}}


MISTAKE = CommonMistake("the ratio of stretch and coordinate counts twice: in the force and in its lever",
                        model=_changed)
