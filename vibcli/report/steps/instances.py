"""A scene in numbers, at which expressions by the letters of lines are held against what the engine finds: itself, or
with some values of its letters."""

from collections.abc import Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.quantities.expression import value_of
from vibcli.results.random_states import random_instances
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

CLOSE = 1e-9        # relative: of a line and the engine's number
INSTANCES = 3       # of a scene in letters


def instances(problem: "Problem", steps: "Sequence[Any]") -> "list[tuple[Problem, Mapping[str, float]]]":
    """[(the problem in numbers, {letter: number} of its parameters and of the lines)]."""
    if not problem.numeric.has_free_symbols:
        return [(problem, {**problem.numeric.floats, **{line.letter: line.value for line in steps
                                                        if line.letter and line.value is not None}})]
    return [(one, _with_lines(dict(one.numeric.floats), steps))
            for _, one in zip(range(INSTANCES), random_instances(problem), strict=False)]


def _with_lines(known, steps):
    for line in steps:
        if line.letter and line.node is not None:
            with suppress(KeyError, ValueError, ZeroDivisionError):
                known[line.letter], = evaluate([line.node], Floats, known)
    return known


def found_at(of: "Sequence[tuple[Problem, Mapping[str, float]]]", asked: "Expression"
             ) -> "list[tuple[Mapping[str, float], float]]":
    """[({letter: number}, the number of the engine)] at each instance; none where it refuses one."""
    try:
        return [(known, float(value_of(one, asked)[0])) for one, known in of]
    except (PhysicsError, SpecError):
        return []


def is_found(node: "Node", values: "Sequence[tuple[Mapping[str, float], float]]") -> bool:
    """Is an expression what the engine finds at every instance?"""
    try:
        return bool(values) and all(abs(evaluate([node], Floats, known)[0] - value) <= CLOSE * abs(value)
                                    for known, value in values)
    except (KeyError, ValueError, ZeroDivisionError, TypeError):
        return False
