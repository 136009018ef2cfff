"""Modes that move each by itself, as a motion in time needs them: η̈ + c η̇ + ω² η = Φᵀ f."""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.doubt import doubt_of
from vibcli.analyses.continuous.modal_states import states_of

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from vibcli.analyses.continuous.disturbances import Disturbances
    from vibcli.analyses.continuous.mode_basis import ModeBasis
    from vibcli.analyses.continuous.shaken_modes import Shaking
    from vibcli.analyses.excitation.forcing import Segment
    from vibcli.analyses.excitation.linear_output import LinearOutput


class RealModes:
    """Of a ModeBasis: inputs (modes, channels), η and η̇ at t = 0, each with what rounding loses of it, damping: c of
    each mode, creeping: do modes creep the more slowly the higher they are? shaking: what displacements of supports do.

    states: those that a motion is added from; rigid_inputs, rigid_start: b and (η, η̇) of what nothing holds; left_out:
    what no |λ| of a mode that is left out is below where it oscillates, and none where it creeps; fading: none of these
    dies out more slowly; disturbed(segments): the Disturbances of those under a load, None of what has no true bound;
    lost: rounding of the start, in each state; doubt: the Doubt of the states.
    """

    UNBOUNDED = "as supports are driven beside `damping:` of members"       # where nothing is known of those left out

    def __init__(self, basis: "ModeBasis", inputs: np.ndarray, start: "Sequence[tuple[np.ndarray, np.ndarray]]",
                 damping: np.ndarray, creeping: bool = False,
                 disturbed: "Callable[[Sequence[Segment]], Disturbances] | None" = None,
                 shaking: "Shaking | None" = None) -> None:
        (eta, eta_lost), (rate, rate_lost) = start
        squares, self.basis, self.count, self.disturbed = basis.squares, basis, len(basis.squares), disturbed
        at, self.rigid = np.flatnonzero(squares + damping), np.flatnonzero((squares == 0) & (damping == 0))
        unit = np.ones((len(at), 1))
        states = states_of(squares[at], damping[at], np.append(inputs[at], unit, axis=1), eta[at], rate[at])
        states, weights = states._replace(modes=at[states.modes], inputs=states.inputs[:, :-1]), states.inputs[:, -1]
        self.states = states if shaking is None else shaking.shaken(states, weights)
        supports = self.states.inputs.shape[1] - inputs.shape[1]
        self.rigid_inputs = np.pad(inputs[self.rigid], ((0, 0), (0, supports)))
        self.rigid_start = np.array([eta[self.rigid], rate[self.rigid]])
        self.left_out = left_out(squares, damping, creeping)
        slow = float(np.max(states.rates.real[len(at) // 2:len(at)], initial=-np.inf))
        self.fading = min(max(slow, -self.left_out[1]), 0.0)
        pace = np.maximum(np.where(states.rates, np.abs(states.rates), damping[self.states.modes]), 1e-300)
        self.lost = 2 * (eta_lost[self.states.modes] + rate_lost[self.states.modes] / pace)
        self.doubt = doubt_of(basis, self.states)

    def rows(self, output: "LinearOutput") -> tuple[np.ndarray, np.ndarray]:
        """What an output reads of each state, its rate and acceleration, (3, states), and of what nothing holds."""
        rows = self.basis.rows(output)
        return rows[:, self.states.modes], rows[:, self.rigid]

    def lost_rows(self, output: "LinearOutput") -> np.ndarray:
        """What rounding leaves of the rows over states."""
        return self.basis.lost(output)[:, self.states.modes]


def left_out(squares: np.ndarray, damping: np.ndarray, creeping: bool) -> tuple[float, float]:
    """What no |λ| of a mode that is left out is below where it oscillates, and where it creeps."""
    highest = float(np.abs(squares).max(initial=0.0))
    last = float(damping[-1]) if len(damping) else 0.0
    return highest**0.5, 0.0 if creeping else highest / last if last else np.inf

