"""The known mistake that leads to an answer which differs."""

from math import isfinite
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.garbage import GARBAGE
from vibcli.homework.mistakes import MODEL
from vibcli.homework.mistakes.known import KnownMistake, of_catalogue
from vibcli.language.cases import document_of_case
from vibcli.quantities.dimensions import unit_of
from vibcli.quantities.expression import value_of

if TYPE_CHECKING:
    from vibcli.language.document.nodes import Mapping
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem

CLOSE, NEAR = 1e-3, 1e-4        # relative: what a mistake leads to; what is the right value itself


def nearest_mistake(problem: "Problem", asked: "Expression", expected: float, found: float,
                    root: "Mapping | None" = None, case: str | None = None) -> str | None:
    """The sentence of the mistake that leads nearest to what is expected, one of the model first but where it turns
    the sign alone, which has a sentence of its own; None where none does. root: the document of the scene, without
    which mistakes of its model are not looked for; case: which of its cases this is. Neither value is zero."""
    near = []
    document = root and document_of_case(root, case)
    for mistake in of_catalogue(problem, document, [asked]):
        wrong = _wrong(problem, mistake, asked, found)
        GARBAGE.clear()
        off = abs(wrong / expected - 1) if wrong is not None and isfinite(wrong) else CLOSE
        if off < CLOSE and abs(wrong / found - 1) > NEAR:
            of_model, negated = mistake.kind == MODEL, abs(wrong / found + 1) < CLOSE
            near.append((not of_model or negated, of_model, off, mistake.told))
    return min(near)[-1] if near else None


def _wrong(problem: "Problem", mistake: KnownMistake, asked: "Expression", found: float) -> float | None:
    from vibcli.inverse import settled

    try:
        scene = problem if mistake.problem is None else settled(mistake.problem)
        return mistake.wrong(asked, unit_of(problem.spec, asked), found, lambda one: float(value_of(scene, one)[0]))
    except (SpecError, PhysicsError):
        return None
