"""What outputs of a scene with members answer to its loads at complex frequencies, exactly: no modes.

    y = Σ row · x,      D(s) x = f,      within a piece the field of its end values
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix
from vibcli.analyses.continuous.short_pieces import bends
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.relative import relative_fields, told
from vibcli.numerics.pieces.stiffness import stiffness

if TYPE_CHECKING:
    from vibcli.analyses.continuous.spread_drives import SpreadDrive
    from vibcli.analyses.excitation.linear_output import FieldPoint, LinearOutput
    from vibcli.mechanics.factored_system import PlacedPiece


KEPT = 8                # sets of complex frequencies whose motions are remembered


class DrivenEnd(NamedTuple):
    """An end value of a piece that a channel of the loads moves, beside the coordinates."""

    piece: int
    end: int


class ExactTransfer:
    """H(s) of a system: polynomial: K, C, M (3, n, n) without pieces; pieces: PlacedPieces in floats; driven:
    DrivenEnds, spread: SpreadDrives, the channels behind those of the n coordinates."""

    def __init__(self, polynomial: np.ndarray, pieces: "Sequence[PlacedPiece]", driven: Sequence[DrivenEnd],
                 spread: "Sequence[SpreadDrive]" = ()) -> None:
        self.matrix, self.pieces, self.driven = DynamicMatrix(polynomial, pieces), list(pieces), list(driven)
        self._near = DynamicMatrix(polynomial, pieces, kept=())
        self.n, self.spread = polynomial.shape[-1], list(spread)
        self._known: dict[bytes, tuple[Any, ...]] = {}

    @property
    def channels(self) -> int:
        """How many there are."""
        return cast("int", self.n + len(self.driven) + len(self.spread))

    def at(self, output: "LinearOutput", s: np.ndarray) -> np.ndarray:
        """(channels, number of s): the output, its constant and channels left out, for a unit e^{st} on each."""
        p, bent = self._kept(s)
        x = np.tensordot(self._near.to_scene, p, 1)
        found = np.zeros(x.shape[1:], complex)
        for power, part in enumerate((output.q, output.v, output.a)):
            for i, factor in part.items():
                found += factor * s**power * x[i]
        for place, factor in output.places.items():
            one = self.pieces[place.piece]
            ends = np.stack([sum((v * x[i] for i, v in row.items()), np.zeros(x.shape[1:], complex))
                             for row in one.rows], axis=-1)
            for channel, drive in enumerate(self.driven, self.n):
                if drive.piece == place.piece:
                    ends[channel, :, drive.end] += 1.0
            values = self._field(place, s, bent.get(place.piece), ends)[..., place.along]
            for channel, spread in enumerate(self.spread, self.n + len(self.driven)):
                values[channel] += spread.between(one, s, place.x, place.along)
            found += factor * s**place.rates * values
        return found

    def _field(self, place: "FieldPoint", s: np.ndarray, bent: np.ndarray | None, ends: np.ndarray) -> np.ndarray:
        """u and its derivatives at a place, (channels, number of s, order)."""
        one = self.pieces[place.piece].piece
        kappa = one.reaction(s)
        found = fields(one, kappa, ends, place.x)
        if bent is None or any(drive.piece == place.piece for drive in self.driven):
            return found
        long = told(one, kappa)
        found[:, long] = relative_fields(one, kappa[long], bent[:, long], np.full(kappa[long].shape, place.x))
        return found

    def _kept(self, s: np.ndarray) -> tuple[np.ndarray, dict[int, np.ndarray]]:
        """What moves does not hang on what is read: the last of them."""
        asked = s.tobytes()
        if asked not in self._known:
            while len(self._known) >= KEPT:
                del self._known[next(iter(self._known))]
            self._known[asked] = self._moved(s)
        return self._known[asked]

    def _moved(self, s: np.ndarray) -> tuple[np.ndarray, dict[int, np.ndarray]]:
        """The coordinates of D, (n, channels, number of s), and u₀, θ₀, F, P of short pieces, {number: (channels,
        number of s, 4)}."""
        forces = np.zeros((len(s), self.n, self.channels), complex)
        forces[:, range(self.n), range(self.n)] = 1.0
        for channel, drive in enumerate(self.driven, self.n):
            one = self.pieces[drive.piece]
            column = stiffness(one.piece, one.piece.reaction(s))[..., drive.end]
            for a, row in enumerate(one.rows):
                for i, v in row.items():
                    forces[:, i, channel] -= v * column[:, a]
        for channel, spread in enumerate(self.spread, self.n + len(self.driven)):
            forces[:, :, channel] = spread.put(self.pieces, s, self.n)
        if not self.n:
            return np.zeros((0, self.channels, len(s)), complex), {}
        D, loads = np.moveaxis(self._near.at(s).D, -1, 0), self._near.to_scene.T @ forces
        p = np.linalg.solve(D, loads)
        return np.moveaxis(p, 0, -1), bends(self._near, np.moveaxis(p, -1, 0), s, np.moveaxis(loads, -1, 0))

    def at_rest(self, q: np.ndarray) -> np.ndarray:
        """The forces that hold coordinates q at rest: D(0) q."""
        return cast("np.ndarray", self.matrix.at(np.zeros(1)).D[:, :, 0].real @ q)
