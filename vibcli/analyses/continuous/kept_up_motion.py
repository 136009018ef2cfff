"""The steady state of a scene with members as harmonics that are known outright: no coordinates, only channels."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.excitation.forcing import Forcing, Segment, Wave
from vibcli.analyses.transient.linear_response import LinearMotion, SteadyMotion
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.base.work import Work


class Harmonic(NamedTuple):
    """Re(X e^{iΩt}) of a channel, |δX| ≤ error; Ω = 0 of a constant, whose X is real."""

    channel: int
    Omega: float
    X: complex
    error: float


class KeptUpMotion(SteadyMotion):
    """Harmonics on so many channels, which outputs read."""

    def __init__(self, channels: int, harmonics: Sequence[Harmonic], work: "Work"):
        waves = [Wave(one.channel, one.X, 0, 1j * one.Omega) for one in harmonics if one.X]
        forcing, none = Forcing(channels, [Segment(0.0, tuple(waves))]), np.zeros((0, 0))
        self.harmonics, self.lasting, self.period = list(harmonics), False, None
        self.waves, self.powers = [], []
        for Omega in sorted({one.Omega for one in harmonics}):
            row = np.zeros(channels, complex)
            for one in harmonics:
                row[one.channel] += one.X if one.Omega == Omega else 0.0
            if Omega:
                self.waves.append((1j * Omega, np.zeros(0), row))
            else:
                self.powers = [(np.zeros(0), row.real)]
        LinearMotion.__init__(self, (none, none, none, None), [], forcing, np.zeros(0), np.zeros(0), work)

    @property
    def steady(self) -> "KeptUpMotion":
        return self

    def off(self, wave: tuple[complex, np.ndarray, np.ndarray]) -> np.ndarray:
        found = np.zeros(self.forcing.channels)
        for one in self.harmonics:
            found[one.channel] += one.error if one.Omega == wave[0].imag else 0.0
        return found

    def errors(self, output: "LinearOutput", times: np.ndarray, order: int = 0) -> np.ndarray:
        more: Any = sum(abs(output.channels.get(one.channel, 0.0)) * one.error * one.Omega**order
                        for one in self.harmonics)
        return super().errors(output, times, order) + more
