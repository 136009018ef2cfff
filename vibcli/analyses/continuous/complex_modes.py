"""Modes that dampers couple, as a motion in time needs them: D(s)⁻¹ = Σ φ φᵀ/(s − λ), φᵀ D′(λ) φ = 1, so that

    u = Σ φ c,    ċ = λ c + φᵀ f,    c(0) = φᵀ [M (λ u₀ + v₀) + C u₀]

of distributed mass and drag too; conjugates add up to twice a real part. What nothing holds has λ = 0: simply where it
is damped, doubly and apart from all else where it is not.
"""

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.continuous.coincident_roots import nearest
from vibcli.analyses.continuous.doubt import Doubt
from vibcli.analyses.continuous.left_out_motions import LeftOutMotions
from vibcli.analyses.continuous.modal_states import States
from vibcli.analyses.continuous.mode_basis import ModeBasis, in_floats, on_part
from vibcli.numerics.pieces.stiffness import stiffness_and_slope

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from vibcli.analyses.continuous.damped_series import DampedSeries
    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix
    from vibcli.analyses.continuous.left_out_energy import LeftOutEnergy
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.mechanics.factored_system import PlacedPiece

EPSILON = 2.0**-52
NOISE = 2.0**-51    # of the largest amplitude at the start: what is only rounding
UNFELT = 1e-12      # of the dampers that a rigid motion could move: it moves none
STEADY = 0.98       # share of the decay of modes of half the frequency: it does not fade as these grow
SAFE = 0.9


class DampedBasis(ModeBasis):
    """Of what nothing holds and of a DampedSeries: rates λ (N,), errors: their relative bounds, free: how many of the
    first are neither held nor damped, at_rest: how often λ = 0; shapes (n, N), parts[p] as of a ModeBasis; of_points:
    no larger |λ| is that of a point about several."""

    def __init__(self, series: "DampedSeries", matrix: "DynamicMatrix", rigid: np.ndarray,
                 placed: "Sequence[PlacedPiece]") -> None:
        self.placed, still, self._sizes = in_floats(placed), _sorted(matrix, rigid), {}
        self.free, resting = still
        self.at_rest = self.free + len(resting)
        zeros, self.radius, self.of_points = np.zeros(len(resting)), series.radius, series.of_points
        self.rates, self.errors = np.append(zeros, series.rates), np.append(zeros, series.errors)
        self.shapes = np.zeros((matrix.n, len(self.rates)), complex)
        self.shapes[:, :len(resting)] = resting.T
        self.parts = [[] for _ in placed]
        for p, one in enumerate(self.placed if len(resting) else ()):
            kappa = np.full(len(resting), complex(one.piece.foundation))
            self.parts[p].append(on_part(self.placed, one, np.arange(len(resting)), kappa, resting + 0j)[1])
        for group in series.groups:
            numbers = group.numbers + len(resting)
            self.shapes[:, numbers] = group.shapes[:, :matrix.n].T
            for place, one in enumerate(in_floats(group.pieces)):
                home, part = on_part(self.placed, one, numbers, one.piece.reaction(self.rates[numbers]), group.shapes,
                                     group.bends.get(place))
                self.parts[home].append(part)


def _sorted(matrix: "DynamicMatrix", rigid: np.ndarray) -> tuple[int, np.ndarray]:
    """(how many rigid motions nothing damps, (R, n) rigid motions): these first, unit in ∂D/∂s², the others in C."""
    if not len(rigid):
        return 0, rigid
    C, size = rigid @ matrix.polynomial[1] @ rigid.T, abs(rigid) @ abs(matrix.polynomial[1]) @ abs(rigid.T)
    for one in in_floats(matrix.pieces):
        ends = np.array([[sum(x * shape[i] for i, x in row.items()) for row in one.rows] for shape in rigid])
        own = one.piece.drag * ends @ stiffness_and_slope(one.piece, np.float64(one.piece.foundation))[1] @ ends.T
        C, size = C + own, size + abs(own)
    rates, turn = np.linalg.eigh(C)
    felt = rates > UNFELT * abs(size).max()
    return int((~felt).sum()), np.where(felt, 1 / np.sqrt(np.where(felt, rates, 1.0)), 1.0)[:, None] * (turn.T @ rigid)


class ComplexModes:
    """Of a DampedBasis, as RealModes: inputs φᵀb (modes, channels); start: φᵀ M u₀, φᵀ M v₀, φᵀ C u₀ and φᵀ C v₀;
    left(of these): the LeftOutEnergy of those left out. gaps: how far each λ is from the next; shown_by_start: ⟨zₙ, z⟩
    and ⟨zₙ, A z⟩ of the start."""

    UNBOUNDED = "as a load along a member is let go"       # where nothing is known of those left out

    def __init__(self, basis: DampedBasis, inputs: np.ndarray,
                 start: tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray],
                 left: "Callable[[ComplexModes], LeftOutEnergy] | None" = None) -> None:
        self.basis, self.count, free = basis, basis.shapes.shape[1], basis.free
        place, speed, drag, dragged = start
        rates = basis.rates[free:]
        share = np.where(rates.imag > 0, 2.0, 1.0)
        begin = share * (rates * place[free:] + speed[free:] + drag[free:])
        pace = np.sqrt(np.abs(rates))
        most = np.where(pace, pace, 1.0) * (abs(begin) / np.where(pace, pace, 1.0)).max(initial=0.0)
        begin = np.where(abs(begin) > NOISE * most, begin, 0.0)
        self.states = States(rates, share[:, None] * inputs[free:], np.arange(free, self.count), begin)
        self.rigid_inputs = inputs[:free].real
        self.rigid_start = np.array([place[:free].real, speed[:free].real])
        self.left_out, self.fading = (basis.radius, np.inf), _fading(rates)
        self.lost = NOISE * most
        errors = basis.errors[free:]
        self.gaps = nearest(rates)
        self.doubt = Doubt(errors + EPSILON * (rates != 0), 8 * EPSILON + 4 * errors * abs(rates) / self.gaps)
        first = rates * (speed[free:] - rates * place[free:] - drag[free:])
        self.shown_by_start = first, -rates * (first + 2 * dragged[free:])
        self.disturbed = left and partial(LeftOutMotions, left(self))

    def rows(self, output: "LinearOutput") -> tuple[np.ndarray, np.ndarray]:
        """What an output reads of each state, its rate and acceleration, (3, states), and of what nothing holds."""
        rows, free = self.basis.rows(output), self.basis.free
        return rows[:, free:], rows[:, :free].real

    def lost_rows(self, output: "LinearOutput") -> np.ndarray:
        """What rounding leaves of the rows over states."""
        return self.basis.lost(output)[:, self.basis.free:]


def _fading(rates: np.ndarray) -> float:
    """A rate that those left out decay with at least: that of the last, where it does not fade as they grow faster."""
    last, before = (float(rates.real[len(rates) // k:len(rates) // (k // 2)].max(initial=-np.inf)) for k in (2, 4))
    return SAFE * last if -np.inf < last < 0 and -last >= -STEADY * before else 0.0
