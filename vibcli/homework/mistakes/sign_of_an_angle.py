"""An angle counted to the other side where an element is inclined by it: −α for α."""

import re
from typing import TYPE_CHECKING, Any

from vibcli.homework.mistakes.mistake import CommonMistake
from vibcli.language.reader import Expression, Reference

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from vibcli.homework.mistakes.mistake import Part
    from vibcli.language.reader import Record
    from vibcli.results.problem import Problem

SECTIONS = "points", "surfaces", "bodies", "springs", "dampers", "forces"
TURNS = "sin", "cos", "tan"


def _changed(problem: "Problem") -> "Iterator[tuple[str, Part]]":
    for section in SECTIONS:
        for name, record in (problem.spec.get(section) or {}).items():
            for angle in _angles(problem, record):
                keys = {key: _turned(value, angle) for key, value in record.items() if angle in _names([value])}
                yield f"{angle} of {name}", {section: {name: keys}}


def _angles(problem: "Problem", record: "Record") -> list[str]:
    """The parameters that are the argument of a sine, cosine or tangent in a record."""
    found = {call.args[0].name: None for one in _expressions([record]) for call in one.parts.calls
             if call.name in TURNS and call.args[0].kind == "name"}
    return [name for name in found if name in problem.spec.parameters]


def _expressions(values: "Iterable[object]") -> "Iterator[Expression]":
    for value in values:
        if isinstance(value, dict):
            yield from _expressions(value.values())
        elif isinstance(value, (list, tuple)):
            yield from _expressions(value)
        elif isinstance(value, Expression):
            yield value


def _names(values: "Iterable[object]") -> set[str]:
    return {name for one in _expressions(values) for name, *_ in one.parts.names}


def _turned(value: Any, angle: str) -> Any:
    """A value of a record as it is written, with −α for α."""
    if isinstance(value, dict):
        return {key: _turned(one, angle) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [_turned(one, angle) for one in value]
    text = value.text if isinstance(value, (Expression, Reference)) else value
    return re.sub(rf"(?<![\w.]){angle}(?![\w'])", f"(-{angle})", text) if isinstance(value, Expression) else text


MISTAKE = CommonMistake("the sign of this angle differs: to which side does it open?", model=_changed)
