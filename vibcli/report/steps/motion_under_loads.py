"""The steps to the motion of several degrees of freedom in numbers under loads that begin, end and strike, or any that
do not swing for ever: by real modes where damping leaves them apart, else by complex ones."""

from vibcli.report.steps.complex_modes_under_pieces import tell_complex_modes_under
from vibcli.report.steps.from_modes import modes_of
from vibcli.report.steps.from_start import MOST, start_from_rest
from vibcli.report.steps.held import SmallEquations
from vibcli.report.steps.loads_on_modes import loads_on_modes
from vibcli.report.steps.modes_under_pieces import ModesUnderPieces
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.step import WorkedSolution


def tell_under_loads(about: AboutRest, sheet: WorkedSolution, found: SmallEquations) -> None:
    """Write down all of it; nothing of letters, of what is gyroscopic, and where the modes do not add up to it."""
    problem, n = about.problem, len(about.scene.q)
    if problem.numeric.has_free_symbols or found.G or n > MOST:
        return
    start = [[0.0] * n, [0.0] * n] if problem.spec.get("initial") is None else start_from_rest(problem)
    if start is None:
        return
    loads, before, modes = loads_on_modes(about, found.drive), len(sheet.steps), modes_of(problem, start)
    if modes and ModesUnderPieces(about, sheet, found, modes, loads).write():
        return
    del sheet.steps[before:]
    if found.C and not modes and tell_complex_modes_under(about, sheet, found, start, loads):
        return
    del sheet.steps[before:]
    sheet.by_pieces.clear()
