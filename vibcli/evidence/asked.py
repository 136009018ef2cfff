"""What of a scene is compared: the numbers that it asks, all modes being one."""

from collections.abc import Callable, Iterable, Iterator
from importlib import import_module
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.subject import ALONE, COUNTED, NO_NUMBER, Subject
from vibcli.evidence.subjects import DAMPED, NATURAL, SUBJECTS
from vibcli.quantities import FORMS
from vibcli.quantities.quantity import COUNT, OF_STATE, TRUTH, declared, named
from vibcli.symbolic.syntax import QuantityRef

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem

PARTS = ("re", "im", "arg")
ALL_MODES = ("omega", "frequency", "zeta", "omega_d", "eigenvalue")


class NotCompared(NamedTuple):
    """What is not compared, and why."""

    asked: str
    why: str


def subjects(problem: "Problem", asked: "Iterable[Expression]", or_modes: bool = True
             ) -> Iterator[Subject | NotCompared]:
    """A Subject of each quantity; those of modes once. Where none is asked the modes, damped where they are, unless not
    `or_modes`."""
    made = set()
    for text, tree, make in _makers(problem, asked, or_modes):
        one = make if make in (NATURAL, DAMPED) else text
        if one in made:
            continue
        made.add(one)
        if make is None:
            yield NotCompared(text, _why_not(tree))
        else:
            try:
                yield _function(make)(problem, tree)
            except PhysicsError as error:
                yield NotCompared(text, error.message)


def _makers(problem, asked, or_modes):
    """(text, tree, what makes its Subject, None where nothing does, as of what is made of parameters alone)."""
    found = [(tree.text, tree, _maker(tree)) if tree else (expression.text, None, None)
             for expression in asked for tree in expression.parts.quantities or (None,)]
    if not or_modes or any(tree for _, tree, _ in found):
        return found
    return found + [(head, None, SUBJECTS[head]) for head in ("omega", *["eigenvalue"] * problem.modal.damps)]


def _maker(tree: QuantityRef):
    if tree.head in PARTS and SUBJECTS.get(getattr(tree.args[0], "head", "")) == DAMPED:
        return DAMPED               # of a shape
    made = declared(tree)
    found = SUBJECTS.get(next((form for form in FORMS if form in SUBJECTS and made is named(form)), tree.head))
    return None if found in (NATURAL, DAMPED) and tree.args else found


def _why_not(tree: QuantityRef | None) -> str:
    """Why nothing else finds it."""
    quantity = declared(tree) if tree else None     # none of a value of a parameter that is chosen
    kind = quantity.kind if quantity else None
    return COUNTED if kind == COUNT else NO_NUMBER if kind in (*OF_STATE, TRUTH) else ALONE


def _function(make) -> Callable[["Problem", QuantityRef | None], Subject]:
    file, name = make
    return getattr(import_module(f"vibcli.evidence.subjects.{file}"), name)
