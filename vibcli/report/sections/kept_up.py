"""The steady state of a scene that something drives to and fro, told without being asked for."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError
from vibcli.report.blocks import Section, TableBlock

if TYPE_CHECKING:
    from vibcli.report.document import Report
    from vibcli.results.problem import Problem

ENDING = {"step", "ramp", "impulse"}        # what does not go on to and fro


def kept_up(problem: "Problem", report: "Report") -> Iterator[Section]:
    """Nothing where there is no such steady state of small oscillations."""
    scene = problem.scene
    if not scene.timed or scene.pieces or problem.spec.in_full or scene.table.records or scene.table.called & ENDING:
        return
    try:
        found = list(_in_letters(problem) if problem.numeric.has_free_symbols else _in_numbers(problem, report))
    except PhysicsError:
        return
    yield from found


def _in_numbers(problem, report):
    from vibcli.report.sections.requested_signals import signals_asked
    from vibcli.report.sections.steady_state import steady_state

    motion = problem.response
    if motion.KIND == "small" and motion.drive:
        for one in steady_state(signals_asked(problem), report.wanted.phase):
            if any(isinstance(block, TableBlock) for block in one.blocks):
                yield one


def _in_letters(problem):
    from vibcli.report.sections.symbolic_response import steady_section

    names = problem.scene.coordinates
    for number, name in enumerate(names, 1):
        yield from steady_section(problem, name, problem.symbolic_steady_state(name), str(number) * (len(names) > 1))
