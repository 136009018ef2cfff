"""How far modes that are not counted go where dampers or drag couple them, a true upper bound.

With M, C, K symmetric and none of them negative, what the first N modes and what loads do exactly leave of a motion,
z = (r, ṙ), vibrates freely: ⟨z, z⟩, ⟨z₁, z₂⟩ = x₁ᵀ K x₂ + v₁ᵀ M v₂, twice its energy, never grows. It is orthogonal to
the modes that are counted in [z₁, z₂] = x₁ᵀ K x₂ − v₁ᵀ M v₂. With Π, which takes these off, and a = (K⁻¹ δ, 0)

    r(x, t) = [a, z] = [Π a, z],      |r(x, t)| ≤ ‖Π a‖ Σ ‖Π zₖ‖

over the jumps, bends and blows zₖ of the free part up to then; of the rate of what has mass a = (0, M⁻¹ δ). Where drag
acts on all, so holds it of e^{δt} z, K − δ C + δ² M and C − 2 δ M in place of K and C.

With A, ż = A z, A⁻ᵏ a and Aᵏ z do as well as a and z: forces, shears and rates of what has no mass of its own, whose a
has no finite energy, are bounded by Aᵏ z, which is what the k-th rates of loads leave, where that has one.

A load f(τ) leaves minus the mean of (h, s h) f̂(s) over a circle about all s of loads, h = D(s)⁻¹ b (Cauchy), and a is
that of a step; Π takes off what each mode between this circle and those left out brings.
"""

from math import inf
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.damped_energies import ROUNDED, DampedSwings, OwnEnergies, energies
from vibcli.analyses.continuous.dragged_pieces import DraggedPieces
from vibcli.analyses.continuous.free_fading import fading
from vibcli.analyses.continuous.left_out_causes import flaw_of
from vibcli.analyses.continuous.left_out_columns import MANY, SHARES, Column, PlacesOnCircles, places_on
from vibcli.analyses.continuous.left_out_readings import Reading, readings
from vibcli.analyses.continuous.modal_reads import key_of
from vibcli.analyses.continuous.modal_start import of_load
from vibcli.analyses.continuous.unit_answers import UnitLoadsOf
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from vibcli.analyses.continuous.complex_modes import ComplexModes
    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.analyses.continuous.field_start import StartInFields
    from vibcli.analyses.continuous.unit_answers import UnitAnswers

EPSILON = 2.0**-52
APART, BALANCE = 0.2, 8.0       # of the radius within which all modes are counted: how far a circle is within at most,
                                # and times the inverse of how many these are its square
PLACES = 40.0       # places on a circle, over that share: what is left out is told to e⁻⁴⁰
FAST = 0.5          # of that radius: exponents of loads well within
INDEFINITE = 1e-12  # of dampers of one size: what is none
MIXED = 100.0       # times (damping / distance of neighbours)²: how far shapes of modes are from real ones
SQUARED = 2.0**-42  # what rounding leaves of ∫ |w|² dx of a mode
MOST = 4_096        # modes that a start in fields is divided in, as all of them stand beside one another


class Slots(NamedTuple):
    """Unit loads, or unit displacements of driven ends: inputs (modes, slots), how far each mode is felt by them as
    they begin; modes, and circles: what does so at places of both circles, as DampedSwings, modes with their
    OwnEnergies; massive: bᵀ M⁻¹ b of those that act on mass, (slots, slots)."""

    inputs: np.ndarray
    modes: DampedSwings
    own: OwnEnergies
    circles: list[DampedSwings]
    massive: np.ndarray
    places: list[PlacesOnCircles]


