"""How far modes that are not counted go where dampers couple them, a true upper bound.

With M, C, K symmetric and none of them negative, C of dampers and of one drag of all that has mass, what the first N
modes and what loads do exactly leave of a motion, z = (r, ṙ), vibrates freely: ⟨z, z⟩, ⟨z₁, z₂⟩ = x₁ᵀ K x₂ +
v₁ᵀ M v₂, twice its energy, never grows. It is orthogonal to the modes that are counted in [z₁, z₂] = x₁ᵀ K x₂ −
v₁ᵀ M v₂. With Π, which takes these off, and a = (K⁻¹ δ, 0)

    r(x, t) = [a, z] = [Π a, z],      |r(x, t)| ≤ ‖Π a‖ Σ ‖Π zₖ‖

over the jumps, bends and blows zₖ of the free part up to then; of the rate of what has mass a = (0, M⁻¹ δ).

A load f(τ) leaves minus the mean of (h, s h) f̂(s) over a circle about all s of loads, h = D(s)⁻¹ b (Cauchy), and a is
that of a step; Π takes off what each mode between this circle and those left out brings.
"""

from functools import cached_property
from math import factorial, inf
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.damped_energies import ROUNDED, DampedSwings, energies
from vibcli.analyses.continuous.divided_pieces import divided_at
from vibcli.analyses.continuous.modal_reads import key_of
from vibcli.analyses.continuous.spread_overlaps import UnitLoadsOfChannels
from vibcli.analyses.continuous.uncounted_modes import inverse_where_massive
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.stiffness import stiffness

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.complex_modes import ComplexModes
    from vibcli.analyses.continuous.exact_transfer import ExactTransfer

EPSILON = 2.0**-52
APART, BALANCE = 0.2, 8.0       # of the radius within which all modes are counted: how far a circle is within at most,
                                # and times the inverse of how many these are its square
PLACES = 40.0       # places on a circle, over that share: what is left out is told to e⁻⁴⁰
FAST = 0.5          # of that radius: exponents of loads well within
INDEFINITE = 1e-12  # of dampers of one size: what is none
MIXED = 100.0       # times (damping / distance of neighbours)²: how far shapes of modes are from real ones
MOST = 4_096        # modes that a start in fields is divided in, as all of them stand beside one another
INSIDE = 1e-12      # of a length


class Slots(NamedTuple):
    """Unit loads, and unit displacements of driven ends: inputs (modes, slots), how far each mode is felt by them as
    they begin; of modes what they show where loads act, `reads`, and what they draw at driven ends; strokes, what each
    shows at each and draws at each, on both circles, [(places, slots, dampers)] and [(places, slots, slots)]; massive:
    bᵀ M⁻¹ b of those that act on mass, (slots, slots)."""

    inputs: np.ndarray
    reads: np.ndarray
    draws: np.ndarray
    strokes: list[np.ndarray]
    shown: list[np.ndarray]
    drawn: list[np.ndarray]
    massive: np.ndarray


class Column(NamedTuple):
    """The answer to a unit load on a slot: ∂ᵏ/∂sᵏ of (h, s h) at s, its `imaginary` part or the real one; of a power −1
    the answer to a blow."""

    slot: int
    exponent: complex
    power: int
    imaginary: bool = False

    def weights(self, places: np.ndarray) -> np.ndarray:
        """Those of (h, s h) at places on the upper half of a circle, and their conjugates on the lower one."""
        if self.power < 0:
            return -places / (2 * len(places))
        upper, lower = (factorial(self.power) * s / (s - self.exponent) ** (self.power + 1) / (2 * len(places))
                        for s in (places, places.conj()))
        return (upper - lower.conj()) / 2j if self.imaginary else (upper + lower.conj()) / 2


def _even_drag(pieces):
    """(c/μ of pieces, is it that of all, and all that damps them?)."""
    drags = [one.piece.drag / one.piece.inertia if one.piece.inertia else one.piece.drag and inf for one in pieces]
    least, most = min(drags, default=0.0), max(drags, default=0.0)
    even = most < inf and most - least <= 4 * EPSILON * most and not any(one.retardation for one in pieces)
    return float(most if even else 0.0), even


