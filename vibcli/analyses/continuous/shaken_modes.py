"""Modes that `damping:` damps while supports are driven by displacements u:

    η̈ + c η̇ + ω² η = g u + r u̇ + m ü

g, m are what they feel of u without damping; r = β g + α m where all velocities are resisted, else r = (c/ω²) g: those
against what u gives at rest. With ċ = λ c + w (g u + r u̇ + m ü) the states c − w (r u + m (u̇ + λ u)) feel u alone,

    w (g + λ r + λ² m) u.
"""

from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.damped_sum import DampedSum, fractions
from vibcli.analyses.continuous.damped_transfer import DampedTransfer, of_power
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.analyses.continuous.member_damping import MemberDamping
    from vibcli.analyses.continuous.modal_states import States
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.analyses.modal.mode_sequence import Modes

POWERS = 3      # of s in an output


class Shaking(NamedTuple):
    """felt: g, r, m (3, modes, supports); start: u and u̇ at t = 0, (2, supports)."""

    felt: np.ndarray
    start: np.ndarray

    def shaken(self, states: "States", weights: np.ndarray) -> "States":
        """States that feel u on further channels; weights: w of each."""
        g, r, m = (weights[:, None] * part[states.modes] for part in self.felt)
        rates, (u, speed) = states.rates[:, None], self.start
        inputs = np.concatenate([states.inputs, g + rates * (r + rates * m)], axis=1)
        return states._replace(inputs=inputs, begin=states.begin - (r + rates * m) @ u - m @ speed)


def rate_share(damping: "MemberDamping", squares: np.ndarray, rates: np.ndarray, g: np.ndarray,
               m: np.ndarray) -> np.ndarray:
    """r, (modes, supports), of modes with ω² = squares and c = rates."""
    if damping.whole:
        alpha, beta = (*map(float, damping.series), 0.0)[:2]
        return beta * g + alpha * m
    return cast("np.ndarray", np.where(squares > 0, rates / np.where(squares > 0, squares, 1.0), 0.0)[:, None] * g)


class Support(NamedTuple):
    """What a displacement puts on coordinates and on driven ends: (K_u, M_u) as forces, (2, n), and (channels,)."""

    forces: np.ndarray
    ends: np.ndarray


class ShakenTransfer:
    """What outputs answer to loads and to the displacements of supports; loads, moved: the ExactTransfers without and
    with driven ends, neither damped; their channels are those of loads, and behind them supports."""

    def __init__(self, loads: "ExactTransfer", moved: "ExactTransfer", supports: list[Support], modes: "Modes",
                 damping: "MemberDamping") -> None:
        self.loads, self.moved, self.supports = DampedTransfer(loads, modes, damping), moved, supports
        self.pieces, self._modes, self._damping = moved.pieces, modes, damping
        self._sums: dict[Any, tuple[np.ndarray, DampedSum]] = {}

    def at(self, output: "LinearOutput", s: np.ndarray) -> np.ndarray:
        """(channels, number of s): the output, its constant and channels left out, for a unit e^{st} on each."""
        found = np.zeros((len(self.supports), len(s)), complex)
        for power in range(POWERS):
            part = of_power(output, power)
            if any(part[1:]):
                found += s**power * self._shaken(part, s)
        return np.concatenate([self.loads.at(output, s), found])

    def _shaken(self, part: "LinearOutput", s: np.ndarray) -> np.ndarray:
        if self._damping.whole:
            return self._still(part, np.sqrt(-fractions([float(a) for a in self._damping.series], s)[0][0]))
        rest, total = self._sum_of(part)
        return cast("np.ndarray", rest - s * s * total.at(s))

    def _sum_of(self, part: "LinearOutput") -> tuple[np.ndarray, DampedSum]:
        key = tuple(sorted(part.q.items())), tuple(sorted(part.places.items()))
        if key not in self._sums:
            rest = self._still(part, np.zeros(1, complex))
            self._sums[key] = rest, DampedSum(self._damping, self._modes,
                                              lambda sigma: (rest - self._still(part, sigma)) / sigma**2)
        return self._sums[key]

    def _still(self, part: "LinearOutput", sigma: np.ndarray) -> np.ndarray:
        """(supports, number of σ): what displacements move without damping."""
        felt, n = self.moved.at(part, sigma), self.moved.n
        found = []
        for one in self.supports:
            forces = one.forces[0][:, None] + one.forces[1][:, None] * sigma**2
            found.append((forces * felt[:n]).sum(axis=0) + one.ends @ felt[n:n + len(one.ends)])
        return np.array(found)
