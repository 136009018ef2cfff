"""Two springs side by side as if one stood behind the other: k₁k₂/(k₁ + k₂)."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.mistake import CommonMistake
from vibcli.homework.mistakes.springs import side_by_side

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.homework.mistakes.mistake import Part
    from vibcli.results.problem import Problem


def _changed(problem: "Problem") -> "Iterator[tuple[str, Part]]":
    for one, other in side_by_side(problem.spec):
        first, second = (f"({record['k'].text})" for record in (one, other))
        yield f"{one.name}, {other.name}", {"springs": {one.name: {"k": f"{first}*{second}/({first} + {second})"},
                                                        other.name: {"k": "0"}}}


MISTAKE = CommonMistake("these springs have the same stretch: their stiffnesses add up", model=_changed)
