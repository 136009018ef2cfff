"""What signals of small motions come to when what is free has died out."""

from typing import TYPE_CHECKING, cast

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference import long_after
from vibcli.evidence.reference.motion import small
from vibcli.evidence.reference.outputs import signal
from vibcli.evidence.subject import Subject, of_signal
from vibcli.evidence.subjects.vibrations import KIND, exact
from vibcli.quantities.expression import measure

if TYPE_CHECKING:
    from vibcli.evidence.reference.motion import Motion
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import NameRef, QuantityRef, Sum

TITLE = "when what is free has died out"


def limit(problem: "Problem", tree: "QuantityRef") -> Subject:
    """final(x)"""
    motion, node = _signal(problem, tree.args[0])
    measure(problem, tree)          # refused where there is none
    return of_signal(KIND, problem, tree, TITLE, long_after.limit(motion, node, _last(problem)), None)


def steady_value(problem: "Problem", tree: "QuantityRef") -> Subject:
    """steady(x)(t) under loads that are powers of the time."""
    motion, node = _signal(problem, tree.args[0].args[0])
    measure(problem, tree)
    true = long_after.value(motion, node, _last(problem), exact(problem, tree.args[1]))
    return of_signal(KIND, problem, tree, TITLE, true, None)


def _signal(problem: "Problem", tree: "NameRef | Sum") -> "tuple[Motion, Node]":
    if problem.scene.pieces or problem.response.KIND != "small":
        raise PhysicsError("no reference is found of what this kind of motion comes to")
    return signal(problem, small(problem), tree)


def _last(problem: "Problem") -> float:
    """An instant after the last change of the loads."""
    return cast("float", max(problem.response.forcing().last.start, 1.0))
