"""Pieces along which drag acts: what their ends tell of ∫ w u dx of vibrations, of modes and of what loads do."""

from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.damped_energies import ROUNDED
from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
from vibcli.numerics.pieces.stiffness import stiffness, stiffness_and_slope

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.analyses.continuous.complex_modes import DampedBasis
    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.analyses.continuous.mode_basis import ModeBasis
    from vibcli.analyses.continuous.unit_answers import UnitAnswers
    from vibcli.numerics.pieces.piece import Piece

NONE = 2.0**-50     # of a drag: what is none
MOST = 4            # end values of a piece
NEAR = 1e-3         # of a turn: how far a nearly real κ is from real


class DraggedPieces:
    """Those of an ExactTransfer whose drag exceeds 2 δ μ; drags: [(c − 2 δ μ, μ)]."""

    def __init__(self, transfer: "ExactTransfer", fading: float) -> None:
        left = [(p, one.piece.drag - 2 * fading * one.piece.inertia) for p, one in enumerate(transfer.pieces)]
        self.numbers = [p for p, c in left if c > NONE * transfer.pieces[p].piece.drag]
        self.pieces = [transfer.pieces[p] for p in self.numbers]
        self.drags = [(float(dict(left)[p]), float(transfer.pieces[p].piece.inertia)) for p in self.numbers]

    def of_answers(self, answers: "UnitAnswers") -> tuple[np.ndarray, np.ndarray]:
        """(along, sizes) of DampedSwings, (places and slots, 2, pieces, ends)."""
        slots, m = answers.moved.shape[1:]
        found, sizes = self._empty(m * slots, slots, complex), self._empty(m * slots, slots, float)
        for p, (number, one) in enumerate(zip(self.numbers, self.pieces, strict=True)):
            e = answers.ends(number, one).T
            d, load = stiffness(one.piece, one.piece.reaction(answers.s)), answers.on.get(number)
            F, F_size = (np.einsum("mab,mkb->mka", part, ends) for part, ends in ((d, e), (np.abs(d), np.abs(e))))
            acts, shown = np.zeros((slots, slots)), np.zeros((m, slots, slots), complex)
            if load is not None:
                put = np.moveaxis(load.ends, -1, 0)
                F, F_size = F - put, F_size + np.abs(put)
                acts[range(slots), range(slots)] = load.ends.any(axis=(1, 2))
                shown = np.swapaxes(np.moveaxis(answers.shown_on(number, one, load), -1, 0), 1, 2)
            flat = [part.reshape(m * slots, -1) for part in (e, F, F_size, shown, np.tile(acts, (m, 1)))]
            _fill(found, sizes, p, *flat)
        return found, sizes

    def ends_of_modes(self, basis: "DampedBasis", modes: np.ndarray) -> list[tuple[np.ndarray, ...]]:
        """Of each piece: end values of modes, the forces that these need, and the sizes of both, (modes, order)."""
        found = []
        for number, one in zip(self.numbers, self.pieces, strict=True):
            rows, half = [], one.piece.order // 2
            for end, row in enumerate(one.rows):
                e = sum((x * basis.shapes[i, modes] for i, x in row.items()), np.zeros(len(modes), complex))
                F, x = basis.end_forces(number, end)[modes], one.piece.length * (end >= half)
                rows.append((e, F, np.abs(e) + _lost(basis, number, x, {end % half: 1.0})[modes],
                             np.abs(F) + _lost(basis, number, x, _force(one.piece, x, end % half))[modes]))
            found.append(tuple(np.array(part).T for part in zip(*rows, strict=True)))
        return found

    def of_modes(self, ends: "Sequence[tuple[np.ndarray, ...]]", reads: "Mapping[int, np.ndarray]",
                 none: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(along, sizes) of modes with these ends; reads: what loads on a piece are felt by them, (modes, slots), of
        others `none`."""
        found, sizes = (self._empty(*none.shape, kind) for kind in (complex, float))
        for p, (number, (e, F, e_size, F_size)) in enumerate(zip(self.numbers, ends, strict=True)):
            _fill(found, sizes, p, e, F, F_size, reads.get(number, none), none, e_size)
        return found, sizes

    def _empty(self, n: int, slots: int, kind: Any) -> np.ndarray:
        return np.zeros((n, 2, len(self.drags), 2 * (MOST + slots)), kind)

    def squares(self, basis: "DampedBasis", modes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """∫ w² dx and ∫ |w|² dx on each piece, (modes, pieces)."""
        place = np.full(basis.shapes.shape[1], -1)
        place[modes] = np.arange(len(modes))
        plain, sizes = np.zeros((len(modes), len(self.drags)), complex), np.zeros((len(modes), len(self.drags)))
        for p, number in enumerate(self.numbers):
            for part in basis.parts[number]:
                inside = np.flatnonzero(place[part.modes] >= 0)
                if len(inside):
                    at, ends, kappa = place[part.modes[inside]], part.ends[inside], part.kappa[inside]
                    d, slope = stiffness_and_slope(part.piece, kappa)
                    plain[at, p] += np.einsum("ka,kab,kb->k", ends, slope, ends)
                    mean = _mean_slope(part.piece, kappa, d, slope, 1 + part.turns()[inside])
                    sizes[at, p] += np.einsum("ka,kab,kb->k", ends.conj(), mean, ends).real
        return plain, sizes


def _mean_slope(piece: "Piece", kappa: np.ndarray, d: np.ndarray, slope: np.ndarray, turns: np.ndarray) -> np.ndarray:
    """(d(κ) − d(κ̄))/(κ − κ̄), by Simpson's rule where κ is nearly real."""
    near = turns * np.abs(kappa.imag) < NEAR * np.abs(kappa)
    found = d.imag / np.where(near, 1.0, kappa.imag)[:, None, None]
    if near.any():
        middle = stiffness_and_slope(piece, kappa[near].real)[1]
        found[near] = (2 * slope[near].real + 4 * middle) / 6
    return found


def _fill(found: np.ndarray, sizes: np.ndarray, p: int, e: np.ndarray, F: np.ndarray, F_size: np.ndarray,
          shown: np.ndarray, acts: np.ndarray, e_size: np.ndarray | None = None) -> None:
    """What makes up eᵤᵀ F_w − e_wᵀ Fᵤ + ∫ u p_w − w pᵤ dx on the p-th piece."""
    order, slots = e.shape[1], shown.shape[1]
    for side, parts in enumerate(((F, -e, acts, -shown), (e, F, shown, acts))):
        for at, part in zip((0, MOST, 2 * MOST, 2 * MOST + slots), parts, strict=True):
            found[:, side, p, at:at + part.shape[1]] = part
    sizes[:, :, p] = np.abs(found[:, :, p])
    sizes[:, 0, p, :order] = sizes[:, 1, p, MOST:MOST + order] = F_size
    if e_size is not None:
        sizes[:, 1, p, :order] = sizes[:, 0, p, MOST:MOST + order] = e_size


def _force(piece: "Piece", x: float, turned: bool) -> dict[int, float]:
    """{derivative: factor} that make up the size of a force on an end."""
    tension = abs(piece.tension + piece.gradient * x)
    if piece.order == 2:
        return {1: tension}
    return {2: piece.bending} if turned else {1: tension, 3: piece.bending}


def _lost(basis: "ModeBasis", number: int, x: float, factors: "Mapping[int, float]") -> np.ndarray:
    """What they are rounded from in each mode."""
    read = LinearOutput(places={FieldPoint(number, x, along): factor for along, factor in factors.items()})
    return cast("np.ndarray", basis.lost(read)[0] / ROUNDED)
