"""What of a scene is compared: the numbers that it asks, all modes being one."""

from collections.abc import Callable, Iterable, Iterator
from importlib import import_module
from typing import TYPE_CHECKING, NamedTuple

from vibcli.base.errors import PhysicsError
from vibcli.evidence.subject import Subject
from vibcli.quantities.quantity import declared, named
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem

NATURAL, DAMPED = ("eigenvalue_subjects", "natural"), ("eigenvalue_subjects", "damped")
SUBJECTS = {    # {quantity: (file, function that makes the Subject of it)}
    **dict.fromkeys(("omega", "frequency", "period", "growth_rate", "mode", "modal_mass"), NATURAL),
    **dict.fromkeys(("value", "max", "min", "argmax", "argmin"), ("motion_subjects", "of_motion")),
    **dict.fromkeys(("zeta", "omega_d", "period_d", "decay", "eigenvalue", "mode_d"), DAMPED),
}
ALL_MODES = ("omega", "eigenvalue")


class LeftOut(NamedTuple):
    """What is not compared, and why."""

    asked: str
    why: str


def subjects(problem: "Problem", asked: "Iterable[Expression]") -> Iterator[Subject | LeftOut]:
    """A Subject of each quantity; those of modes once. Of a file that asks none its modes, damped where they are."""
    made = set()
    for text, tree, make in _makers(problem, asked):
        if make is None:
            yield LeftOut(text, "no other method is known here")
        elif make not in made:
            made |= {make} & {NATURAL, DAMPED}
            try:
                yield _function(make)(problem, tree)
            except PhysicsError as error:
                yield LeftOut(text, error.message)


def _makers(problem, asked):
    """(text, tree, what makes its Subject, None where nothing does)."""
    found = [(tree.text, tree, _maker(tree)) for expression in asked for tree in expression.parts.quantities]
    if found:
        return found
    return [(head, None, SUBJECTS[head]) for head in ALL_MODES if head == "omega" or problem.modal.damps]


def _maker(tree: QuantityRef):
    return SUBJECTS.get("value" if declared(tree) is named("value") else tree.head)


def _function(make) -> Callable[["Problem", QuantityRef | None], Subject]:
    file, name = make
    return getattr(import_module(f"vibcli.evidence.{file}"), name)
