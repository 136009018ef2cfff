"""The steady state of a scene with members as harmonics that are known outright: no coordinates, only channels."""

from collections.abc import Sequence
from math import perm
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
from vibcli.analyses.transient.linear_response import LinearMotion, SteadyMotion
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.base.work import Work


class Harmonic(NamedTuple):
    """Re(X tᵏ e^{iΩt}) of a channel, |δX| ≤ error; Ω = 0 of a constant, whose X is real, and k = 0 but of a drift."""

    channel: int
    Omega: float
    X: complex
    error: float
    power: int = 0


class KeptUpMotion(SteadyMotion):
    """Harmonics on so many channels, which outputs read."""

    def __init__(self, channels: int, harmonics: Sequence[Harmonic], work: "Work") -> None:
        waves = [Wave(one.channel, one.X, one.power, 1j * one.Omega) for one in harmonics if one.X]
        forcing, none = Forcing(channels, [Segment(0.0, tuple(waves))]), np.zeros((0, 0))
        self.harmonics, self.lasting, self.period = list(harmonics), False, None
        self.waves = []
        for Omega in sorted({one.Omega for one in harmonics if one.Omega}):
            row = np.zeros(channels, complex)
            for one in harmonics:
                row[one.channel] += one.X if one.Omega == Omega else 0.0
            self.waves.append((1j * Omega, np.zeros(0), row))
        still = [one for one in harmonics if not one.Omega]
        rows = np.zeros((max((one.power + 1 for one in still), default=0), 2, channels))
        for one in still:
            rows[one.power, :, one.channel] += one.X.real, one.error
        self.powers, self.lost = [(np.zeros(0), row) for row in rows[:, 0]], rows[:, 1]
        LinearMotion.__init__(self, (none, none, none, None), [], forcing, np.zeros(0), np.zeros(0), work)

    @property
    def steady(self) -> "KeptUpMotion":
        return self

    def _sees_drift(self, output: "LinearOutput") -> bool:
        return True

    def off(self, wave: tuple[complex, np.ndarray, np.ndarray]) -> np.ndarray:
        found = np.zeros(self.forcing.channels)
        for one in self.harmonics:
            found[one.channel] += one.error if one.Omega == wave[0].imag else 0.0
        return found

    def errors(self, output: "LinearOutput", times: np.ndarray, order: int = 0) -> np.ndarray:
        more: Any = sum(abs(output.channels.get(one.channel, 0.0)) * one.error * (
            perm(one.power, order) * times**(one.power - order) if order <= one.power > 0 else one.Omega**order)
            for one in self.harmonics)
        return cast("np.ndarray", super().errors(output, times, order) + more)
