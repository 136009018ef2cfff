"""What of a scene is compared: the numbers that it asks, all modes being one."""

from collections.abc import Callable, Iterable, Iterator
from importlib import import_module
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.subject import ALONE, Subject
from vibcli.evidence.subjects import DAMPED, NATURAL, SUBJECTS
from vibcli.quantities.quantity import declared, named
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem

ALL_MODES = ("omega", "frequency", "zeta", "omega_d", "eigenvalue")


class NotCompared(NamedTuple):
    """What is not compared, and why."""

    asked: str
    why: str


def subjects(problem: "Problem", asked: "Iterable[Expression]") -> Iterator[Subject | NotCompared]:
    """A Subject of each quantity; those of modes once. Of a file that asks none its modes, damped where they are."""
    made = set()
    for text, tree, make in _makers(problem, asked):
        one = make if make in (NATURAL, DAMPED) else text
        if one in made:
            continue
        made.add(one)
        if make is None:
            yield NotCompared(text, ALONE)
        else:
            try:
                yield _function(make)(problem, tree)
            except PhysicsError as error:
                yield NotCompared(text, error.message)


def _makers(problem, asked):
    """(text, tree, what makes its Subject, None where nothing does)."""
    found = [(tree.text, tree, _maker(tree)) for expression in asked for tree in expression.parts.quantities]
    if found:
        return found
    return [(head, None, SUBJECTS[head]) for head in ("omega", *["eigenvalue"] * problem.modal.damps)]


def _maker(tree: QuantityRef):
    found = SUBJECTS.get("value" if declared(tree) is named("value") else tree.head)
    return None if found in (NATURAL, DAMPED) and tree.args else found      # period(x) is that of a motion


def _function(make) -> Callable[["Problem", QuantityRef | None], Subject]:
    file, name = make
    return getattr(import_module(f"vibcli.evidence.subjects.{file}"), name)
