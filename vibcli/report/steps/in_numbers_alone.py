"""What a worked solution in letters leaves to numbers, by name, and why where it has no formula."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.notation.as_printed import as_printed
from vibcli.report.blocks import Words
from vibcli.report.steps.free_waves import waves_of
from vibcli.report.steps.step import WorkedSolution

if TYPE_CHECKING:
    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import NameRef

TURNING = {"max", "min", "argmax", "argmin", "overshoot"}
SEVERAL = "where several vibrations at once turn back is a root of an equation without a formula; in numbers (--set):  "
OTHERS = "told in numbers alone (--set):  "


def tell_left(problem: "Problem", sheet: WorkedSolution, left: "Sequence[Expression]") -> None:
    """Write down the names of what no line tells in letters."""
    names = {*problem.spec.parameters, *problem.spec.coordinates}
    turning = [one for one in left if getattr(one.tree, "head", "") in TURNING and _is_of_several(
        problem, sheet, one.tree.args[0])]
    for words, group in ((SEVERAL, turning), (OTHERS, [one for one in left if one not in turning])):
        if group:
            sheet.write(Words(words + ",  ".join(as_printed(one.text, names) for one in group)))


def _is_of_several(problem: "Problem", sheet: WorkedSolution, signal: "NameRef") -> bool:
    """Do lines tell the motion of a signal as a sum of several vibrations?"""
    try:
        return len(waves_of(problem, sheet, signal)) > 1
    except PhysicsError:
        return False
