"""A scene in numbers, at which expressions by the letters of lines are held against what the engine finds: itself, or
with some values of its letters."""

from collections.abc import Mapping
from contextlib import suppress
from math import isnan
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.quantities.expression import value_of
from vibcli.results.random_states import random_instances
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.node import UNITS

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from vibcli.language.reader import Expression
    from vibcli.report.steps.step import WorkedLine, WorkedSolution
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

CLOSE = 1e-9        # relative: of a line and the engine's number
ROUNDING = 1e-13    # the same, of the terms of a sum
INSTANCES, MOST = 3, 24     # of a scene in letters: what are enough, and are drawn


def instances(problem: "Problem", sheet: "WorkedSolution") -> "Iterator[tuple[Problem, Mapping[str, float]]]":
    """(the problem in numbers, {letter: number} of its parameters and of the lines), of a scene in letters where all of
    these are real: what is told of one that is under-damped holds there alone."""
    if not problem.numeric.has_free_symbols:
        yield problem, {**problem.numeric.floats, **{line.letter: line.value for line in sheet.steps
                                                     if line.letter and line.value is not None}}
        return
    if problem not in sheet.drawn:
        sheet.drawn[problem] = [], random_instances(problem)
    drawn, more = sheet.drawn[problem]
    for i in range(MOST):
        if i == len(drawn):
            one = next(more, None)
            if one is None:
                return
            drawn.append(one)
        known = _with_lines({**dict.fromkeys(UNITS.values(), 1.0), **drawn[i].numeric.floats}, sheet.steps)
        if not any(map(isnan, known.values())):
            yield drawn[i], known


def _with_lines(known: dict[str, float], steps: "Sequence[WorkedLine]") -> dict[str, float]:
    for line in steps:
        if line.letter and line.node is not None:
            with suppress(KeyError, ZeroDivisionError):
                known[line.letter], = evaluate([line.node], Floats, known)
    return known


def found_at(problem: "Problem", sheet: "WorkedSolution", asked: "Expression", least: int = INSTANCES
             ) -> "list[tuple[Mapping[str, float], float]]":
    """[({letter: number}, the number of the engine)] at instances that have it; none where fewer than `least` of a
    scene in letters have."""
    found, enough = [], INSTANCES if problem.numeric.has_free_symbols else 1
    for one, known in instances(problem, sheet):
        with suppress(PhysicsError, SpecError):
            found.append((known, float(value_of(one, asked)[0])))
        if len(found) == enough:
            return found
    return found if len(found) >= min(least, enough) else []


def is_found(node: "Node", values: "Sequence[tuple[Mapping[str, float], float]]") -> bool:
    """Is an expression what the engine finds at every instance, zero but for the rounding of its terms?"""
    try:
        return bool(values) and all(abs(evaluate([node], Floats, known)[0] - value) <= max(
            CLOSE * abs(value), ROUNDING * _terms(node, known)) for known, value in values)
    except (KeyError, ValueError, ZeroDivisionError, TypeError):
        return False


def vanishes(node: "Node", values: "Sequence[tuple[Mapping[str, float], float]]") -> bool:
    """Is what the engine finds at every instance no more than the rounding of the terms of an expression?"""
    return bool(values) and not node.is_zero and all(
        abs(value) <= ROUNDING * _terms(node, known) for known, value in values)


def _terms(node: "Node", known: Mapping[str, float]) -> float:
    """The sum of the magnitudes of its terms, 0 of what is no sum."""
    if node.op == "product":
        sums = [base for base, e in node.args if base.op == "sum" and e == 1]
        return 0.0 if len(sums) != 1 else abs(evaluate([node / sums[0]], Floats, known)[0]) * _terms(sums[0], known)
    terms = [part * c for part, c in node.args] if node.op == "sum" else []
    return sum(map(abs, evaluate(terms, Floats, known))) if terms else 0.0