class LeftOutEnergy:
    """Of ComplexModes; begun: q and v at t = 0; of a start in fields that: a StartInFields; fading: δ."""

    def __init__(self, modes: "ComplexModes", transfer: "ExactTransfer", begun: "tuple[np.ndarray, np.ndarray]",
                 start: "StartInFields | None" = None) -> None:
        self.modes, self.states, self.basis, self.transfer = modes, modes.states, modes.basis, transfer
        self.n, (_, C, M), rates = transfer.n, transfer.matrix.polynomial, modes.states.rates
        self.held, self.struck = (transfer.at_rest(begun[0]), M @ begun[1]) if start is None else np.zeros((2, self.n))
        self.fading = fading(transfer) if start is None else 0.0
        self._dragged = DraggedPieces(transfer, self.fading)
        C = C - 2 * self.fading * M
        size = np.sqrt(np.maximum(np.diagonal(C), 0.0))
        values, vectors = np.linalg.eigh(C / np.outer(*[np.where(size, size, 1.0)] * 2))
        self._strokes = (size[:, None] * vectors * np.sqrt(np.maximum(values, 0.0)))[:, values > INDEFINITE]
        damps = bool((C == C.T).all() and (values >= -INDEFINITE).all() and not C[size == 0].any())
        apart = min(APART, (BALANCE / max(1, len(rates))) ** 0.5)
        half = int(PLACES / apart / 2) + 1
        turn = np.exp(1j * np.pi * (np.arange(half) + 0.5) / half)
        circles = [(1 - share * apart) * self.basis.radius * turn for share in (1.0, 1.5)]
        self._places = [[places_on(circle, self.basis.radius, smooth * share)
                         for circle, share in zip(circles, SHARES, strict=True)] for smooth in range(2)]
        least = (1 - 1.5 * apart) * (1 - apart) * self.basis.radius
        self.chosen = np.flatnonzero(np.abs(rates) > least)
        told_apart = self.basis.of_points <= least if start is None else not self.basis.of_points and len(rates) <= MOST
        self.flaw = flaw_of(damps, any(one.retardation for one in transfer.pieces), self._grows(),
                            start is not None and start.twice(0) == inf, told_apart)
        self.loads, self._start = UnitLoadsOf(transfer), start
        self._known: dict[Any, Any] = {}

    @property
    def in_fields(self) -> bool:
        """Does the motion start so?"""
        return self._start is not None

    def begun(self, k: int) -> float:
        """‖Π Aᵏ z‖ of a start in fields, without its blows."""
        if ("begun", k) not in self._known:
            twice = 0.0 if self._start is None else self._start.twice(k)
            self._known["begun", k] = self._begun(k, twice) if 0 < twice < inf else twice
        return cast("float", self._known["begun", k])

    @property
    def begun_by(self) -> np.ndarray:
        """The blows of A z of a start in fields, on each coordinate."""
        return np.zeros(self.n) if self._start is None else self._start.blows

    def _begun(self, k: int, twice: float | None) -> float:
        chosen, modes = np.flatnonzero(self.states.rates), self.modes
        rates, shown = self.states.rates[chosen], modes.shown_by_start[k][chosen]
        begin = self.states.begin[chosen] * rates**k
        if k:
            blown = self.begun_by @ self.basis.shapes[:, self.states.modes[chosen]]
            begin, shown = begin - np.where(rates.imag > 0, 2.0, 1.0) * blown, shown - rates * blown
        swings, own = self._modes(np.zeros((len(chosen), 0)), {}, chosen)
        found, off = energies(swings, begin[:, None], swings, begin[:, None], own, self._dragged.drags)
        felt, still = begin * shown, 0.0 if k else float((modes.rigid_start[1] ** 2).sum())
        found = found[0, 0] + twice - 2 * float(felt.real.sum()) - still
        off = off[0, 0] + ROUNDED * (twice + 2 * float(np.abs(felt).sum()) + still)
        lost = modes.doubt.size[chosen] * np.abs(begin) + np.abs(rates) ** k * modes.lost[chosen]
        return float(np.sqrt(max(found, 0.0) + off) + np.sqrt(own.energies) @ lost)

    def _grows(self) -> bool:
        """Does a mode, as where K is not positive? Not one that nothing damps, which rounding makes seem to."""
        rates = self.states.rates
        return bool((rates.real > (self.basis.errors[self.states.modes] + EPSILON) * np.abs(rates)).any())

    def of_channels(self, channels: "Sequence[int]", smooth: bool = False) -> Slots:
        """Unit loads on coordinates and along members, and unit displacements of driven ends; at places about the τ
        too where what is asked is `smooth`."""
        at, numbers = list(channels), self.states.modes[self.chosen]
        share = np.where(self.states.rates.imag > 0, 2.0, 1.0)[self.chosen, None]
        along = {}
        for number in self._dragged.numbers:
            reads = np.zeros((len(numbers), len(at)), complex)
            for slot, form in self.loads.forms(at, number):
                reads[:, slot] = of_load(self.basis, number, form)[numbers]
            along[number] = reads
        felt = self.states.inputs[self.chosen[:, None], at] / share
        forces = np.where(np.isin(at, list(self.loads.driven)), felt, 0.0)
        return self._slots(felt, forces, along, lambda s: self.loads.of_channels(at, s), self.loads.massive(at), smooth)

    def of_output(self, output: LinearOutput, smooth: bool = False) -> Slots:
        """A unit load where displacements of coordinates or a place are read."""
        row = np.array([output.q.get(i, 0.0) for i in range(self.n)])
        reads = self.basis.rows(output)[0][self.states.modes[self.chosen]][:, None]
        return self._slots(reads, 0 * reads, {place.piece: reads for place in output.places},
                           lambda s: self.loads.of_output(output, s), (row @ self.loads.inverse @ row)[None, None],
                           smooth)

    def _slots(self, felt: np.ndarray, forces: np.ndarray, along: dict[int, np.ndarray],
               answers: "Callable[[np.ndarray], UnitAnswers]", massive: np.ndarray, smooth: bool) -> Slots:
        modes, own = self._modes(felt - forces, along, self.chosen)
        share = np.where(self.states.rates.imag > 0, 2.0, 1.0)[self.chosen, None]
        places = self._places[smooth]
        circles = [self._circle(answers(one.all)) for one in places]
        return Slots(share * felt, modes._replace(loads=-forces), own, circles, massive, places)

    def _circle(self, answers: "UnitAnswers") -> DampedSwings:
        """DampedSwings of all slots at each place of a circle."""
        slots, m = answers.moved.shape[1:]
        strokes = np.einsum("nl,nks->skl", self._strokes, answers.moved).reshape(m * slots, -1)
        shown = np.swapaxes(np.moveaxis(answers.shown(self.transfer.pieces), -1, 0), 1, 2)
        acting = np.moveaxis(answers.acting(self.transfer.pieces), -1, 0)
        return DampedSwings(np.repeat(answers.s + self.fading, slots), np.full(m * slots, EPSILON), strokes,
                            np.abs(strokes), shown.reshape(m * slots, slots), acting.reshape(m * slots, slots),
                            *self._dragged.of_answers(answers))

    def of_columns(self, slots: Slots, columns: "Sequence[Column]") -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(⟨Π b, Π b⟩ of all, what rounding may put them off by, and how far the modes' own errors put off each)."""
        modes, own = slots.modes, slots.own
        number = len(slots.massive)
        at = np.array([column.slot for column in columns])
        blows = np.zeros((number, len(columns)))
        blows[at, range(len(columns))] = [column.is_blow for column in columns]
        felt, sides = slots.inputs[:, at], []
        rates = self.states.rates[self.chosen, None]
        for places, there in zip(slots.places, slots.circles, strict=True):
            s, v = places.all, np.array([column.weights(places) for column in columns]).T
            sums = (1 / (s - rates)) @ v + (1 / (s.conj() - rates)) @ v.conj() + blows.any(axis=0)
            circle = np.zeros((len(s), number, len(columns)), complex)
            circle[:, at, range(len(columns))] = 2 * v
            A = np.concatenate([-felt * sums, circle.reshape(-1, len(columns))])
            sides.append((DampedSwings(*map(np.concatenate, zip(modes, there, strict=True))), A))
        (first, A), (second, B) = sides
        found, off = energies(first, A, second, B, own, self._dragged.drags)
        before, after = ((A.T @ (swings.rates[:, None] * swings.shown)).real @ blows
                         for swings, A in ((first, A), (second, B)))
        found += before + after.T + blows.T @ slots.massive @ blows
        slips = np.abs(B[:len(rates)]).T @ (np.sqrt(own.energies) * self.modes.doubt.size[self.chosen])
        return found, off, slips

    def norms(self, channels: "Sequence[int]", columns: "Sequence[Column]", e: np.ndarray) -> np.ndarray:
        """‖Π Σ e b‖ of rows of e, with all that may put them off; slots of columns: channels."""
        return self._norms(self._sums(channels, columns), e)

    def smooth_norms(self, channels: "Sequence[int]", columns: "Sequence[Column]", e: np.ndarray) -> np.ndarray:
        """‖Π (τ − A)⁻¹ Σ e b‖ for each τ, (τ, rows of e)."""
        return self._smooth_norms(self._sums(channels, _smooth(columns)), e)

    def _sums(self, channels: "Sequence[int]", columns: "Sequence[Column]") -> tuple[np.ndarray, ...]:
        smooth = columns[0].smooth is not None
        on, key = (tuple(channels), smooth), (tuple(channels), tuple(columns))
        if key not in self._known:
            if on not in self._known:
                self._known[on] = self.of_channels(channels, smooth)
            self._known[key] = self.of_columns(self._known[on], columns)
        return cast("tuple[np.ndarray, ...]", self._known[key])

    def _smooth_norms(self, sums: tuple[np.ndarray, ...], e: np.ndarray) -> np.ndarray:
        blocks = np.arange(MANY * e.shape[1]).reshape(MANY, -1)
        found, off, slips = sums
        return np.array([self._norms((found[np.ix_(at, at)], off[np.ix_(at, at)], slips[at]), e) for at in blocks])

    def _norms(self, sums: tuple[np.ndarray, ...], e: np.ndarray) -> np.ndarray:
        found, off, slips = sums
        squares = (np.einsum("ka,ab,kb->k", one, part, one) for one, part in ((e, found), (np.abs(e), off)))
        return cast("np.ndarray", np.sqrt(sum(np.maximum(part, 0.0) for part in squares)) + np.abs(e) @ slips)

    def _modes(self, reads: np.ndarray, along: dict[int, Any], chosen: np.ndarray) -> tuple[DampedSwings, OwnEnergies]:
        """Those of the modes, and their OwnEnergies."""
        key = len(chosen), "modes"
        if key not in self._known:
            self._known[key] = self._alone(chosen)
        swings, own, ends = self._known[key]
        none = np.zeros(reads.shape)
        return DampedSwings(*swings, reads, none, *self._dragged.of_modes(ends, along, none)), own

    def _alone(self, chosen: np.ndarray) -> tuple[tuple[np.ndarray, ...], OwnEnergies, list[Any]]:
        """Rates, errors, strokes and sizes of these, their energies, by what they lose, or, where that is little, by
        their mass, and their ends."""
        numbers, lost = self.states.modes[chosen], self._lost(chosen)
        rates = self.states.rates[chosen] + self.fading
        pace, fade = np.abs(rates), np.maximum(-rates.real, 0.0)
        strokes, drags = self.basis.shapes[:, numbers].T @ self._strokes, [c for c, _ in self._dragged.drags]
        sizes, (plain, squares) = np.abs(strokes) + lost / ROUNDED, self._dragged.squares(self.basis, numbers)
        with np.errstate(divide="ignore", invalid="ignore"):
            errors = (self.basis.errors[numbers] + EPSILON) * np.abs(self.states.rates[chosen]) / pace
            dragged = squares @ drags
            damped = (np.abs(strokes) ** 2).sum(axis=1) + dragged
            by_loss = pace**2 * damped / fade
            off_by_loss = errors * pace / fade + (ROUNDED * (sizes**2).sum(axis=1) + SQUARED * dragged) / damped
            off_by_mass = MIXED * (fade / self.modes.gaps[chosen]) ** 2 + ROUNDED
        by_mass = pace * np.abs(1 - (strokes**2).sum(axis=1) - plain @ drags)
        surer = ~(off_by_loss <= off_by_mass)
        own = OwnEnergies(np.where(surer, by_mass, by_loss), np.where(surer, off_by_mass, off_by_loss), plain)
        return (rates, errors, strokes, sizes), own, self._dragged.ends_of_modes(self.basis, numbers)

    def _lost(self, chosen: np.ndarray) -> np.ndarray:
        """What rounding leaves of the strokes of modes."""
        lost = np.array([self.basis.lost(LinearOutput(q={i: 1.0}))[0] for i in range(self.n)])
        return cast("np.ndarray", lost.reshape(self.n, -1)[:, self.states.modes[chosen]].T @ np.abs(self._strokes))

    def readings(self, output: LinearOutput, order: int) -> list[Reading]:
        """What makes up an output's order-th rate."""
        return readings(output, order, self.transfer.pieces, [bool(x) for x in np.diagonal(self.loads.inverse)])

    def reach(self, reading: Reading) -> float:
        """‖Π A⁻ᵏ a‖."""
        key = key_of(reading.output), reading.rate
        if key not in self._known:
            columns, e = reading.columns(reading.level, self.fading)
            sums = self.of_columns(self.of_output(reading.output), columns)
            self._known[key] = float(self._norms(sums, np.array([e]))[0])
        return cast("float", self._known[key])

    def smooth_reaches(self, reading: Reading) -> np.ndarray:
        """‖Π (τ − A)⁻¹ A¹⁻ᵏ a‖ for each τ, (τ,)."""
        key = key_of(reading.output), reading.rate, "smooth"
        if key not in self._known:
            columns, e = reading.columns(reading.level - 1, self.fading)
            sums = self.of_columns(self.of_output(reading.output, True), _smooth(columns))
            self._known[key] = self._smooth_norms(sums, np.array([e]))[:, 0]
        return cast("np.ndarray", self._known[key])

    @property
    def tau(self) -> np.ndarray:
        """Those of smooth norms."""
        return self._places[True][0].poles + self.fading

    def takes(self, channel: int, exponent: complex, power: int) -> bool:
        """Is the energy that a load sets free known, and finite?"""
        return abs(exponent) <= FAST * self.basis.radius and self.loads.takes(channel) and (
            power >= 0 or (power == -1 and bool(self.loads.massive([channel])[0, 0])))

    def takes_smooth(self, channel: int, exponent: complex, power: int) -> bool:
        """Is that of (τ − A)⁻¹ of what it sets free?"""
        return abs(exponent) <= FAST * self.basis.radius and self.loads.takes(channel) and (
            power >= 0 or (power == -1 and channel not in self.loads.driven))


def _smooth(columns: "Sequence[Column]") -> list[Column]:
    """The same columns for each τ."""
    return [column._replace(smooth=j) for j in range(MANY) for column in columns]
