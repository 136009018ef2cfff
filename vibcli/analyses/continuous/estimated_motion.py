"""A motion by modes that dampers couple: what this coupling leaves of it is estimated by half as many modes."""

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.modal_motion import ModalMotion

if TYPE_CHECKING:
    from collections.abc import Callable

    from vibcli.analyses.continuous.coupled_modes import TiedModes
    from vibcli.analyses.continuous.modal_reads import Read
    from vibcli.analyses.continuous.modal_states import FreeStretch
    from vibcli.analyses.excitation.forcing import Forcing
    from vibcli.analyses.excitation.linear_output import LinearOutput

INSTANTS = np.linspace(-0.5, 0.5, 9)    # in periods of the slowest mode, about the one that is asked for


class EstimatedMotion(ModalMotion):
    """Of TiedModes; half(): the same by half as many modes. bound: an estimate where no true one is known."""

    def __init__(self, modes: "TiedModes", *parts: Any, half: "Callable[[], ModalMotion]") -> None:
        super().__init__(modes, *parts)
        self.tied, self._half, self._built_of = modes, half, parts

    @cached_property
    def fewer(self) -> ModalMotion:
        """That by half as many."""
        return self._half()

    def under(self, forcing: "Forcing") -> "EstimatedMotion":
        return EstimatedMotion(self.tied, *self._built_of[:3], forcing, half=lambda: self.fewer.under(forcing))

    def bound(self, output: "LinearOutput", t: float, order: int = 0, modes: int | None = None) -> float:
        """What modes beyond those counted add, and, of what has no true bound, how far half as many are off about that
        instant."""
        if not self._estimates(output, t, order):
            return super().bound(output, t, order, modes)
        times = np.maximum(t + 2 * np.pi / (self.slowest or 1.0) * INSTANTS, t / 2)
        apart = self.values(output, times, order) - self.fewer.values(output, times, order)
        return super().bound(output, t, order, modes) + float(np.abs(apart).max())

    def _amplitudes(self, read: "Read", stretch: "FreeStretch") -> np.ndarray:
        return self.tied.amplitudes(read.output, read.order, stretch.free)
