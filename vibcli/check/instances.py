"""Instances of a scene with values for its free symbols and for what it chooses: the same at every run."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.results.random_states import random_instances

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

ENOUGH = 3
FAILURES = 8        # instances without a solution after which the search for what is chosen is given up


class Instances:
    """Numeric Problems of a scene: itself, or with random values for its symbols for which the drawing fits together;
    with values for what it chooses. Made when they are asked for and kept; `wanted` is how many of them a comparison
    takes."""

    def __init__(self, problem: "Problem") -> None:
        symbolic = bool(problem.symbolic.letters)
        self.wanted = ENOUGH if symbolic else 1
        self._known = [] if symbolic else [_with_choices(problem)]
        self._candidates = _candidates(problem) if symbolic else iter(())

    def __iter__(self) -> "Iterator[Problem]":
        yield from self._known
        for problem in self._candidates:
            self._known.append(problem)
            yield problem


def _candidates(problem: "Problem") -> "Iterator[Problem]":
    """Those for which what the scene chooses can be found; its refusal where that is so for none."""
    found, failed, refusal = 0, 0, None
    for candidate in _for_choices(problem) or random_instances(problem):
        try:
            chosen = _with_choices(candidate)
        except (SpecError, PhysicsError) as error:
            refusal, failed = refusal or error, failed + 1
            if failed >= FAILURES and not found:
                break
            continue
        found += 1
        yield chosen
    if not found and refusal is not None:
        raise refusal


def _for_choices(problem: "Problem") -> "list[Problem] | None":
    """Instances at which the first solution in letters of what a scene chooses is the first one; None without such."""
    if not problem.spec.choices:
        return None
    from vibcli.inverse import settled

    try:
        draws: list[Problem] = settled(problem).choice.draws
        return draws
    except PhysicsError:
        return None


def _with_choices(problem: "Problem") -> "Problem":
    """The problem with values for what it chooses."""
    if not problem.spec.choices:
        return problem
    from vibcli.inverse import settled

    return settled(problem)
