"""A second way to keys that are numbers: their closed forms, where scenes have them, at the values of all variants."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.homework.keys import ROUTES, AnswerKey
from vibcli.quantities.letters import expression_in_letters
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.homework.solved import Candidate
    from vibcli.results.problem import Problem
    from vibcli.results.variants import Place
    from vibcli.symbolic.node import Node

DIGITS = 40         # of a closed form where floats do not agree: terms in it may cancel


def hold_against_closed_forms(keys: "Sequence[AnswerKey]", base: "Problem", solved: "Mapping[Place, Candidate]",
                              scene_at: "Callable[[Place], Any]") -> dict[str, int]:
    """{quantity: in how many candidates its closed form gives the key}, those without one left out. The form is derived
    from the scene `base`, and anew from one with which it does not agree. RuntimeError, a fault of ours, where that is
    not its key."""
    found = {}
    if solved and not base.spec.choices:
        for i, key in enumerate(keys):
            node = _closed(base, key) if type(key) is AnswerKey else None
            if node is not None:
                at_all = _at(base, node, [one.values for one in solved.values()])
                found[key.text] = sum(_holds(key, one.found[i], value, partial(scene_at, place))
                                      for (place, one), value in zip(solved.items(), at_all, strict=True))
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


def _holds(key: AnswerKey, found: tuple[float, float], value: Any, scene: "Callable[[], Problem]") -> bool:
    """Has a candidate a closed form of a key, which agrees? found: (key, its error bound); value: what the form of the
    base gives."""
    own, error = found
    if abs(value / key.factor - own) <= ROUTES * abs(own) + error:
        return True
    problem = scene()
    node = _closed(problem, key)
    if node is None:
        return False
    import mpmath

    with mpmath.workdps(DIGITS):
        arithmetic = multiprecision()
        value, = evaluate([node], arithmetic, problem.numeric.values(arithmetic))
        if abs(value / key.factor - own) > ROUTES * abs(own) + error:
            said = ", ".join(f"{name} = {number:.17g}" for name, number in problem.numeric.given.items())
            raise RuntimeError(f"two ways to {key.text} differ, {own!r} and in closed form "
                               f"{mpmath.nstr(value / key.factor, 17)}, at {said}")
    return True
