"""What modes that are not counted can add to a motion, a true upper bound: by Cauchy and Schwarz

    Σ |cₙ| |bₙ|/ωₙʰ ≤ √(Σ cₙ²/ωₙ²ᵖ) √(Σ bₙ²/ωₙ^(2h−2p))      over n > N, for any p

c being what is read of a mode, b/ωʰ how far a load sets it in motion; both sums are known from exact motions without
modes. They are finite where 2p > (2k + 1)/m·2: of waves ω ~ β^(m/2), of which a k-th derivative is read. Of coordinates
with mass they are so at p = 0, Σ φ φᵀ = M⁻¹ over all modes, as of loads along members (Parseval).
"""

from collections.abc import Callable, Sequence
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.divided_pieces import divided_at
from vibcli.analyses.continuous.tail_sums import CLOSE, grid, tail_sum, without_first
from vibcli.analyses.continuous.uncoupled_parts import uncoupled_parts
from vibcli.analyses.continuous.unit_responses import UnitLoads, motions_squared, overlaps
from vibcli.numerics.pieces.graded import mirrored
from vibcli.numerics.pieces.graded_parts import is_slack
from vibcli.numerics.pieces.loads import LoadForm

if TYPE_CHECKING:
    from vibcli.analyses.continuous.exact_transfer import DrivenEnd
    from vibcli.analyses.continuous.mode_basis import ModeBasis
    from vibcli.analyses.continuous.spread_drives import SpreadDrive
    from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
    from vibcli.mechanics.factored_system import PlacedPiece

POWERS = 0.0, 0.375, 0.5, 0.625, 0.75, 1.0, 1.5, 2.0      # of ω², by which sums over b are divided
ROUNDING = 1e-12    # of a sum of squares
MASSIVE = -1.0      # of coordinates with mass and loads along members: below all POWERS
SINGULAR = 1e-10    # of the largest mass that coordinates have together: what is none
INSIDE, BESIDE = 1e-12, 1e-4    # of a length: how near to an end is at the end, and beside it


class PartRead:
    """What is read of the rate-th rates of modes: begins: the power from which on sums of it are finite, square: Σ c²
    or inf, motions: R, found as it is asked for."""

    def __init__(self, rate: int, begins: float, square: float, find: "Callable[[], np.ndarray]") -> None:
        self.rate, self.begins, self.square, self._find = rate, begins, square, find

    @cached_property
    def motions(self) -> np.ndarray:
        """(σ, 1, 1)."""
        return self._find()


