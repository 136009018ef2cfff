"""A second way to keys that are numbers: their closed forms, where scenes have them, at the values of all variants."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.homework.keys import ROUTES, AnswerKey
from vibcli.inverse.letters import expression_in_letters
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.homework.solved import Candidate
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

DIGITS = 40         # of a closed form where floats do not agree: terms in it may cancel


def hold_against_closed_forms(keys: "Sequence[AnswerKey]", solved: "Sequence[Candidate]") -> dict[str, int]:
    """{quantity: in how many candidates its closed form gives the key}, those without one left out. The form is derived
    from the first candidate, and anew from one with which it does not agree. RuntimeError, a fault of ours, where that
    is not its key."""
    found = {}
    if solved and not solved[0].problem.spec.choices:
        for i, key in enumerate(keys):
            node = _closed(solved[0].problem, key) if type(key) is AnswerKey else None
            if node is not None:
                found[key.text] = sum(_holds(key, i, one, value) for one, value in zip(
                    solved, _at(solved[0].problem, node, [one.values for one in solved]), strict=True))
    return found


def _closed(problem: "Problem", key: AnswerKey) -> "Node | None":
    """What is asked in letters, None where it is found in numbers alone."""
    try:
        return expression_in_letters(problem, key.asked)
    except (PhysicsError, SpecError):
        return None


def _at(problem: "Problem", node: "Node", values: Sequence[Mapping[str, Any]]) -> np.ndarray:
    """A closed form at the values of all, NaN where it has none."""
    known = {name: float(value) for name, value in problem.numeric.given.items()}
    given = {name: np.array([float(one[name].exact) for one in values]) for name in values[0]}
    with np.errstate(all="ignore"):
        found, = evaluate([node], Arrays, problem.scene.parameters.values(Arrays, {**known, **given}))
    return np.broadcast_to(np.asarray(found), (len(values),))


def _holds(key: AnswerKey, i: int, one: "Candidate", value: Any) -> bool:
    """Has a candidate a closed form of a key, which agrees? value: what that of another one gives."""
    own, error = one.found[i]
    if abs(value / key.factor - own) <= ROUTES * abs(own) + error:
        return True
    node = _closed(one.problem, key)
    if node is None:
        return False
    import mpmath

    with mpmath.workdps(DIGITS):
        arithmetic = multiprecision()
        value, = evaluate([node], arithmetic, one.problem.numeric.values(arithmetic))
        if abs(value / key.factor - own) > ROUTES * abs(own) + error:
            said = ", ".join(each.text for each in one.values.values())
            raise RuntimeError(f"two ways to {key.text} differ, {own!r} and in closed form "
                               f"{mpmath.nstr(value / key.factor, 17)}, at {said}")
    return True
