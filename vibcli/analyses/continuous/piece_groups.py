"""Pieces of one kind of equation, evaluated together at many frequencies and added where they belong."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.relative import in_relative_motions
from vibcli.numerics.pieces.stiffness import stiffness_and_slope

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.numerics.sparse_elimination import Pattern


class PieceGroup:
    """pieces: PlacedPieces of one order, with or without tension and gradient as one; equal ones are evaluated once.
    short: their rows are those of u₀, θ₀, w, ψ."""

    __slots__ = ("_ends", "_entries", "_factors", "_same", "_sources", "_starts", "pieces", "short", "stacked")

    def __init__(self, pattern: "Pattern", pieces: "Sequence[PlacedPiece]", digits: int | None,
                 short: bool = False) -> None:
        self.pieces, self.short = list(pieces), short
        kind: Any = float if digits is None else object
        self._same, distinct = _distinct(placed.piece for placed in pieces)
        self.stacked, count = stacked(distinct, kind), len(distinct)
        self._ends = pieces[0].piece.order
        parts = [(a, b) for a in range(self._ends) for b in range(a, self._ends)]
        share: dict[Any, Any] = defaultdict(lambda: defaultdict(int))
        for place, placed in enumerate(self.pieces):
            for at, (a, b) in enumerate(parts):
                source = at * count + self._same[place]
                for i, x in placed.rows[a].items():
                    for j, y in placed.rows[b].items():
                        if (a == b and i > j) or not (x and y):
                            continue
                        entry = pattern.places[min(i, j), max(i, j)]
                        share[entry][source] += x * y * (2 if a != b and i == j else 1)
        self._entries = np.array(sorted(share), int)
        self._starts = np.cumsum([0, *(len(share[entry]) for entry in self._entries)])[:-1].astype(int)
        self._sources = np.array([source for entry in self._entries for source in share[entry]], int)
        self._factors = np.array([[x] for entry in self._entries for x in share[entry].values()], kind)

    def add(self, z: np.ndarray, found: np.ndarray, sizes: np.ndarray, slope: np.ndarray, bent: bool = True) -> None:
        """Adds Sᵀ d S to `found`, the magnitudes of its terms to `sizes`, Sᵀ ∂d/∂s² S to `slope`, for each z; not
        `bent`: without what bends short pieces as cantilevers."""
        if not len(self._entries):
            return
        kappa = self.stacked.foundation - self.stacked.inertia * z
        d, d_slope = stiffness_and_slope(self.stacked, kappa)
        if self.short:
            d, d_slope = in_relative_motions(self.stacked, kappa, d, d_slope, bent)
        terms = self._terms(d)
        found[self._entries] += np.add.reduceat(terms, self._starts, axis=0)
        sizes[self._entries] += np.add.reduceat(abs(terms), self._starts, axis=0)
        terms = self._terms(d_slope * self.stacked.inertia[:, :, None, None])
        slope[self._entries] += np.add.reduceat(terms, self._starts, axis=0)

    def held(self, z: np.ndarray) -> np.ndarray:
        """J₀ of each piece, (pieces, number of z)."""
        return held_counts(self.stacked, z)[self._same]

    def _terms(self, d: np.ndarray) -> np.ndarray:
        """The upper triangle of d for all pieces, (triangle × pieces, number of z), as it enters entry by entry."""
        flat = np.concatenate([d[..., a, b] for a in range(self._ends) for b in range(a, self._ends)])
        return cast("np.ndarray", self._factors * flat[self._sources])


def _distinct(pieces: Iterator[Any]) -> tuple[list[int], list[Piece]]:
    """For each piece its place among those that differ, and these."""
    places: dict[Piece, int] = {}
    return [places.setdefault(piece, len(places)) for piece in pieces], list(places)


def stacked(pieces: Sequence[Piece], kind: Any) -> Piece:
    """Pieces as one, whose coefficients are columns."""
    return Piece(*(np.array([[getattr(piece, name)] for piece in pieces], kind) for name in Piece._fields))


def held_by(pieces: Sequence[Piece], z: Any) -> np.ndarray:
    """J₀ of pieces of one kind at each z, (pieces, number of z), in floats."""
    return held_counts(stacked(pieces, float), np.array(z, float))


def held_counts(piece: Piece, z: np.ndarray) -> np.ndarray:
    """J₀ at each z."""
    from vibcli.numerics.pieces.held_count import held_count

    return held_count(piece._replace(foundation=piece.foundation - piece.inertia * z), 0)
