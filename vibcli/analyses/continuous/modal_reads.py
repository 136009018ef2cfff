"""What outputs read of a motion by modes."""

from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from vibcli.analyses.continuous.modal_motion import ModalMotion
    from vibcli.analyses.excitation.linear_output import LinearOutput


class Read:
    """What an output reads of a ModalMotion, in a rate: rows over states and over (η, η̇) of what nothing holds."""

    def __init__(self, motion: "ModalMotion", output: "LinearOutput", order: int):
        states, (rows, rigid) = motion.states, motion.rows_of(output)
        self.output, self.order, self._motion = output, order, motion
        self.states = sum((rows[m] * states.rates ** (m + order) for m in range(3)), 0 * states.rates)
        self.rigid = np.zeros((2, rigid.shape[1]))
        for m in range(3):
            if m + order < 2:
                self.rigid[m + order] += rigid[m]

    @cached_property
    def off(self) -> np.ndarray:
        """What rounding leaves of the rows over states."""
        pace = np.abs(self._motion.states.rates)
        return sum(part * pace ** (m + self.order) for m, part in enumerate(self._motion.off_of(self.output)))


def key_of(output: "LinearOutput") -> tuple:
    """What tells an output from others, but for its constant and channels."""
    return tuple(tuple(sorted(part.items())) for part in (output.q, output.v, output.a, output.places))