class UncountedModes:
    """Those beyond a ModeBasis. K, M: without the pieces; inputs (modes, channels): b of the first modes, of the
    coordinates, of `driven` ends and of loads `spread` along members behind them; rates: 2ζω of the first modes."""

    def __init__(self, basis: "ModeBasis", K: np.ndarray, M: np.ndarray, driven: "Sequence[DrivenEnd]",
                 spread: "Sequence[SpreadDrive]", inputs: np.ndarray, rates: np.ndarray) -> None:
        self.basis, self.K, self.M, self.inputs, self.rates = basis, K, M, inputs, rates
        self.pieces = [one._replace(piece=one.piece._replace(drag=0.0)) for one in basis.placed]
        self.highest = float(np.sqrt(np.abs(basis.squares).max(initial=0.0)))
        self.driven, self.sigma = list(driven), grid(self.highest)
        self._reads: dict[Any, list[PartRead]] = {}
        self._sizes: dict[Any, float] = {}
        self.parts = uncoupled_parts(K, M, self.pieces, basis.shapes)
        self.inverse = inverse_where_massive(M)
        self.begins = np.array([self._begin(i) for i in range(len(K))] + [
            begins_at(self._order(one), self._order(one) - 1 - one.end % (self._order(one) // 2)) for one in driven] + [
                MASSIVE for _ in spread])
        self.spread, self._along = np.zeros((len(spread), len(spread))), list(spread)
        for one in self.pieces:
            forms = [drive.on(one) or LoadForm(()) for drive in spread]
            self.spread += overlaps(forms) / one.piece.inertia

    def felt_by(self, part: int) -> np.ndarray:
        """Which channels act on one of the parts, (channels,)."""
        own = [one for one, number in zip(self.pieces, self.parts.pieces, strict=True) if number == part]
        return np.array([*(number == part for number in self.parts.coordinates),
                         *(self.parts.pieces[one.piece] == part for one in self.driven),
                         *(any(drive.on(one) is not None for one in own) for drive in self._along)], bool)

    def _order(self, drive: "DrivenEnd") -> int:
        return cast("int", self.pieces[drive.piece].piece.order)

    def _begin(self, coordinate: int) -> float:
        """The power from which on Σ φ²/ω²ᵖ of a coordinate is finite."""
        if self.inverse[coordinate, coordinate]:
            return MASSIVE
        return max((begins_at(one.piece.order, end % (one.piece.order // 2)) for one in self.pieces
                    for end, row in enumerate(one.rows) if row.get(coordinate)), default=0.0)

    def load_sums(self, channels: "Sequence[int]") -> dict[float, np.ndarray]:
        """{p: Σ b bᵀ/ω²ᵖ over those left out, (channels, channels)} at POWERS, 0 where it is not finite; it bounds sums
        of loads at nodes and along members together."""
        n, m = len(self.K), len(self.K) + len(self.driven)
        chosen = np.array(channels, int)
        ends: dict[tuple[int, int], np.ndarray] = {}
        nodes, along = chosen[chosen < m], chosen[chosen >= m]
        forces = np.zeros((n, len(nodes)))
        for column, channel in enumerate(nodes.tolist()):
            if channel < n:
                forces[channel, column] = 1.0
            else:
                drive = self.driven[channel - n]
                ends.setdefault((drive.piece, drive.end), np.zeros(len(nodes)))[column] = 1.0
        R = self.left(self.pieces, UnitLoads(forces, ends), self.inputs[:, nodes])
        both = 2.0 if len(nodes) and len(along) else 1.0
        return {p: both * self._block(R, p, nodes, along, chosen) for p in POWERS}

    def _block(self, R: np.ndarray, power: float, nodes: np.ndarray, along: np.ndarray,
               chosen: np.ndarray) -> np.ndarray:
        found, finite = np.zeros((len(chosen),) * 2), self.begins[nodes] < power
        at = np.flatnonzero(np.isin(chosen, nodes[finite]))
        if len(at) and power:
            left = R[:, finite][:, :, finite]
            found[np.ix_(at, at)] = self.sums(left, power, float(self.begins[nodes[finite]].max()))
        elif len(at):
            known = self.inputs[:, nodes[finite]]
            found[np.ix_(at, at)] = left_of_squares(self.inverse[np.ix_(nodes[finite], nodes[finite])], known.T @ known)
        at = np.flatnonzero(np.isin(chosen, along))
        spread, known = along - len(self.begins) + len(self.spread), self.inputs[:, along]
        left = left_of_squares(self.spread[np.ix_(spread, spread)], known.T @ known)
        found[np.ix_(at, at)] = left * self.highest ** (-2 * power)
        return found

    def left(self, pieces: "Sequence[PlacedPiece]", loads: UnitLoads, first: np.ndarray) -> np.ndarray:
        """R of loads on these pieces, (σ, columns, columns); first: c of the first modes, (modes, columns)."""
        n = len(loads.forces)
        K, M = (np.pad(part, (0, n - len(part))) for part in (self.K, self.M))
        total = motions_squared(K, M, pieces, loads, self.sigma)
        return without_first(total, self.sigma, self.basis.squares, first)

    def sums(self, R: np.ndarray, power: float, begins: float) -> np.ndarray:
        """Σ c cᵀ/ω²ᵖ."""
        return tail_sum(R, self.sigma, self.highest, power, max(begins, 0.0))

    def reach(self, output: "LinearOutput", power: float, rate: int) -> float:
        """√(Σ c²/ω²ᵖ) of what an output reads of the rate-th rates of modes."""
        key = _key(output), power, rate
        if key not in self._sizes:
            self._sizes[key] = sum(float(np.sqrt(self.sums(part.motions, power, part.begins)[0, 0] if power > 0 else
                                                 part.square if not power else np.inf))
                                   for part in self._read(output) if part.rate == rate)
        return self._sizes[key]

    def reaches(self, output: "LinearOutput", power: float, rate: int) -> float:
        """1 where the same is finite, which needs no sums, else inf."""
        finite = all(power > max(part.begins, 0.0) + CLOSE if power > 0 else not power and part.square < np.inf
                     for part in self._read(output) if part.rate == rate)
        return 1.0 if finite else np.inf

    def reads(self, output: "LinearOutput", rate: int) -> bool:
        """Does an output read the rate-th rates of modes?"""
        return any(part.rate == rate for part in self._read(output))

    def _read(self, output: "LinearOutput") -> list[PartRead]:
        """The parts of an output."""
        key = _key(output)
        if key not in self._reads:
            found = []
            for rate, part in enumerate((output.q, output.v, output.a)):
                if any(part.values()):
                    row = np.array([part.get(i, 0.0) for i in range(len(self.K))])
                    first = self.basis.shapes.T @ row
                    found.append(PartRead(rate, max(self.begins[i] for i, x in part.items() if x),
                                          self._square(row, first), partial(self._of_row, row, first)))
            found += [PartRead(place.rates, self.begins_of(place), self._at_end(place) * x**2,
                               partial(self._at_place, place, x)) for place, x in output.places.items() if x]
            self._reads[key] = found
        return self._reads[key]

    def _of_row(self, row: np.ndarray, first: np.ndarray) -> np.ndarray:
        return self.left(self.pieces, UnitLoads(row[:, None], {}), first[:, None])

    def _square(self, row: np.ndarray, first: np.ndarray) -> float:
        """Σ c² of coordinates, inf where one has no mass."""
        if any(x and not self.inverse[i, i] for i, x in enumerate(row)):
            return np.inf
        return float(left_of_squares(row @ self.inverse @ row, first @ first))

    def begins_of(self, place: "FieldPoint") -> float:
        """The power from which on sums of a place are finite; infinite beside an end without tension, where a unit
        load, by which they are known, has no finite motion."""
        one = self.pieces[place.piece].piece
        seen, x = (one, place.x) if place.x < one.length / 2 else (mirrored(one), one.length - place.x)
        if one.order == 2 and x < BESIDE * one.length and is_slack(seen):
            return np.inf
        return begins_at(one.order, place.along)

    def _at_end(self, place: "FieldPoint") -> float:
        """Σ c² of u or of a slope at an end of a piece, inf within it, or where nothing there has mass."""
        one, length = self.pieces[place.piece], self.pieces[place.piece].piece.length
        if self.begins_of(place) == np.inf:
            return np.inf
        half = one.piece.order // 2
        if place.along >= half or INSIDE * length < place.x < (1 - INSIDE) * length:
            return np.inf
        row = np.zeros(len(self.K))
        for i, x in one.rows[place.along + (half if place.x > length / 2 else 0)].items():
            row[i] = x
        return self._square(row, self.basis.field(place.piece, place.x, place.along))

    def _at_place(self, place: "FieldPoint", factor: float) -> Any:
        """R of a factor of u or of a derivative within a piece. Next to an end, where a part would be too stiff beside
        all else, what is seen is no more than twice what both the end and a place further off show together."""
        length = self.pieces[place.piece].piece.length
        near = min(place.x, length - place.x)
        if not INSIDE * length < near < BESIDE * length:
            return self._at_one(place) * factor**2
        ends = (0.0, BESIDE * length) if place.x < length / 2 else (length, (1 - BESIDE) * length)
        return 2 * sum(self._at_one(place._replace(x=x)) for x in ends) * factor**2

    def _at_one(self, place: "FieldPoint") -> np.ndarray:
        pieces, k, n, one = list(self.pieces), place.piece, len(self.K), self.pieces[place.piece]
        half, length, last = one.piece.order // 2, one.piece.length, False
        if INSIDE * length < place.x < (1 - INSIDE) * length:
            pieces[k:k + 1], k, n = divided_at(one, place.x, n), k + 1, n + half
        else:
            last = place.x > length / 2
        one, ends, forces = pieces[k], {}, np.zeros((n, 1))
        at, sign = (half, 1.0) if last else (0, -1.0)
        tension = one.piece.tension + (one.piece.gradient * one.piece.length if last else 0.0)
        row = {}
        if place.along < half:
            row = one.rows[at + place.along]
        elif half == 1:
            ends[k, at] = np.array([-sign / tension])
        elif place.along == 2:
            ends[k, at + 1] = np.array([-sign / one.piece.bending])
        else:
            ends[k, at] = np.array([sign / one.piece.bending])
            row = {i: x * tension / one.piece.bending for i, x in one.rows[at + 1].items()}
        for i, x in row.items():
            forces[i, 0] = x
        first = self.basis.field(place.piece, place.x, place.along)
        return self.left(pieces, UnitLoads(forces, ends), first[:, None])


def size_of(vectors: np.ndarray, sums: np.ndarray) -> np.ndarray:
    """√(vᵀ S v) of vectors (…, channels)."""
    return cast("np.ndarray", np.sqrt(np.maximum(np.einsum("...i,ij,...j->...", vectors, sums, vectors), 0.0)))


def left_of_squares(total: Any, known: Any) -> Any:
    """Σ b bᵀ without those that are counted, no less than their rounding."""
    found = total * (1 + ROUNDING) - known
    return np.where(np.eye(len(found)), np.maximum(found, ROUNDING * total), found) if np.ndim(found) else max(
        found, ROUNDING * total)


def inverse_where_massive(M: np.ndarray) -> np.ndarray:
    """M⁻¹ of the coordinates that have mass, of those that it couples together; of all others 0."""
    found, left = np.zeros(np.shape(M)), set(range(len(M)))
    while left:
        group, fresh = set(), {left.pop()}
        while fresh:
            group |= fresh
            fresh = {int(j) for i in fresh for j in np.flatnonzero(M[i])} - group
        left -= group
        at = np.ix_(*[sorted(group)] * 2)
        values, vectors = np.linalg.eigh(M[at])
        if values[0] > SINGULAR * values[-1]:
            found[at] = (vectors / values) @ vectors.T
    return found


def begins_at(order: int, along: int) -> float:
    """p above which Σ (dᵏφ/dxᵏ)²/ω²ᵖ is finite."""
    return (2 * along + 1) / order


def _key(output: "LinearOutput") -> tuple[tuple[tuple[Any, float], ...], ...]:
    return tuple(tuple(sorted(part.items())) for part in (output.q, output.v, output.a, output.places))
