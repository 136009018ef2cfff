"""Springs one behind the other as if they stood side by side."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.mistake import CommonMistake

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.homework.mistakes.mistake import Part
    from vibcli.results.problem import Problem


def _changed(problem: "Problem") -> "Iterator[tuple[str, Part]]":
    for name, record in (problem.spec.get("springs") or {}).items():
        parts = record.get("series") or ()
        if parts and all("k" in part for part in parts):
            k = " + ".join(f"({part['k'].text})" for part in parts)
            yield name, {"springs": {name: {"k": k, "series": None}}}


MISTAKE = CommonMistake("these springs carry the same force: their compliances add up", model=_changed)
