"""Modes without damping that dampers C = U Λ Uᵀ couple beside `damping:`, as a motion in time needs them:

    η̈ + (diag c + B Λ Bᵀ) η̇ + ω² η = b f,      B = Φᵀ U

Behind the first modes stands for each damper what all others follow it with at rest, ψ = R₀ y (residual attachment
modes: Craig & Kurdila, Fundamentals of Structural Dynamics, 2006): R(s) = G − Σ φ φᵀ/(ω² + s²) = R₀ − R₂ s² + …,
R₀ y = ω² R₂ y, yᵀ R₂ y = 1, so that dampers are answered to s⁴/ω⁴ of the first ω that is left out.
"""

from functools import partial
from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.continuous.damped_transfer import of_power
from vibcli.analyses.continuous.doubt import Doubt
from vibcli.analyses.continuous.modal_states import States
from vibcli.analyses.continuous.polished_eigenvectors import eigenvectors
from vibcli.analyses.continuous.real_modes import left_out
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from vibcli.analyses.continuous.coupled_left_out import CoupledLeftOut
    from vibcli.analyses.continuous.coupled_transfer import Dampers
    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.analyses.continuous.mode_basis import ModeBasis
    from vibcli.analyses.excitation.forcing import Segment
    from vibcli.analyses.excitation.linear_output import LinearOutput

EPSILON = 2.0**-52
POINTS, INSIDE = 24, 4.0        # of the circle about s = 0, and how far inside the modes that are left out
NOTHING = 1e-9      # of a flexibility: what rounding leaves of it
UNFELT = 1e-12      # of the largest rate of a rigid motion: it is not damped
POWERS = 3          # of s in an output


class FollowingShapes:
    """The ψ of a ModeBasis: squares (p,), felt (p, r) of the dampers, inputs (p, channels) of the loads."""

    def __init__(self, basis: "ModeBasis", inputs: np.ndarray, still: "ExactTransfer", dampers: "Dampers") -> None:
        self.basis, self.still, self.dampers = basis, still, dampers
        highest = float(np.sqrt(np.abs(basis.squares).max(initial=0.0)))
        self.s = highest / INSIDE * np.exp(2j * np.pi * (np.arange(POINTS) + 0.5) / POINTS)
        self._shares = (basis.shapes.T @ dampers.rows)[:, :, None] / (basis.squares[:, None] + self.s**2)[:, None]
        whole = np.array([still.at(one, self.s) for one in dampers.outputs] or np.zeros((0, inputs.shape[1], POINTS)))
        left = whole - np.einsum("nks,nc->kcs", self._shares, inputs)
        to_dampers = np.einsum("kis,il->kls", left[:, :len(dampers.rows)], dampers.rows)
        R0, R2 = to_dampers.mean(axis=-1).real, -(to_dampers / self.s**2).mean(axis=-1).real
        self.squares, self.y = _followed((R0 + R0.T) / 2, (R2 + R2.T) / 2, abs(whole).max(initial=0.0), highest)
        self.felt, self.inputs = self.y.T @ R0, self.y.T @ left.mean(axis=-1).real

    def rows(self, output: "LinearOutput") -> np.ndarray:
        """(3, p): what an output reads of each η, η̇ and η̈."""
        found, known = np.zeros((POWERS, len(self.squares))), self.basis.rows(output)
        for power in range(POWERS) if len(self.squares) else ():
            part = of_power(output, power)
            if any(part[1:]):
                whole = np.einsum("is,ik->ks", self.still.at(part, self.s)[:len(self.dampers.rows)], self.dampers.rows)
                left = whole - np.einsum("n,nks->ks", known[power], self._shares)
                found[power] = left.mean(axis=-1).real @ self.y
        return found


