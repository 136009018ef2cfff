"""How long a signal takes to come back, in letters: 2π/Ω under loads, the slowest of several, 2π/ω of a free motion;
half of that of what is a square of these."""

from typing import TYPE_CHECKING

from vibcli.analyses.closed_form.steady_state import waves_of_all
from vibcli.report.steps.held_against import tell_found
from vibcli.report.steps.step import WorkedSolution
from vibcli.symbolic.derivatives import gradient

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.language.reader import Expression
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node


def tell_period(problem: "Problem", sheet: WorkedSolution, asked: "Expression") -> bool:
    """Is it asked, and written down?"""
    if getattr(asked.tree, "head", "") != "period" or not asked.tree.args:
        return False
    return tell_found(problem, sheet, asked, ((node, [node]) for node in _forms(problem, sheet)), [sheet.last])


def _forms(problem: "Problem", sheet: WorkedSolution) -> "Iterator[Node]":
    table, time = problem.scene.table, problem.scene.time
    waves = waves_of_all(problem.scene, problem.symbolic.excitation)
    rates = dict.fromkeys(gradient(argument)[time] for kinds in waves.values() for argument, _ in kinds)
    omega = sheet.letter("omega")
    if not rates and any(line.letter == omega for line in sheet.steps):
        rates = {table.parameter(omega): None}
    for turn in (2, 1):
        yield from (turn * table.pi / rate for rate in rates)
