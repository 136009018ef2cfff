"""How long a motion is looked at where nobody says: until it has died out, or for some of its longest periods."""

from collections.abc import Sequence
from itertools import pairwise
from math import log, tau
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.undamped import Mode

DYING, PERIODS, MOST = log(1000), 10, 60
LATER = 3           # e-foldings more for each power of the time
GONE = 2.5          # of those times: what is left after twice as long is below rounding


def duration(modes: "Sequence[Mode]", damped: "Sequence[DampedMode] | None", last: float,
             speeds: Sequence[float], fading: float = 0.0) -> float:
    """Seconds: `last` is the last instant at which the forcing changes its form, `speeds` its angular frequencies,
    `fading` how long it takes from then on to die out."""
    return last + max(_moving(modes, damped, last, speeds), fading)


def fading(forcing: "Forcing") -> float:
    """Seconds from its last change on in which what dies out of a Forcing, e^{-at} or tᵏe^{-at}, has fallen to 1/1000
    of its largest value or less; 0 where nothing does."""
    waves = forcing.last.waves if forcing.listed else ()
    return max(((DYING + LATER * wave.power) / -float(wave.exponent.real)
                for wave in waves if wave.exponent.real < 0 and wave.coefficient), default=0.0)


def _moving(modes: "Sequence[Mode]", damped: "Sequence[DampedMode] | None", last: float,
            speeds: Sequence[float]) -> float:
    """That from `last` on, as far as the motion and what swings in the forcing tell."""
    frequencies = [mode.omega for mode in modes if mode.omega]
    decays = []
    if damped is not None:
        frequencies = [_seen(mode) for mode in damped if mode.omega_d]
        decays = [-mode.eigenvalue.real for mode in damped if mode.eigenvalue.real < 0]
    growths = [mode.growth_rate for mode in (damped or modes) if mode.growth_rate]
    longest = max((tau / float(omega) for omega in (*frequencies, *speeds)), default=0.0)
    if growths:
        return min(DYING / float(max(growths)), PERIODS * longest or float("inf"))
    if decays:
        dying = DYING / float(min(decays))
        return min(max(dying, 2 * longest), MOST * longest) if longest else dying
    if longest:
        return max(PERIODS * longest, min(2 * _beat(frequencies), MOST * longest))
    return last or 1.0


def _seen(mode: "DampedMode") -> float:
    """The damped frequency of a mode; of one that dies out long before it has swung once, of so long as it is seen."""
    decay = -float(mode.eigenvalue.real)
    return max(float(mode.omega_d), tau * decay / (GONE * DYING))


def _beat(frequencies: Sequence[float]) -> float:
    """The longest beat period of neighbouring frequencies, 0 of one alone."""
    ordered = sorted(map(float, frequencies))
    gaps = [b - a for a, b in pairwise(ordered) if b > a]
    return tau / min(gaps) if gaps else 0.0
