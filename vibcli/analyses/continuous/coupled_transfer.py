"""What outputs answer to loads where dampers at coordinates act beside `damping:` of members: with G of the system
without these dampers, C = U Λ Uᵀ (Woodbury),

    H = G − s G_U Λ (1 + s G_UU Λ)⁻¹ G_Uᵀ
"""

from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.excitation.linear_output import LinearOutput

if TYPE_CHECKING:
    from vibcli.analyses.continuous.damped_transfer import DampedTransfer

NOTHING = 1e-14     # of the largest rate of the dampers


class Dampers:
    """C (n, n), symmetric, as U Λ Uᵀ: rows U (n, r), rates Λ (r,)."""

    def __init__(self, C: np.ndarray) -> None:
        rates, turn = np.linalg.eigh(C)
        felt = abs(rates) > NOTHING * abs(rates).max(initial=0.0)
        self.rows, self.rates = turn[:, felt], rates[felt]

    @property
    def outputs(self) -> list[LinearOutput]:
        """What each damper reads: its stretch."""
        return [LinearOutput(0.0, q={i: float(x) for i, x in enumerate(row) if x}) for row in self.rows.T]


class CoupledTransfer:
    """given: the DampedTransfer without dampers, whose first channels are those of coordinates."""

    def __init__(self, given: "DampedTransfer", dampers: Dampers) -> None:
        self.given, self.dampers, self.pieces = given, dampers, given.pieces

    def at(self, output: LinearOutput, s: np.ndarray) -> np.ndarray:
        """(channels, number of s): the output, its constant and channels left out, for a unit e^{st} on each."""
        s, rows, rates = np.asarray(s, complex), self.dampers.rows, self.dampers.rates
        own = self.given.at(output, s)
        if not len(rates):
            return own
        stretch = np.array([self.given.at(one, s) for one in self.dampers.outputs])
        n = len(rows)
        between = np.einsum("kis,il->skl", stretch[:, :n], rows) * s[:, None, None] * rates
        force = np.linalg.solve(np.eye(len(rates)) + between, np.moveaxis(stretch, -1, 0))
        return cast("np.ndarray", own - np.einsum("is,ik,k,skc->cs", own[:n], rows, rates, force) * s)
