"""What outputs of a scene with members answer to its loads where `damping:` damps its modes."""

from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.damped_sum import DampedSum
from vibcli.analyses.excitation.linear_output import LinearOutput

if TYPE_CHECKING:
    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.analyses.continuous.member_damping import MemberDamping
    from vibcli.analyses.modal.mode_sequence import Modes

POWERS = 3      # of s in an output: displacements, velocities, accelerations


class DampedTransfer:
    """still: the ExactTransfer without damping, of loads alone; modes: those without damping."""

    def __init__(self, still: "ExactTransfer", modes: "Modes", damping: "MemberDamping") -> None:
        self.still, self.pieces, self._modes, self._damping = still, still.pieces, modes, damping
        self._sums: dict[Any, Any] = {}

    def at(self, output: "LinearOutput", s: np.ndarray) -> np.ndarray:
        """(channels, number of s): the output, its constant and channels left out, for a unit e^{st} on each."""
        found = np.zeros((self.still.channels, len(s)), complex)
        for power in range(POWERS):
            part = of_power(output, power)
            if any(part[1:]):
                found += s**power * self._sum_of(part).at(s)
        return found

    def _sum_of(self, part: LinearOutput) -> DampedSum:
        key = tuple(sorted(part.q.items())), tuple(sorted(part.places.items()))
        if key not in self._sums:
            self._sums[key] = DampedSum(self._damping, self._modes, lambda sigma: self.still.at(part, sigma))
        return cast("DampedSum", self._sums[key])


def of_power(output: LinearOutput, power: int) -> LinearOutput:
    """The displacements of which an output reads this rate."""
    places = {place._replace(rates=0): x for place, x in output.places.items() if place.rates == power}
    return LinearOutput(0.0, q=(output.q, output.v, output.a)[power], places=places)
