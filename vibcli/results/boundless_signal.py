"""Signals of motions by modes that leave out what has no bound, where waves that disperse tell them."""

from typing import TYPE_CHECKING

from vibcli.results.modal_signals import ModalSignal
from vibcli.results.signal import Signal
from vibcli.results.wave_signals import DispersedSignal, _before, _extreme, _leaps, _sampled, _zeros

if TYPE_CHECKING:
    from vibcli.analyses.continuous.dispersed_waves import DispersedMotion
    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.results.modal_response import ModalResponse
    from vibcli.symbolic.syntax import NameRef


class BoundlessSignal(ModalSignal):
    """A linear output of a DispersedMotion; modes of the ModalMotion tell whether it dies out."""

    sampled, before, leaps, extreme, zeros = _sampled, _before, _leaps, _extreme, _zeros
    values, values_before, error = DispersedSignal.values, DispersedSignal.values_before, DispersedSignal.error
    breaks, fronts, require_bounded = DispersedSignal.breaks, DispersedSignal.fronts, DispersedSignal.require_bounded
    error_of_time, error_of_zero = DispersedSignal.error_of_time, DispersedSignal.error_of_zero
    is_estimated = Signal.is_estimated
    error_of_mean, error_of_extreme = Signal.error_of_mean, Signal.error_of_extreme

    def __init__(self, waves: "DispersedMotion", output: "LinearOutput", motion: "ModalMotion",
                 asked: "tuple[ModalResponse, NameRef]") -> None:
        super().__init__(motion, output, asked)
        self.waves = waves

    @property
    def coarse(self) -> Signal:
        return self

    def first_zeros(self, end: float, count: int) -> list[float]:
        return self.zeros(0.0, end)

    def beside(self, shift: float, constant: float) -> Signal:
        return DispersedSignal(self.waves, self.shifted(shift, constant))
