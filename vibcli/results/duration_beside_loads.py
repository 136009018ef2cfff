"""How long a motion is looked at that loads drive: as long as its modes are, and as the loads change."""

from math import tau
from typing import TYPE_CHECKING

from vibcli.analyses.excitation.load_times import load_times
from vibcli.analyses.transient.duration import duration
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.results.problem import Problem

SWINGS, LONGER = 2, 200         # swings of the slowest load that are looked at, as long as that is no longer so often


def duration_beside_loads(problem: "Problem", modes: "Sequence[Mode]", damped: "Sequence[DampedMode] | None",
                          say_until: "Callable[[], str]") -> float:
    """The duration [s] of modes, of loads that change their form or die out, and of some swings of these where nothing
    grows; say_until(): what to do where that is too long."""
    loads = load_times(problem.scene, problem.numeric.floats, problem.work)
    alone, found = duration(modes, damped, 0.0, []), duration(modes, damped, loads.last, [], loads.fading)
    if loads.speeds and not any(mode.growth_rate for mode in (damped or modes)):
        found = max(found, loads.last + SWINGS * tau / loads.speeds[0])
    if found > LONGER * alone * problem.work.patience:
        raise PhysicsError(f"loads are so late or slow that this motion would be followed up to t = {found:.4g} s, "
                           f"{found / alone:.3g} times as long as without them", say_until())
    return found
