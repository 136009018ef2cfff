"""A spring without its tension at rest."""

from typing import TYPE_CHECKING

from vibcli.homework.mistakes.mistake import CommonMistake

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.homework.mistakes.mistake import Part
    from vibcli.results.problem import Problem


def _changed(problem: "Problem") -> "Iterator[tuple[str, Part]]":
    for name, record in (problem.spec.get("springs") or {}).items():
        if "preload" in record and record["preload"] != "static" and "torsion" not in record:
            yield name, {"springs": {name: {"preload": "0"}}}


MISTAKE = CommonMistake("the tension of the spring at rest is forgotten: it adds to the stiffness", model=_changed)
