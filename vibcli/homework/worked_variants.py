"""Worked solutions of the variants of a problem: the path of the first, with the numbers of each put in anew.

The first variant is drawn and told by itself, and so is one that would be drawn otherwise. All others take the
expressions of one that was told: they go along its lines, where no expression is simplified again and numbers alone are
found. Where an R − r would be written as r − R, what was found so is left, and the variant told by itself.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vibcli.homework.document import SceneDocument, settings_of
from vibcli.report.steps.worked import worked
from vibcli.results.other_values import OtherValues

if TYPE_CHECKING:
    from vibcli.language.given_values import GivenValue
    from vibcli.report.steps.step import WorkedLine

MOST = 8        # variants whose expressions are kept for others


class WorkedVariants:
    """The lines of the variants of a document; alone: how many were told by themselves, sharing: how many by the
    expressions of others."""

    def __init__(self, document: SceneDocument):
        self._document = document
        self._told: list[OtherValues] = []
        self.alone = self.sharing = 0

    def lines(self, values: "Mapping[str, GivenValue]") -> "list[WorkedLine]":
        """The lines of the variant with these values; PhysicsError where its scene has none."""
        for one in self._told:
            found = self._along(one, values)
            if found is not None:
                self.sharing += 1
                return found
        self.alone += 1
        problem = self._document.anew(values)
        others = OtherValues(problem, in_letters=True)
        if len(self._told) < MOST and others.shares:
            self._told.append(others)
        return worked(problem)

    def _along(self, one: OtherValues, values: "Mapping[str, GivenValue]") -> "list[WorkedLine] | None":
        """The lines by the expressions of a variant that was told; None where they would be written otherwise."""
        problem = one.at(settings_of(values))
        if problem is None or not one.written_alike(problem):
            return None
        lines = worked(problem)
        return lines if one.written_alike(problem) else None
