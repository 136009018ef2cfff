"""What answers to unit loads, on coordinates, along pieces, or where an output is read, and to unit displacements of
driven ends, at complex frequencies.

Of a force or a shear that is read at a place the load that goes with it is a dislocation there (Betti): a step of u, or
of u′, by 1, as the left part moves with the stiffness d₁ of its end and the right part with d₂

    F = −e d₁ (d₁ + d₂)⁻¹ d₂ e

but for what is infinite there at each s alike.
"""

from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.divided_pieces import divided_at
from vibcli.analyses.continuous.spread_overlaps import OnPiece, UnitLoadsOfChannels
from vibcli.analyses.continuous.uncounted_modes import inverse_where_massive
from vibcli.analyses.excitation.linear_output import LinearOutput
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.stiffness import stiffness

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.exact_transfer import DrivenEnd, ExactTransfer
    from vibcli.analyses.excitation.linear_output import FieldPoint
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.numerics.pieces.piece import Piece

INSIDE = 1e-12      # of a length


class UnitAnswers(NamedTuple):
    """At places s (m,): how coordinates move under each unit load, (n, slots, m); how each acts on coordinates, (slots,
    n), and on pieces {number: OnPiece}; driven: (slot, number of a piece, end) of those that are displacements."""

    s: np.ndarray
    moved: np.ndarray
    acted: np.ndarray
    on: dict[int, OnPiece]
    driven: "tuple[tuple[int, int, int], ...]" = ()

    def ends(self, number: int, one: "PlacedPiece") -> np.ndarray:
        """End values of a piece, (order, slots, m)."""
        none = np.zeros(self.moved.shape[1:], complex)
        found = np.array([sum((x * self.moved[i] for i, x in row.items()), none) for row in one.rows])
        for slot, piece, end in self.driven:
            found[end, slot] += 1.0 if piece == number else 0.0
        return found

    def shown_on(self, number: int, one: "PlacedPiece", load: OnPiece) -> np.ndarray:
        """What each load on a piece shows of each motion of it, (slots, slots, m)."""
        return cast("np.ndarray", np.einsum("aom,obm->abm", load.ends, self.ends(number, one)) + load.held)

    def shown(self, pieces: "Sequence[PlacedPiece]") -> np.ndarray:
        """What each load, and each driven end, shows of each motion."""
        found = np.einsum("an,nbm->abm", self.acted, self.moved)
        for slot, *_ in self.driven:
            found[slot, slot] += 1.0
        return sum((self.shown_on(number, pieces[number], load) for number, load in self.on.items()), found)

    def acting(self, pieces: "Sequence[PlacedPiece]") -> np.ndarray:
        """What acts in each motion: its unit load, or the forces at driven ends, (slots, slots, m)."""
        found = np.repeat(np.eye(self.moved.shape[1], dtype=complex)[:, :, None], len(self.s), axis=2)
        for slot, number, end in self.driven:
            one = pieces[number]
            d, load = stiffness(one.piece, one.piece.reaction(self.s)), self.on.get(number)
            force = np.einsum("mk,kbm->bm", d[:, end], self.ends(number, one))
            found[:, slot] = force if load is None else force - load.ends[:, end]
        return found


class UnitLoadsOf:
    """Of an ExactTransfer."""

    def __init__(self, transfer: "ExactTransfer") -> None:
        self.transfer, self.n, self._channels = transfer, transfer.n, UnitLoadsOfChannels(transfer)
        self.inverse = inverse_where_massive(transfer.matrix.polynomial[2])

    @property
    def driven(self) -> "dict[int, DrivenEnd]":
        """{channel: DrivenEnd}"""
        return self._channels.driven

    def takes(self, channel: int) -> bool:
        """Is it one on coordinates, a driven end, or one along pieces of one tension each?"""
        return self._channels.takes(channel)

    def massive(self, channels: "Sequence[int]") -> np.ndarray:
        """bᵀ M⁻¹ b of all pairs, 0 of what does not act on mass alone."""
        return self._channels.massive(channels, self.inverse)

    def forms(self, channels: "Sequence[int]", number: int) -> list[tuple[int, Any]]:
        """[(slot, LoadForm)] of those along a piece."""
        return self._channels.on(channels, self.transfer.pieces[number])

    def of_channels(self, channels: "Sequence[int]", s: np.ndarray) -> UnitAnswers:
        """Of unit loads on channels, or unit displacements of driven ends."""
        moved = [self.transfer.at(LinearOutput(q={i: 1.0}), s)[list(channels)] for i in range(self.n)]
        acted = np.array([np.eye(self.n)[c] if c < self.n else np.zeros(self.n) for c in channels])
        driven = tuple((slot, *self.driven[c]) for slot, c in enumerate(channels) if c in self.driven)
        return UnitAnswers(s, np.array(moved).reshape(self.n, len(channels), len(s)), acted.reshape(-1, self.n),
                           self._channels.on_pieces(channels, s), driven)

    def of_output(self, output: LinearOutput, s: np.ndarray) -> UnitAnswers:
        """Of the one that goes with displacements of coordinates, or with what is read at one place."""
        row = np.array([output.q.get(i, 0.0) for i in range(self.n)])
        on = {place.piece: self._at(place, factor, s) for place, factor in output.places.items()}
        return UnitAnswers(s, self.transfer.at(output, s)[:self.n, None], row[None], on)

    def _at(self, place: "FieldPoint", factor: float, s: np.ndarray) -> OnPiece:
        """What it puts on the ends of a piece, and what it shows of itself while these rest."""
        piece = self.transfer.pieces[place.piece].piece
        kappa, units = piece.reaction(s), np.eye(piece.order)
        bent = [fields(piece, kappa, np.tile(unit, (len(s), 1)), np.full(len(s), place.x))[..., place.along]
                for unit in units]
        return OnPiece(factor * np.array(bent)[None], factor**2 * self._held(place, kappa)[None, None])

    def _held(self, place: "FieldPoint", kappa: np.ndarray) -> np.ndarray:
        one = self.transfer.pieces[place.piece]
        half, (p, e) = one.piece.order // 2, _load(one.piece, place)
        if not INSIDE * one.piece.length < place.x < (1 - INSIDE) * one.piece.length:
            end = half * (place.x > one.piece.length / 2)
            return cast("np.ndarray", -e @ stiffness(one.piece, kappa)[:, end:end + half, end:end + half] @ e)
        left, right = (stiffness(part.piece, kappa) for part in divided_at(one, place.x, self.n))
        left, right = left[:, half:, half:], right[:, :half, :half]
        moved = np.linalg.solve(left + right, (p - right @ e)[..., None])[..., 0]
        return cast("np.ndarray", moved @ p + np.einsum("a,sab,sb->s", e, left, moved))


def _load(piece: "Piece", place: "FieldPoint") -> tuple[np.ndarray, np.ndarray]:
    """(forces, dislocations) of a node at a place that go with what is read there, of u and u′: of u u itself, of
    u″ = F′/B, u‴ = (N u′ − F)/B, of what does not bend u′ = F/N."""
    half, along = piece.order // 2, place.along
    p, e, tension = np.zeros(half), np.zeros(half), piece.tension + piece.gradient * place.x
    if along < half:
        p[along] = 1.0
    elif half == 1:
        e[0] = 1 / tension
    elif along == 2:
        e[1] = 1 / piece.bending
    else:
        p[1], e[0] = tension / piece.bending, -1 / piece.bending
    return p, e