class LeftOutEnergy:
    """Of ComplexModes; begun: q and v at t = 0; of a start in fields besides `twice` its energy, None of others."""

    def __init__(self, modes: "ComplexModes", transfer: "ExactTransfer", begun: "tuple[np.ndarray, np.ndarray]",
                 twice: float | None = None):
        self.modes, self.states, self.basis, self.transfer = modes, modes.states, modes.basis, transfer
        self.n, (_, C, M), rates = transfer.n, transfer.matrix.polynomial, modes.states.rates
        self.held, self.struck = (transfer.at_rest(begun[0]), M @ begun[1]) if twice is None else np.zeros(
            (2, self.n))
        self.drag, even = _even_drag(transfer.pieces)
        C = C - self.drag * M
        size = np.sqrt(np.maximum(np.diagonal(C), 0.0))
        values, vectors = np.linalg.eigh(C / np.outer(*[np.where(size, size, 1.0)] * 2))
        self._strokes = (size[:, None] * vectors * np.sqrt(np.maximum(values, 0.0)))[:, values > INDEFINITE]
        self.valid = bool((C == C.T).all() and (values >= -INDEFINITE).all() and not C[size == 0].any()
                          and not self._grows() and (twice or 0.0) < inf
                          and even and not (self.drag and ((rates.imag == 0) & (rates != 0)).any()))
        apart = min(APART, (BALANCE / max(1, len(rates))) ** 0.5)
        half = int(PLACES / apart / 2) + 1
        turn = np.exp(1j * np.pi * (np.arange(half) + 0.5) / half)
        self.places = [(1 - share * apart) * self.basis.radius * turn for share in (1.0, 1.5)]
        least = (1 - 1.5 * apart) * (1 - apart) * self.basis.radius
        self.chosen = np.flatnonzero(np.abs(rates) > least)
        self.valid &= self.basis.of_points <= (least if twice is None else 0.0) and (
            twice is None or len(rates) <= MOST)
        self.loads = UnitLoadsOfChannels(transfer)
        self._twice, self._massive = twice, inverse_where_massive(M)
        self._known: dict[Any, Any] = {}

    @cached_property
    def begun(self) -> float:
        """‖Π z‖ of a start in fields."""
        if self._twice is None:
            return 0.0
        chosen, modes = np.flatnonzero(self.states.rates), self.modes
        begin, shown = self.states.begin[chosen], modes.shown_by_start[chosen]
        swings, own, errors = self._modes(*np.zeros((2, len(chosen), 0)), chosen)
        found, off = energies(swings, begin[:, None], swings, begin[:, None], own, errors, self.drag)
        felt, still = begin * shown, float((modes.rigid_start[1] ** 2).sum())
        found = found[0, 0] + self._twice - 2 * float(felt.real.sum()) - still
        off = off[0, 0] + ROUNDED * (self._twice + 2 * float(np.abs(felt).sum()) + still)
        slips = np.sqrt(own) @ (modes.doubt.size[chosen] * np.abs(begin) + modes.lost[chosen])
        return float(np.sqrt(max(found, 0.0) + off) + slips)

    def _grows(self):
        """Does a mode, as where K is not positive? Not one that nothing damps, which rounding makes seem to."""
        rates = self.states.rates
        return bool((rates.real > (self.basis.errors[self.states.modes] + EPSILON) * np.abs(rates)).any())

    def of_channels(self, channels: "Sequence[int]") -> Slots:
        """Unit loads on coordinates and along members, and unit displacements of driven ends."""
        at, answers, shown, drawn = list(channels), [], [], []
        moved = np.isin(at, list(self.loads.driven))
        for s in self.places:
            H = np.array([self.transfer.at(LinearOutput(q={i: 1.0}), s)[at] for i in range(self.n)]).reshape(
                self.n, len(at), len(s))
            answers.append(H)
            shown.append(self.loads.shown(at, s, H))
            drawn.append(np.moveaxis(self.loads.drawn(at, s, H, shown[-1]), -1, 0))
        share = np.where(self.states.rates.imag > 0, 2.0, 1.0)[self.chosen, None]
        felt = self.states.inputs[self.chosen[:, None], at] / share
        return self._slots(felt, np.where(moved, 0.0, felt), answers, shown, drawn, self.loads.massive(
            at, self._massive))

    def _shapes(self, chosen):
        return self.basis.shapes[:, self.states.modes[chosen]]

    def _slots(self, felt, reads, answers, shown, drawn, massive):
        strokes = [np.einsum("nl,nks->skl", self._strokes, h) for h in answers]
        return Slots(np.where(self.states.rates.imag > 0, 2.0, 1.0)[self.chosen, None] * felt, reads, reads - felt,
                     strokes, [np.moveaxis(one, -1, 0).swapaxes(1, 2) for one in shown], drawn, massive)

    def of_output(self, output: LinearOutput) -> Slots:
        """A unit load where a row of coordinates or a place is read."""
        row = np.array([output.q.get(i, 0.0) for i in range(self.n)])
        answers, shown = [], []
        for s in self.places:
            g = self.transfer.at(output, s)[:self.n]
            own = row @ g
            for place, factor in output.places.items():
                load, held = self._put(place, s)
                own = own + factor * (load * g).sum(axis=0) + factor**2 * held
            answers.append(g[:, None])
            shown.append(own[None, None])
        reads = self.basis.rows(output)[0][self.states.modes[self.chosen]][:, None]
        drawn = [np.ones((len(s), 1, 1)) for s in self.places]
        return self._slots(reads, reads, answers, shown, drawn, (row @ self._massive @ row)[None, None])

    def _put(self, place, s):
        """What a unit load at a place of a piece puts on coordinates, (n, places), and how far it goes itself while the
        ends rest."""
        one = self.transfer.pieces[place.piece]
        piece, half, load = one.piece, one.piece.order // 2, np.zeros((self.n, len(s)), complex)
        kappa = piece.reaction(s)
        bent = np.stack([fields(piece, kappa, np.tile(unit, (len(s), 1)), np.full(len(s), place.x))[..., place.along]
                         for unit in np.eye(piece.order)])
        for end, row in enumerate(one.rows):
            for i, x in row.items():
                load[i] += x * bent[end]
        if not INSIDE * piece.length < place.x < (1 - INSIDE) * piece.length:
            return load, 0.0
        left, right = (stiffness(part.piece, kappa) for part in divided_at(one, place.x, self.n))
        D = left[:, half:, half:] + right[:, :half, :half]
        return load, np.linalg.inv(D)[:, place.along, place.along]

    def of_columns(self, slots: Slots, columns: "Sequence[Column]") -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(⟨Π b, Π b⟩ of all, what rounding may put them off by, and how far the modes' own errors put off each)."""
        modes, own, errors = self._modes(slots.reads, slots.draws, self.chosen)
        number = len(slots.massive)
        at = np.array([column.slot for column in columns])
        blows = np.zeros((number, len(columns)))
        blows[at, range(len(columns))] = [column.power < 0 for column in columns]
        felt, sides = slots.inputs[:, at], []
        for s, strokes, shown, drawn in zip(self.places, slots.strokes, slots.shown, slots.drawn, strict=True):
            v = np.array([column.weights(s) for column in columns]).T
            rates = modes.rates[:, None]
            sums = (1 / (s - rates)) @ v + (1 / (s.conj() - rates)) @ v.conj() + blows.any(axis=0)
            circle = np.zeros((len(s), number, len(columns)), complex)
            circle[:, at, range(len(columns))] = 2 * v
            A = np.concatenate([-felt * sums, circle.reshape(-1, len(columns))])
            count = len(s) * number
            strokes = strokes.reshape(count, -1)
            there = DampedSwings(np.repeat(s, number), np.full(count, EPSILON), strokes, np.abs(strokes),
                                 shown.reshape(count, number), drawn.reshape(count, number))
            sides.append((DampedSwings(*map(np.concatenate, zip(modes, there, strict=True))), A))
        (first, A), (second, B) = sides
        found, off = energies(first, A, second, B, own, errors, self.drag)
        before, after = ((A.T @ (swings.rates[:, None] * swings.shown)).real @ blows
                         for swings, A in ((first, A), (second, B)))
        found += before + after.T + blows.T @ slots.massive @ blows
        slips = np.abs(B[:len(own)]).T @ (np.sqrt(own) * self.modes.doubt.size[self.chosen])
        return found, off, slips

    def norms(self, channels: "Sequence[int]", columns: "Sequence[Column]", e: np.ndarray) -> np.ndarray:
        """‖Π Σ e b‖ of rows of e, with all that may put them off; slots of columns: channels."""
        key = tuple(channels), tuple(columns)
        if key not in self._known:
            self._known[key] = self.of_columns(self.of_channels(channels), columns)
        return self._norms(self._known[key], e)

    def _norms(self, sums, e):
        found, off, slips = sums
        squares = (np.einsum("ka,ab,kb->k", one, part, one) for one, part in ((e, found), (np.abs(e), off)))
        return np.sqrt(sum(np.maximum(part, 0.0) for part in squares)) + np.abs(e) @ slips

    def _modes(self, reads, draws, chosen):
        """Those of the modes, ⟨z̄, z⟩ of each, and relative bounds of the errors of this."""
        rates, shapes, lost = self.states.rates[chosen], self._shapes(chosen), self._lost(chosen)
        strokes, errors = shapes.T @ self._strokes, self.basis.errors[self.states.modes[chosen]] + EPSILON
        sizes = np.abs(strokes) + lost / ROUNDED
        swings = DampedSwings(rates, errors, strokes, sizes, reads, draws)
        damped, pace, fade = (np.abs(strokes) ** 2).sum(axis=1), np.abs(rates), np.maximum(
            -rates.real - self.drag / 2, 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            by_loss = pace**2 * damped / fade
            off_by_loss = errors * pace / fade + ROUNDED * (sizes**2).sum(axis=1) / damped
            off_by_mass = MIXED * (fade / self.modes.gaps[chosen]) ** 2 + ROUNDED
        by_mass = 2 * pace**2 * np.abs((1 - (strokes**2).sum(axis=1)) / (2 * rates + self.drag))
        surer = ~(off_by_loss <= off_by_mass)
        return swings, np.where(surer, by_mass, by_loss), np.where(surer, off_by_mass, off_by_loss)

    def _lost(self, chosen):
        """What rounding leaves of the strokes of modes."""
        lost = np.array([self.basis.lost(LinearOutput(q={i: 1.0}))[0] for i in range(self.n)])
        return lost.reshape(self.n, -1)[:, self.states.modes[chosen]].T @ np.abs(self._strokes)

    def reach(self, output: LinearOutput, order: int) -> float:
        """Σ ‖Π a‖ of what an output's order-th rate reads, inf where one is not finite."""
        key = key_of(output), order
        if key not in self._known:
            self._known[key] = sum(self._reach(*part) for part in self._parts(output, order))
        return self._known[key]

    def _parts(self, output, order):
        """(output of what is read of displacements, which rate of it is)."""
        for rate, row in enumerate((output.q, output.v, output.a)):
            if any(row.values()):
                yield LinearOutput(q=row), rate + order
        for place, factor in output.places.items():
            if factor:
                yield LinearOutput(places={place._replace(rates=0): factor}), place.rates + order

    def takes(self, channel: int, exponent: complex, power: int) -> bool:
        """Is the energy that a load sets free known, and finite?"""
        return abs(exponent) <= FAST * self.basis.radius and self.loads.takes(channel) and (
            power >= 0 or bool(self.loads.massive([channel], self._massive)[0, 0]))

    def has_reach(self, output: LinearOutput, order: int) -> bool:
        """Is that finite?"""
        return all(self._is_finite(*part) for part in self._parts(output, order))

    def _is_finite(self, output, rate):
        if rate:
            return rate == 1 and not output.places and all(self._massive[i, i] for i in output.q)
        return all(place.along < self.transfer.pieces[place.piece].piece.order // 2 for place in output.places)

    def _reach(self, output, rate):
        if not self._is_finite(output, rate):
            return inf
        return float(self._norms(self.of_columns(self.of_output(output), [Column(0, 0j, -rate)]), np.ones((1, 1)))[0])
