"""Which parameters a sheet has to tell, as its keys depend on them, and which it tells: in its question or figure."""

import re
import unicodedata
from fractions import Fraction
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.language.given_values import giver, number_and_unit
from vibcli.reader.read import QUOTE
from vibcli.results.variants import with_given
from vibcli.symbolic.parser import plain_name

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.homework.keys import AnswerKey
    from vibcli.results.problem import Problem

STEP = Fraction(1, 64)      # relative: by so much a parameter is changed
WORD = re.compile(r"[^\W\d_][^\W_]*")


def untold(problem: "Problem", keys: "Sequence[AnswerKey]") -> list[str]:
    """The parameters of a scene with numbers on which a key depends, and which neither its question nor its figure
    tells; the acceleration of gravity is known."""
    known = told(problem) | _of_gravity(problem)
    return [name for name in problem.spec.independent_parameters if name not in known and _matters(problem, keys, name)]


def told(problem: "Problem") -> set[str]:
    """The parameters that the question quotes or the figure letters."""
    quoted = {plain_name(found.group(1)) for found in re.finditer(QUOTE, problem.spec.get("question", ""))}
    return quoted | lettered(problem)


def lettered(problem: "Problem") -> set[str]:
    """The parameters whose letters stand in the figure."""
    from vibcli.notation.plain import plain
    from vibcli.report.sections.illustrations import lettering

    words: set[str] = set()
    for text in lettering(problem):
        text = unicodedata.normalize("NFKC", text)
        words.update(WORD.findall(text), [text])
    return {name for name in problem.spec.parameters if unicodedata.normalize("NFKC", plain.symbol(name)) in words}


def _of_gravity(problem: "Problem") -> set[str]:
    """The parameters that are the acceleration of gravity."""
    field = problem.spec.get("gravity")
    parts = field if isinstance(field, list) else [field] if field is not None else []
    return {name for part in parts for name, *_ in part.parts.names}


def _matters(problem: "Problem", keys: "Sequence[AnswerKey]", name: str) -> bool:
    """Does a key change with a parameter? It does where there is no such scene beside it."""
    record = problem.spec.parameters[name]
    written = number_and_unit(record["value"]) if "value" in record else None
    if written is None:
        return any(key.hangs_on(problem, name, None) for key in keys)
    number, unit = written
    moved = giver(unit, name)(number * (1 + STEP) if number else STEP)
    try:
        other = with_given(problem, {name: moved})
        return any(key.hangs_on(problem, name, other) for key in keys)
    except (SpecError, PhysicsError):
        return True
