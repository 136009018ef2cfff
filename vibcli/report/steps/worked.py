"""All steps of a scene."""

from typing import TYPE_CHECKING

from vibcli.report.steps.one_degree import OneDegree
from vibcli.report.steps.several_degrees import SeveralDegrees
from vibcli.report.steps.small_oscillations import Derivation
from vibcli.report.steps.step import WorkedLine, WorkedSolution

if TYPE_CHECKING:
    from vibcli.results.problem import Problem


def worked(problem: "Problem") -> list[WorkedLine]:
    """The steps of small oscillations."""
    sheet = WorkedSolution([*problem.spec.parameters, *problem.spec.coordinates, *problem.scene.coordinates])
    derivation = Derivation(problem, sheet)
    found = derivation.equations()
    if len(problem.scene.q) == 1:
        OneDegree(problem, derivation.about, sheet, found).write()
    else:
        SeveralDegrees(problem, derivation.about, sheet, found).write()
    return sheet.steps
