"""The steady state of bars, shafts and strings that nothing damps, under loads that repeat themselves.

Where the period P of all free vibrations and that T of the loads are commensurate, M T = m P, the mean of the motion
over M instants T apart is what loads keep up: each free vibration adds Σ e^{iωkT} = 0, k = 0 … M − 1, but one that a
harmonic of the loads meets, e^{iωT} = 1. Of P ω/2π, which repeat themselves with the ways of the waves, the multiples
of M are looked for up to M times the twelfth.
"""

from fractions import Fraction
from math import tau
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.travelling_waves_station import NotByWaves
from vibcli.base.errors import PhysicsError
from vibcli.results.signal import Signal
from vibcli.results.steady_features import COMMENSURATE, common
from vibcli.results.wave_signals import FRONT, WaveSignal, _extreme, _leaps, _sampled, _zeros

if TYPE_CHECKING:
    from vibcli.analyses.modal.mode_sequence import Modes
    from vibcli.results.problem import Problem

MODES, FAR = 12, (100, 1000, 10_000)     # free vibrations that are looked at: the first, some far up
ALIKE = 1e-13       # relative: how far these may be from multiples of one frequency
MOST = 128          # periods over which a mean is taken at most
SAMPLES, ROUNDINGS = 257, 64.0      # of a period; times rounding: how far what repeats itself is from itself


class AveragedWaves(Signal):
    """The mean of a WaveSignal at `many` instants, the last and those a period apart before it."""

    KIND = "a mean over periods of a motion that is followed by travelling waves"
    sampled, leaps, extreme, zeros = _sampled, _leaps, _extreme, _zeros

    def __init__(self, signal: WaveSignal, period: float, many: int) -> None:
        self.signal, self.apart, self.work = signal, period * np.arange(many), signal.work

    def values(self, times: np.ndarray, order: int = 0) -> np.ndarray:
        found: np.ndarray = self.signal.values(self._at(times), order).mean(axis=-1)
        return found

    def values_before(self, times: np.ndarray) -> np.ndarray:
        found: np.ndarray = self.signal.values_before(self._at(times)).mean(axis=-1)
        return found

    def _at(self, times: np.ndarray) -> np.ndarray:
        found: np.ndarray = np.asarray(times, float)[..., None] - self.apart
        return found

    def breaks(self, end: float) -> np.ndarray:
        """The instants up to an end between which it is smooth, ascending."""
        moved = (self.signal.breaks(end) + self.apart[:, None]).ravel()
        moved = np.unique(moved[moved <= end])
        return moved[np.diff(moved, prepend=-np.inf) > FRONT * end]

    def fronts(self, end: float) -> np.ndarray:
        return self.breaks(end)

    def require_bounded(self, end: float) -> None:
        self.signal.require_bounded(end)

    def error(self, t: float) -> float:
        return self.signal.error(t)


def fits_into(index: int, damped: str, hint: str) -> PhysicsError:
    """The refusal of a steady state of which a free vibration is not told apart."""
    return PhysicsError(f"mode {index} is {damped}, and its period fits into that of this load: what it starts with "
                        "repeats itself, too", hint)


def common_speed(modes: "Modes") -> float | None:
    """The angular frequency of which those of all modes that are not rigid are multiples: of the first, and of some far
    up, which a mass or a spring, however small, leads astray; None where there is none that is seen."""
    first = [mode.omega for mode in modes.first(MODES) if not mode.rigid]
    speed = common([float(omega) for omega in first]) if first and all(first) else None
    if speed is None:
        return None
    ratios = [float(omega) / speed for omega in [*first, *(modes.alone(index).omega for index in FAR)]]
    return speed if all(abs(ratio - round(ratio)) <= ALIKE * ratio for ratio in ratios) else None


def averaged(problem: "Problem", signal: Any, period: float, since: float) -> tuple[AveragedWaves, float, float] | None:
    """(the steady state of a signal, from when on, how far it is from what repeats itself), loads repeating themselves
    from `since` on; None where free vibrations and loads have no common period that is seen."""
    modes = problem.modal.modes
    speed = common_speed(modes) if isinstance(signal, WaveSignal) else None
    if speed is None or modes.ground.resting:
        return None
    turns = speed * period / tau
    ratio = Fraction(turns).limit_denominator(MOST)
    if abs(ratio - turns) > COMMENSURATE * turns:
        return None
    many = ratio.denominator
    for number in range(many, many * round(float(modes.first(MODES)[-1].omega) / speed) + 1, many):
        for mode in modes.between(*(number * speed * (1 + off) for off in (-COMMENSURATE, COMMENSURATE))):
            raise fits_into(mode.index, "not damped", "damp it, or ask for harmonic[1](…), harmonic[2](…) and so on")
    start = period * (np.ceil(since / period) + many)
    times = start + period * (np.linspace(0.0, 1.0, SAMPLES)[:-1] + 1 / (3 * SAMPLES))
    found = AveragedWaves(signal, period, many)
    try:
        one, other = found.values(times), found.values(times + period)
    except NotByWaves:
        return None
    apart, known = float(np.abs(one - other).max()), found.error(float(times[-1]) + period)
    return (found, start, apart) if apart <= ROUNDINGS * known else None
