"""Variants of a scene in which letters are left: those drawn alike take the expressions that were found of one of them,
in which what is varied is a letter too, and put its numbers in.

An expression is taken where no R − r in it turns round, and where, at numbers for the letters, it is what the variant
answers: so modes that change places are found anew.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.homework.document import settings_of
from vibcli.homework.keys import ROUTES
from vibcli.quantities.expression import value_of
from vibcli.quantities.quantity import OF_STATE, kind_of
from vibcli.results.other_values import OtherValues
from vibcli.results.variants import Variants
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.language.given_values import GivenValue
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem

MOST = 8        # variants whose expressions are kept for others


class VariantsInLetters(Variants):
    """The Problems of a grid, of which parameters stay in letters. sharing: how many took the expressions of others."""

    sharing = 0

    def at(self, values: "Mapping[str, GivenValue]") -> "Problem | SpecError | PhysicsError":
        """The Problem of values, by the expressions of another where they hold, or why there is none."""
        for one in self._kept:
            found = one.at(values)
            if found is not None:
                self.sharing += 1
                return found
        problem = super().at(values)
        if not isinstance(problem, Exception) and len(self._kept) < MOST:
            self._kept.append(_Expressions(problem))
        return problem

    @cached_property
    def _kept(self) -> "list[_Expressions]":
        return []


class _Expressions:
    """What was found of a Problem in letters, to be put in at other values."""

    def __init__(self, problem: "Problem"):
        self.problem, self.others = problem, OtherValues(problem, in_letters=True)
        self._at_drawn: list[tuple[float, float] | None] = []

    def at(self, values: "Mapping[str, GivenValue]") -> "Problem | None":
        """The Problem at values; None where the expressions are to be found anew."""
        if not self.problem.lettered:
            return None
        found = self.others.at(settings_of(values))
        if found is None or not self.others.written_alike(found) or not self._hold(found):
            return None
        found.lettered.update(self.problem.lettered)
        return found

    def _hold(self, found: "Problem") -> bool:
        """Does a Problem give at numbers for its letters what the expressions give there, and no answer where that of
        the expressions gives none? Energies and equations hold as they are drawn."""
        known = list(self.problem.lettered.values())
        asked = [one for one, _ in known]
        for (_, node), number, own in zip(known, _numbers(found, asked), self._own(asked), strict=True):
            if (number is None) != (own is None):
                return False
            if number is not None and not isinstance(node, PhysicsError):
                value, error = number
                other, = evaluate([node], Floats, found.scene.sample)
                if not abs(other - value) <= ROUTES * abs(value) + error:
                    return False
        return True

    def _own(self, asked: "Sequence[Expression]") -> list[tuple[float, float] | None]:
        """What the Problem itself gives at numbers for its letters."""
        if len(self._at_drawn) != len(asked):
            self._at_drawn = _numbers(self.problem, asked)
        return self._at_drawn


def _numbers(problem: "Problem", asked: "Sequence[Expression]") -> list[tuple[float, float] | None]:
    """(value, error) of each at numbers for the letters, those of the drawing; None of what has none, as of energies
    and equations."""
    drawn = {name: Fraction(problem.scene.sample[name]) for name in problem.symbolic.letters}
    instance, found = problem.sharing(drawn), []
    for one in asked:
        try:
            of_state = kind_of(problem.spec, one.tree) in OF_STATE
            found.append(None if of_state else value_of(instance, one))
        except (SpecError, PhysicsError):
            found.append(None)
    return found
