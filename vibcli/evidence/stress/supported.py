"""How many digits of an answer the figures of its file support: each moved by half a unit of its last digit.

|y(p + δp) − y(p)| of each figure that is written with three digits or more (fewer are exact), summed over all; what
lies within the bounds of both is no move.
"""

import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.stress.figures import figures
from vibcli.language.document.nodes import Mapping
from vibcli.quantities.expression import bounded
from vibcli.quantities.quantity import COMPLEX, LEAPING, OF_STATE, kind_of
from vibcli.results.problem import Problem

if TYPE_CHECKING:
    from vibcli.language.reader import Expression

MOST = 17       # digits: a float has no more


class SupportedAnswer(NamedTuple):
    """An answer of a file: its value, the digits of it that the data support, None where nothing moves it; the
    figure that takes most of them: a parameter, or a number of an element; why: it has no number; held: the figures
    that cannot be moved alone, since nothing fits together then."""

    asked: str
    value: float | None
    digits: float | None
    parameter: str
    why: str = ""
    held: tuple[str, ...] = ()


def supported(problem: Problem, top: Mapping, remade: Callable[[Callable[[Mapping], Mapping]], Problem]
              ) -> Iterator[SupportedAnswer]:
    """The SupportedAnswer of each answer; top: of the document; remade(change): the scene of that changed."""
    moved, held = {}, []
    for figure in figures(top):
        try:
            other = remade(figure.change)
            other.draw()
            moved[figure.told] = other
        except (PhysicsError, SpecError):
            held.append(figure.told)
    for answer in problem.spec.answers:
        if kind_of(problem.spec, answer.asked.tree) not in (*OF_STATE, *LEAPING, COMPLEX):
            yield _support(problem, answer.asked, moved)._replace(held=tuple(held))


def _support(problem: Problem, asked: "Expression", moved: dict[str, Problem]) -> SupportedAnswer:
    try:
        value, error = bounded(problem, asked)
        apart = {told: _apart(value, error, *bounded(other, asked)) for told, other in moved.items()}
    except PhysicsError as error:
        return SupportedAnswer(asked.text, None, None, "", error.message)
    total = sum(apart.values())
    if not total:
        return SupportedAnswer(asked.text, float(value), None, "")
    digits = min(-math.log10(total / abs(value)), MOST) if value else 0.0
    return SupportedAnswer(asked.text, float(value), max(digits, 0.0), max(apart, key=apart.__getitem__))


def _apart(value: float, error: float, there: float, error_there: float) -> float:
    off = abs(there - value)
    return off if off > error + error_there else 0.0
