"""The results of a scene as entries of `answers`: what a report tells, asked for and spelled in the scene language."""

import os
from collections.abc import Iterable, Mapping
from contextlib import suppress
from math import log10
from typing import TYPE_CHECKING

from vibcli.api.asked import ASKED
from vibcli.api.expressions import node_of
from vibcli.api.source import problem_of, settled, text_source
from vibcli.api.values import quantity_asked, quantity_value
from vibcli.base.errors import NotInLetters, PhysicsError, SpecError, Where
from vibcli.base.named_tuple import NamedTuple
from vibcli.language.document.insertion import with_entries
from vibcli.language.document.nodes import Mapping as Node
from vibcli.language.document.nodes import Scalar
from vibcli.language.reader import Reader
from vibcli.notation.equation_sides import equation
from vibcli.notation.scene_language import language, unit_in_scene
from vibcli.quantities.expression import bounded
from vibcli.quantities.quantity import EQUATION, OF_STATE, kind_of
from vibcli.reader.answer_check import checked
from vibcli.reader.sections import answer as answer_section
from vibcli.report.document import EVERYTHING
from vibcli.report.sections.too_long import LONGEST

if TYPE_CHECKING:
    from vibcli.api.values import QuantityValue
    from vibcli.reader.sections.answer import Answer
    from vibcli.results.problem import Problem

FEWEST, USUAL, FLOAT = 3, 6, 15     # digits: fewer are read as exact, as many are written, as many has a float
NOTHING = 1e-12                     # beside the first amplitude of a shape, what is rounding
SHARP = 1e-11                       # relative: a number so near to one of few digits is that one


class LeftOut(NamedTuple):
    """What a report tells and `answers` cannot, and why."""

    asked: str
    reason: str


def entries(problem: "Problem", sections: Iterable[str],
            digits: int | None = None) -> "tuple[dict[str, tuple[str, Answer]], list[LeftOut]]":
    """({quantity: (value as a file writes it, Answer)}, what is left out) of the sections of a report; those alone that
    the scene does not answer already."""
    known = {_plainly(answer.asked.text) for answer in problem.spec.answers}
    solved, found, left, refusal = settled(problem, thorough=True), {}, [], None
    for section in sections:
        if section not in ASKED:
            if section in (problem.spec.get("find") or ()) or section not in EVERYTHING:
                left.append(LeftOut(section, "it is not written as answers"))
            continue
        try:
            for asked in dict.fromkeys(ASKED[section](solved)):
                if _plainly(asked) in known:
                    continue
                try:
                    value = spelled(solved, asked, digits)
                    if not _is_small(solved, asked, value):
                        found[asked] = value, _read(problem, asked, value)
                except PhysicsError as error:
                    refusal = refusal or error
                    left.append(LeftOut(asked, error.message))
        except PhysicsError as error:
            refusal = refusal or error
            left.append(LeftOut(section, error.message))
    if refusal and not found and not known:
        raise refusal
    return found, left


def _is_small(problem: "Problem", asked: str, value: str) -> bool:
    """Is it an equation of motion that is the one of small oscillations too?"""
    if not asked.startswith("motion["):
        return False
    with suppress(PhysicsError):
        return spelled(problem, asked.replace("motion", "equation", 1)) == value
    return False


def _read(problem: "Problem", asked: str, value: str) -> "Answer":
    """The Answer of a quantity and its value as they are read from a file; refused where they are not."""
    reader, place = Reader(members=problem.spec.members), Where(problem.spec.file, 1, 1, 0)
    node = Node(place, {asked: (Scalar(asked, place, inset=0), Scalar(value, place, inset=0))})
    found = answer_section.KIND.read(node, reader)
    reader.at_speed.update(answer.expected.scalar for answer in found)
    answers = [checked(problem.spec, reader, answer) for answer in found]
    if reader.diagnostics:
        raise PhysicsError(f"no answer can say it: {reader.diagnostics[0].message}")
    return answers[0]


def _plainly(asked: str) -> str:
    """A quantity without what may be written otherwise."""
    return asked.replace(" ", "").replace("][", ",")


def with_answers(text: str, file: str, found: "Mapping[str | None, Mapping[str, str]]") -> str:
    """The text of a scene file with {case, None of the scene itself: {quantity: value}} among its answers."""
    for case, added in found.items():
        if added:
            text = with_entries(text, ("answers",) if case is None else ("cases", case, "answers"), added, "cases")
    try:
        problem_of(text_source(text, os.path.dirname(file)))
    except SpecError as error:
        raise PhysicsError(f"answers cannot be put into this file: {error.diagnostics[0].message}",
                           "write `answers:` line by line, below the other sections") from None
    return text


def spelled(problem: "Problem", asked: str, digits: int | None = None) -> str:
    """The value of a quantity as an answer: an expression, `true`, or a number with the digits that its bound allows
    (`digits` at most) and its unit. PhysicsError where it has no such spelling."""
    found = quantity_value(problem, asked)
    if found.expression is not None:
        return _expression(problem, found)
    if isinstance(found.value, bool):
        return str(found.value).lower()
    if isinstance(found.value, complex):
        raise PhysicsError("it is complex", "ask for its parts")
    unit = "" if problem.spec.free_numbers or found.unit == "1" else unit_in_scene(found.unit)
    return f"{_number(problem, found, digits or USUAL)} {unit}".rstrip()


def _expression(problem: "Problem", found: "QuantityValue") -> str:
    """An expression of letters; an equation with what drives it on the right."""
    node, kind = node_of(found.expression), kind_of(problem.spec, quantity_asked(problem.spec, found.text).tree)
    if kind in OF_STATE and problem.scene.pieces:
        raise NotInLetters("members add integrals and differential equations to it")
    text = equation(problem.scene, node, language) if kind == EQUATION else language(node)
    if len(text) > LONGEST:
        raise PhysicsError(f"it is an expression of {len(text)} characters")
    return text


def _number(problem: "Problem", found: "QuantityValue", digits: int) -> str:
    """A number with the digits that its bound allows; 0 where that is all of it."""
    value, error = found.value, found.error
    if digits > FLOAT:
        import mpmath

        value, error = bounded(problem.with_digits(digits), quantity_asked(problem.spec, found.text))
    if not value or abs(value) <= max(error, NOTHING * found.text.startswith("mode[")):
        return "0"
    known = min(digits, int(-log10(error / abs(value)))) if error else digits
    if known < FEWEST:
        raise PhysicsError(f"of its digits {known} are known, and answers of fewer than {FEWEST} are read as exact")
    if digits > FLOAT:
        return str(mpmath.nstr(value, known, strip_zeros=False)).replace("e+", "e")
    text = f"{value:.{known}g}"
    if error > SHARP * abs(value) or abs(float(text) - value) > SHARP * abs(value):
        text = f"{value:#.{known}g}".rstrip(".")        # with its last zeros: it is rounded
    return text.replace("e+0", "e").replace("e-0", "e-").replace("e+", "e")
