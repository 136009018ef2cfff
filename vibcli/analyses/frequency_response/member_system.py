"""Frequency responses of scenes with members, exact: H(s) = c(s)ᵀ X with D(s) X = load, solved at every frequency.

Inputs are the last coordinates of the scene before further nodes; with x what is free, g the inputs,

    D_ff x = −D_fi g      y = D_ff⁻ᵀ c_f      H = c_fᵀ x + c_iᵀ g      H′ = c′ᵀ X + yᵀ (−D′_ff x − (D_fi g)′) + c_iᵀ g′.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.frequency_response.direct import apart_from_poles, probe, solutions
from vibcli.analyses.frequency_response.member_solution import motions, pattern_of, scaled, scales
from vibcli.analyses.frequency_response.quadratics import polynomial, slope
from vibcli.base.errors import LostDigits
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix, EvaluatedMatrix

BLOCK = 2.0**18     # entries of the matrices that are held at once
UNIT = 2.0**-52


class MemberInput(NamedTuple):
    """weights {coordinate of an input: its share}, times (−s²)^turns."""

    weights: dict[int, Any]
    turns: int = 0


class MemberOutput(NamedTuple):
    """rows: {coordinate: coefficient} of s⁰, s¹, s²; ends: (factor, piece, end value) of the forces on ends of pieces
    that it holds besides; within: (factor, piece, part of its length, order) of derivatives of u there."""

    rows: tuple[dict[int, Any], ...]
    ends: tuple[tuple[float, int, int], ...] = ()
    within: tuple[tuple[float, int, float, int], ...] = ()

    def divided(self, share: float, order: Any) -> "MemberOutput":
        """The same where each piece has become two at a part of its length; order(piece): its order."""
        ends = tuple((factor, 2 * piece + (end >= order(piece) // 2), end) for factor, piece, end in self.ends)
        within = tuple((factor, 2 * piece, at / share, along) if at < share else
                       (factor, 2 * piece + 1, (at - share) / (1 - share), along)
                       for factor, piece, at, along in self.within)
        return self._replace(ends=ends, within=within)


class Solved(NamedTuple):
    """H, dH/ds or None, whether there is a pole, how far pieces are beyond what rounding leaves, and whether D is
    nearly singular: (N,) each."""

    values: Any
    slopes: Any
    resonant: Any
    excess: Any
    singular: Any


class MemberSystem:
    """matrix: the DynamicMatrix with the inputs among its coordinates; driven: numbers of these."""

    __slots__ = ("_divided", "driven", "free", "given", "matrix", "output", "pattern")

    def __init__(self, matrix: "DynamicMatrix", driven: "Sequence[int] | np.ndarray", given: MemberInput,
                 output: MemberOutput) -> None:
        self.matrix, self.given, self.output = matrix, given, output
        self.driven = np.array(driven, int)
        self.free = np.array([i for i in range(matrix.n) if i not in driven], int)
        self.pattern = pattern_of(matrix, self.free)
        self._divided: dict[float, MemberSystem] = {}

    def divided(self, share: float) -> "MemberSystem":
        """The same with further nodes in all pieces, kept."""
        if share not in self._divided:
            output = self.output.divided(share, lambda piece: self.matrix.pieces[piece].piece.order)
            self._divided[share] = MemberSystem(self.matrix.divided(share), self.driven, self.given, output)
        return self._divided[share]

    def mixed(self, other: "MemberSystem", share: float) -> "MemberSystem":
        """With a share of the damping that the other has besides."""
        return MemberSystem(self.matrix.mixed(other.matrix, share), self.driven, self.given, self.output)

    def without_damping(self) -> "MemberSystem":
        """The same without dampers and drag."""
        return MemberSystem(self.matrix.without_damping(), self.driven, self.given, self.output)

    def shared(self) -> "dict[int, float] | None":
        """The row of the place that load and signal share, over the coordinates of the scene; None elsewhere."""
        row, *rates = self.output.rows
        apart = self.output.ends or self.output.within
        if self.given.turns or apart or any(rates) or not row or not max(row) < min(self.driven, default=0):
            return None
        polynomial, ends = self.matrix.polynomial, [row for placed in self.matrix.pieces for row in placed.rows]
        taken = {j: share for j, share in self.given.weights.items() if share}
        if polynomial[1:, :, list(taken)].any() or any(i in taken for end in ends for i in end):
            return None
        load = -sum(share * polynomial[0][self.free, j] for j, share in taken.items())
        seen = np.zeros(self.matrix.n)
        for i, x in self.matrix.seen(row).items():
            seen[i] = x
        seen = seen[self.free]
        at = np.abs(seen).argmax()
        alike = np.abs(load * seen[at] - seen * load[at]) <= 8 * UNIT * np.abs(seen * load[at])
        return dict(row) if load[at] and alike.all() else None

    def to_pole(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Newton's step towards the next pole, of 1/h with h = rᵀ D⁻¹ r, and the excess of the pieces."""
        found = self.matrix.at(s, True, loaded=False)
        scale = scales(found.size[self.free])
        D = scaled(found.D[np.ix_(self.free, self.free)], scale)
        r = np.broadcast_to(probe(len(self.free)), D.shape[:2])[:, :, None] + 0j
        x = solutions(D, r)[:, :, 0] * scale.T
        y = solutions(np.swapaxes(D, 1, 2), r)[:, :, 0] * scale.T
        moved = np.einsum("ki,ijk,kj->k", y, found.slope[np.ix_(self.free, self.free)], x)
        return -np.einsum("ki,ki->k", y / scale.T, r[:, :, 0]) / moved, found.excess

    def in_blocks(self, s: np.ndarray, steep: bool) -> Solved:
        """At each s, so many at a time as are held at once."""
        size = max(1, int(BLOCK / max(self.matrix.n, 4) ** 2))
        blocks = [self.solved(s[k:k + size], steep) for k in range(0, max(len(s), 1), size)]
        return Solved(*(None if parts[0] is None else np.concatenate(parts) for parts in zip(*blocks, strict=True)))

    def solved(self, s: np.ndarray, steep: bool) -> Solved:
        """At each s: (N,)."""
        found = self.matrix.at(s, steep)
        (g, g_slope), (c, c_slope) = self.driving(s), self.seen(found, s, steep)
        D, ahead = _among(found.D, self.free, self.free), _among(found.D, self.free, self.driven)
        b, seen, scale = -np.einsum("ijk,jk->ik", ahead, g), c[self.free], scales(found.size[self.free])
        loads = [b, seen] if steep and self.pattern is not None else [b]
        x, singular = motions(D, scale, loads, self.pattern)
        values, slopes, resonant = np.einsum("ik,ik->k", seen, x[0]) + 0j, None, np.zeros(len(s), bool)
        if steep:
            y = x[1] if len(x) > 1 else motions(D.swapaxes(0, 1), scale, [seen], None)[0][0]
            whole = np.zeros((self.matrix.n, len(s)), complex)
            whole[self.free], whole[self.driven] = x[0], g
            moved = np.einsum("ijk,jk->ik", found.slope[self.free], whole) + np.einsum("ijk,jk->ik", ahead, g_slope)
            slopes = (np.einsum("ik,ik->k", c_slope, whole) - np.einsum("ik,ik->k", y, moved)
                      + np.einsum("ik,ik->k", c[self.driven], g_slope))
        for k in np.flatnonzero(singular):
            at = scale[:, k]
            values[k], resonant[k] = apart_from_poles(D[:, :, k] * np.outer(at, at), b[:, k] * at, seen[:, k] * at)
        return Solved(values + np.einsum("ik,ik->k", c[self.driven], g), slopes, resonant, found.excess, singular)

    def driving(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The inputs g and dg/ds, (inputs, N)."""
        shares = np.array([self.given.weights.get(i, 0.0) for i in self.driven]).reshape(-1, 1)
        if not self.given.turns:
            return shares * np.ones(len(s)), shares * np.zeros(len(s))
        return shares * -s**2, shares * -2 * s

    def seen(self, found: "EvaluatedMatrix", s: np.ndarray, steep: bool) -> tuple[np.ndarray, np.ndarray | None]:
        """c(s) and dc/ds, (n, N)."""
        parts = np.zeros((3, self.matrix.n), complex)
        for power, row in enumerate(self.output.rows):
            for i, x in self.matrix.seen(row).items():
                parts[power, i] = x
        parts = parts if parts.imag.any() else parts.real
        if not self.output.ends and not self.output.within and not parts[1:].any():
            c = np.repeat(parts[0][:, None], len(s), axis=1)
            return c, np.zeros_like(c) if steep else None
        c, c_slope = polynomial(parts, s).T.copy(), slope(parts, s).T.copy() if steep else None
        for one in self.output.ends:
            c, c_slope = self._seen_at_end(c, c_slope, found, one, s)
        for one in self.output.within:
            c, c_slope = self._seen_within(c, c_slope, one, s)
        return c, c_slope

    def _seen_at_end(self, c: np.ndarray, c_slope: np.ndarray | None, found: "EvaluatedMatrix",
                     one: tuple[float, int, int], s: np.ndarray) -> tuple[np.ndarray, np.ndarray | None]:
        """c and its slope with the force on the end of a piece, less what its stiffness resists rates with."""
        factor, number, end = one
        placed, parts = self.matrix.pieces[number], found.of_end(number, end)
        parts += [(j, -1.0, put[:, end], None if steeper is None else steeper[:, end])
                  for j, put, steeper in found.put.get(number, ())]
        beta = float(placed.retardation)
        whole = 1 + beta * s if beta else 1.0
        for i, x, weight, steep in parts:
            c[i] += factor * x * weight / whole
            if c_slope is not None and steep is not None:
                c_slope[i] += factor * x * (steep - beta * weight / whole) / whole
        return c, c_slope

    def _seen_within(self, c: np.ndarray, c_slope: np.ndarray | None, one: tuple[float, int, float, int],
                     s: np.ndarray) -> tuple[np.ndarray, np.ndarray | None]:
        """c and its slope with what is seen within a piece."""
        from vibcli.analyses.frequency_response.places_within_pieces import loaded_within, weights_within

        factor, number, share, order = one
        placed = self.matrix.pieces[number]
        if order > 1 and self.matrix.is_short(number):
            raise LostDigits("how a piece bends that is so short beside its member is not found within it",
                             "ask at one of its ends")
        weights, slopes = weights_within(placed, s, share, order, c_slope is not None)
        c = c.astype(np.result_type(c, weights), copy=False)
        parts = [(i, float(x), weights[b], None if slopes is None else slopes[b])
                 for b, row in enumerate(placed.rows) for i, x in row.items()]
        parts += [(j, 1.0, *loaded_within(drive, placed, s, share, order, slopes is not None))
                  for j, drive in self.matrix.spread.items()]
        for i, x, weight, steeper in parts:
            c[i] += factor * x * weight
            if c_slope is not None and steeper is not None:
                c_slope[i] += factor * x * steeper
        return c, c_slope


def _among(D: np.ndarray, rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
    """D over some rows and columns, ascending: no copy where they follow one another."""
    return D[_run(rows)][:, _run(columns)]


def _run(numbers: np.ndarray) -> slice | np.ndarray:
    """As a slice where it can be one."""
    first, last = (numbers[0], numbers[-1] + 1) if len(numbers) else (0, 0)
    return slice(first, last) if last - first == len(numbers) else numbers
