"""The steps from the equations of several degrees of freedom to what loads keep up, one frequency after the other, or
to what follows loads that grow."""

from typing import TYPE_CHECKING

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.mechanics.given_damping_in_letters import proportional
from vibcli.report.steps.damping_by_modes import with_damping_by_modes
from vibcli.report.steps.from_start import tell_driven_from_start
from vibcli.report.steps.growing_loads import tell_growing
from vibcli.report.steps.held import SmallEquations, Untold
from vibcli.report.steps.motion_under_loads import tell_under_loads
from vibcli.report.steps.small import AboutRest
from vibcli.report.steps.steady_states import SteadyState
from vibcli.report.steps.step import WorkedSolution

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def tell_loads(about: AboutRest, sheet: WorkedSolution, found: SmallEquations) -> None:
    """Write down what each frequency of the loads keeps up, or what follows loads that grow; nothing of other loads."""
    if not found.drive or about.problem.spec.in_full:
        return
    before = len(sheet.steps)
    try:
        found = with_damping_by_modes(about, sheet, found)
        acting = _waves(about, found)
    except (NotInLetters, Untold):
        del sheet.steps[before:]
        tell_under_loads(about, sheet, found)
        return
    if not acting:
        tell_growing(about, sheet, found)
    driven: dict[Node, dict[int, dict[str, Node]]] = {}
    for i, parts in acting.items():
        for (argument, wave), node in parts.items():
            driven.setdefault(argument, {}).setdefault(i, {})[wave] = node
    try:
        kept = []
        for order, (argument, loads) in enumerate(driven.items(), 1):
            steady = SteadyState(about, sheet, found, argument, loads)
            kept.append((steady, steady.write(order, len(driven) > 1)))
        if kept and all(amplitudes for _, amplitudes in kept):
            tell_driven_from_start(kept, [sheet.last])
    except (PhysicsError, ZeroDivisionError):
        del sheet.steps[before:]


def _waves(about: AboutRest, found: SmallEquations) -> "dict[int, dict[tuple[Node, str], Node]]":
    """Those of each row; none of loads that grow, NotInLetters of these with damping by modes."""
    from vibcli.analyses.closed_form.powers_of_time import are_powers
    from vibcli.analyses.closed_form.steady_state import waves_of_all

    if proportional(about.problem.spec) and are_powers(about.problem.symbolic):
        return {}
    return waves_of_all(about.scene, found.drive)
