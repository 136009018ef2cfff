"""What a worked solution in letters leaves to numbers, by name, and why where it has no formula."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.notation.as_printed import as_printed
from vibcli.report.blocks import Words
from vibcli.report.steps.step import WorkedSolution

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem

TURNING = {"max", "min", "argmax", "argmin", "overshoot"}
SEVERAL = "where several vibrations at once turn back is a root of an equation without a formula; in numbers (--set):  "
OTHERS = "told in numbers alone (--set):  "


def tell_left(problem: "Problem", sheet: WorkedSolution, left: "Sequence[Expression]") -> None:
    """Write down the names of what no line tells in letters."""
    names = {*problem.spec.parameters, *problem.spec.coordinates}
    several = len(problem.scene.q) > 1 and not problem.spec.in_full and not problem.scene.laws
    turning = [one for one in left if several and getattr(one.tree, "head", "") in TURNING]
    for words, group in ((SEVERAL, turning), (OTHERS, [one for one in left if one not in turning])):
        if group:
            sheet.write(Words(words + ",  ".join(as_printed(one.text, names) for one in group)))
