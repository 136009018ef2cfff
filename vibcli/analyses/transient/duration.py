"""How long a motion is looked at where nobody says: until it has died out, or for some of its longest periods."""

from collections.abc import Sequence
from itertools import pairwise
from math import log, tau
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.undamped import Mode

DYING, PERIODS, MOST = log(1000), 10, 60
GONE = 2.5          # of those times: what is left after twice as long is below rounding


def duration(modes: "Sequence[Mode]", damped: "Sequence[DampedMode] | None", last: float,
             speeds: Sequence[float]) -> float:
    """Seconds: `last` is the last instant at which the forcing changes its form, `speeds` its angular frequencies."""
    frequencies = [mode.omega for mode in modes if mode.omega]
    decays = []
    if damped is not None:
        frequencies = [_seen(mode) for mode in damped if mode.omega_d]
        decays = [-mode.eigenvalue.real for mode in damped if mode.eigenvalue.real < 0]
    growths = [mode.growth_rate for mode in (damped or modes) if mode.growth_rate]
    longest = max((tau / float(omega) for omega in (*frequencies, *speeds)), default=0.0)
    if growths:
        return last + min(DYING / float(max(growths)), PERIODS * longest or float("inf"))
    if decays:
        dying = DYING / float(min(decays))
        return last + (min(max(dying, 2 * longest), MOST * longest) if longest else dying)
    if longest:
        return last + max(PERIODS * longest, min(2 * _beat(frequencies), MOST * longest))
    return 2 * last or 1.0


def _seen(mode):
    """The damped frequency of a mode; of one that dies out long before it has swung once, of so long as it is seen."""
    decay = -float(mode.eigenvalue.real)
    return max(float(mode.omega_d), tau * decay / (GONE * DYING))


def _beat(frequencies):
    """The longest beat period of neighbouring frequencies, 0 of one alone."""
    ordered = sorted(map(float, frequencies))
    gaps = [b - a for a, b in pairwise(ordered) if b > a]
    return tau / min(gaps) if gaps else 0.0
