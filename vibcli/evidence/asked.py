"""What of a scene is compared: the numbers that it asks, all modes being one."""

from collections.abc import Iterable, Iterator
from importlib import import_module
from typing import TYPE_CHECKING, Any, cast

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.subject import ALONE, COUNTED, NO_NUMBER, Subject
from vibcli.evidence.subjects import DAMPED, NATURAL, SUBJECTS
from vibcli.quantities import FORMS
from vibcli.quantities.quantity import COUNT, OF_STATE, TRUTH, declared, is_choice, named
from vibcli.symbolic.syntax import NameRef, QuantityRef

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem

PARTS = ("re", "im", "arg")
ALL_MODES = ("omega", "frequency", "zeta", "omega_d", "eigenvalue")
CHOSEN = ("", "chosen")         # of parameters that conditions determine


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
                yield _subject(problem, tree, make)
            except PhysicsError as error:
                yield NotCompared(text, error.message)


def _makers(problem: "Problem", asked: "Iterable[Expression]",
            or_modes: bool) -> list[tuple[str, NameRef | QuantityRef | None, tuple[str, str]]]:
    """(text, tree, what makes its Subject, None where nothing does, as of what is made of parameters alone)."""
    found = [(tree.text if isinstance(tree, QuantityRef) else expression.text, tree, _maker(problem.spec, tree))
             for expression in asked for tree in expression.parts.quantities or (expression.tree,)]
    if not or_modes or any(isinstance(tree, QuantityRef) for _, tree, _ in found):
        return found
    return found + [(head, None, SUBJECTS[head]) for head in ("omega", *["eigenvalue"] * problem.modal.damps)]


def _maker(spec: "Spec", tree: NameRef | QuantityRef) -> tuple[str, str] | None:
    if isinstance(tree, (QuantityRef, NameRef)) and is_choice(spec, tree):
        return CHOSEN
    if not isinstance(tree, QuantityRef):
        return None
    if tree.head in PARTS and SUBJECTS.get(getattr(tree.args[0], "head", "")) == DAMPED:
        return DAMPED               # of a shape
    made = declared(tree)
    found = SUBJECTS.get(next((form for form in FORMS if form in SUBJECTS and made is named(form)), tree.head))
    return None if found in (NATURAL, DAMPED) and tree.args else found


def _why_not(tree: Any) -> str:
    """Why nothing else finds it."""
    quantity = declared(tree) if isinstance(tree, QuantityRef) else None
    kind = quantity.kind if quantity else None
    return COUNTED if kind == COUNT else NO_NUMBER if kind in (*OF_STATE, TRUTH) else ALONE


def _subject(problem: "Problem", tree: NameRef | QuantityRef | None, make: tuple[str, str]) -> Subject:
    if make is CHOSEN:
        from vibcli.evidence.chosen import chosen

        return chosen(problem, tree, _needed)
    file, name = make
    return cast("Subject", getattr(import_module(f"vibcli.evidence.subjects.{file}"), name)(problem, tree))


def _needed(problem: "Problem", tree: QuantityRef) -> Subject:
    """That of a quantity which a condition names."""
    make = _maker(problem.spec, tree)
    if make is None:
        raise PhysicsError(f"no reference is found of {tree.text}, which is to be chosen for")
    return _subject(problem, tree, make)