def _followed(R0: np.ndarray, R2: np.ndarray, whole: float, highest: float) -> tuple[np.ndarray, np.ndarray]:
    """(ω², y) of the pencil R₀ − ω² R₂, without what is only rounding."""
    flexible, turn = np.linalg.eigh(R0)
    turn = turn[:, flexible > NOTHING * whole] / np.sqrt(flexible[flexible > NOTHING * whole])
    inverse, y = np.linalg.eigh(turn.T @ R2 @ turn)
    sound = (inverse > 0) & (inverse < highest**-2)
    return 1 / inverse[sound], turn @ y[:, sound] / np.sqrt(inverse[sound])


class Motions(NamedTuple):
    """λ with Im λ ≥ 0, shares (modes, states) of η, inputs and begin of the states c."""

    rates: np.ndarray
    shares: np.ndarray
    inputs: np.ndarray
    begin: np.ndarray


class TiedModes:
    """Of a ModeBasis, as RealModes: inputs (modes, channels), start: η and η̇ at t = 0, damping: c of a mode with ω²;
    creeping: do modes creep the more slowly the higher they are? left(of these, segments): the CoupledLeftOut, None
    where nothing is known. drives: w of the η and those of following shapes, (states, modes);
    follows: is a state most of all one of these?"""

    UNBOUNDED = "as dampers couple the modes that `damping:` damps"

    def __init__(self, basis: "ModeBasis", inputs: np.ndarray, start: tuple[np.ndarray, np.ndarray],
                 damping: "tuple[np.ndarray, Callable[[np.ndarray], np.ndarray]]", following: FollowingShapes,
                 creeping: bool,
                 left: "Callable[[TiedModes, Sequence[Segment]], CoupledLeftOut] | None" = None) -> None:
        self.basis, self.following, self.count = basis, following, len(basis.squares)
        given, of_squares = np.asarray(damping[0], float), damping[1]
        squares = np.append(basis.squares, following.squares)
        c = np.append(given, of_squares(following.squares))
        felt = np.concatenate([basis.shapes.T @ following.dampers.rows, following.felt])
        none = np.zeros(len(following.squares))
        D = np.diag(c) + (felt * following.dampers.rates) @ felt.T
        self.turn, free = _rigid_apart(D, squares == 0)
        b, begin = self.turn.T @ np.concatenate([inputs, following.inputs]), [
            self.turn.T @ np.append(part, none) for part in start]
        still = np.flatnonzero(free)
        self.rigid_inputs, self.rigid_start = b[still], np.array([part[still] for part in begin])
        self._still = self.turn[:, still]
        found, modes, off = _states(squares, self.turn.T @ D @ self.turn, ~free, np.eye(len(b)), begin)
        self.disturbed, self.given, self.drives = left and partial(left, self), given, found.inputs @ self.turn.T
        self.left_out = left_out(basis.squares, given, creeping)
        self._shares, self.follows = self.turn @ found.shares, modes >= self.count
        self.states = States(found.rates, found.inputs @ b, np.minimum(modes, self.count - 1), found.begin)
        late = found.rates.real[(modes < self.count) & (modes >= self.count // 2)]
        self.fading = min(max(float(late.max(initial=-np.inf)), -self.left_out[1]), 0.0)
        self.lost = 8 * EPSILON * np.abs(self.states.begin)
        error = basis.errors.max(initial=0.0)
        self.doubt = Doubt(off[0] + error + 8 * EPSILON, off[1] + 64 * EPSILON)

    def rows(self, output: "LinearOutput") -> tuple[np.ndarray, np.ndarray]:
        """What an output reads of each state, its rate and acceleration, (3, states), and of what nothing holds."""
        rows = np.concatenate([self.basis.rows(output), self.following.rows(output)], axis=1)
        return rows @ self._shares, rows @ self._still

    def energies(self, free: np.ndarray) -> np.ndarray:
        """‖·‖ that the first modes have at most in each of the states `free`, (states,)."""
        parts = np.abs(self._shares[:self.count]) ** 2
        twice = np.abs(self.basis.squares) @ parts + np.abs(self.states.rates) ** 2 * parts.sum(axis=0)
        return cast("np.ndarray", np.abs(free) * np.sqrt(twice))

    def lost_rows(self, output: "LinearOutput") -> np.ndarray:
        """What rounding leaves of the rows over states."""
        return cast("np.ndarray", self.basis.lost(output) @ abs(self._shares[:self.count]))

    def amplitudes(self, output: "LinearOutput", order: int, free: np.ndarray) -> np.ndarray:
        """What each mode brings to the order-th rate of an output that starts with states `free`, (N,)."""
        shares, pace = self._shares[:self.count], np.sqrt(np.abs(self.basis.squares))
        eta, rate = np.real(shares @ free), np.real(shares @ (self.states.rates * free))
        size = np.where(pace, np.hypot(eta, rate / np.where(pace, pace, 1.0)), 0.0)
        factors = 1.0, pace, pace * (pace + self.given), pace**2 * (pace + self.given)
        rows = abs(self.basis.rows(output))
        return cast("np.ndarray", sum(row * size * factors[min(power + order, 3)] for power, row in enumerate(rows)))


def _rigid_apart(D: np.ndarray, rigid: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(turn, free): η = turn η′, D diagonal over rigid motions; which η′ are neither held nor damped."""
    at, turn, free = np.flatnonzero(rigid), np.eye(len(D)), np.zeros(len(D), bool)
    if len(at):
        rates, vectors = np.linalg.eigh(D[np.ix_(at, at)])
        turn[np.ix_(at, at)] = vectors
        free[at] = abs(rates) <= UNFELT * abs(D).max(initial=0.0)
    return turn, free


def _states(squares: np.ndarray, D: np.ndarray, chosen: np.ndarray, b: np.ndarray,
            begin: list[np.ndarray]) -> tuple[Motions, np.ndarray, np.ndarray]:
    """(Motions of the chosen η, the number of the mode that is most of each state, phase and size of their Doubt)."""
    held = np.flatnonzero(chosen & (squares != 0))[::-1]
    loose = np.flatnonzero(chosen & (squares == 0))
    pace, order = np.sqrt(np.abs(squares[held])), np.concatenate([held, loose])
    n, m = len(held), len(order)
    A = np.zeros((n + m, n + m))
    A[range(n), range(n, 2 * n)] = pace
    A[range(n, 2 * n), range(n)] = -squares[held] / pace
    A[n:, n:] = -D[np.ix_(order, order)]
    place = np.argsort(np.concatenate([np.arange(n) * 2, np.arange(n) * 2 + 1, 2 * n + np.arange(m - n)]))
    rates, vectors, inverse, phase, size = eigenvectors(A[np.ix_(place, place)])
    back, up = np.argsort(place), rates.imag >= 0
    twice = np.where(rates.imag > 0, 2.0, 1.0)[:, None] * inverse[:, back]
    rates, vectors, twice = rates[up], vectors[back][:, up], twice[up]
    most = order[np.argmax(abs(vectors[n:])**2 + np.pad(abs(vectors[:n])**2, ((0, m - n), (0, 0))), axis=0)]
    eta, rate = begin
    start = twice @ np.concatenate([pace * eta[held], rate[order]])
    shares = np.zeros((len(squares), len(rates)), complex)
    shares[held] = vectors[:n] / pace[:, None]
    shares[loose] = vectors[2 * n:] / rates
    found = Motions(rates, shares, twice[:, n:] @ b[order], start)
    off = np.pad(np.array([phase, size])[:, up], ((0, 0), (0, len(loose))))
    return _resting(found, loose, eta), np.concatenate([most, loose]), off


def _resting(found: Motions, loose: np.ndarray, eta: np.ndarray) -> Motions:
    """With λ = 0 of each η that is damped and not held: η less what the other states show of it."""
    shown = found.shares[loose]
    own = np.zeros((len(found.shares), len(loose)))
    own[loose, range(len(loose))] = 1.0
    return Motions(np.append(found.rates, np.zeros(len(loose))), np.concatenate([found.shares, own], axis=1),
                   np.concatenate([found.inputs, -np.real(shown @ found.inputs)]),
                   np.append(found.begin, eta[loose] - np.real(shown @ found.begin)))
