"""Which modes have lines of their own: the first ones, and those that are asked."""

from math import isclose
from typing import TYPE_CHECKING, Any, cast

from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.analyses.modal.undamped import Mode
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node

FIRST, HIGHEST = 3, 20      # modes that are told in any case, and the highest that is told as it is asked
HEADS = frozenset({"omega", "frequency", "period"})


def asked_modes(problem: "Problem") -> set[int]:
    """The numbers of modes whose frequencies answers and variants ask."""
    rules = problem.spec.get("variants")
    trees = [tree for one in (*(rules.ask if rules is not None else ()), *problem.spec.answers)
             for tree in one.asked.parts.quantities if tree.head in HEADS and tree.indices]
    numbers = {int(str(tree.indices[0])) for tree in trees if str(tree.indices[0]).isdigit()}
    return {number for number in numbers if number <= HIGHEST}


def told_modes(problem: "Problem", enough: int = FIRST) -> "Sequence[Mode]":
    """So many modes, and as many more as reach all that are asked."""
    return cast("Sequence[Mode]", problem.modal.modes.first(max({enough, *asked_modes(problem)})))


def moving_alike(found: Any, mode: "Mode", floats: "Mapping[str, float]") -> "Node | None":
    """ω of a mode in which all of a member moves as a rigid body on what it lies on, βL = 0; None of others."""
    square, = substitute([found.square], {found.wave_number: found.square.table.zero})
    value, = evaluate([square], Floats, floats)
    alike = mode.omega and isclose(value, float(mode.omega)**2, rel_tol=1e-9)
    return square.table.sqrt(square) if alike else None
