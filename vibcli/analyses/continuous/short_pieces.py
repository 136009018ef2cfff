"""Coordinates for pieces of beams that are short beside the others of their member: how the right end leaves the line
that the left end points along. With q = T p a piece of length l then has the rows

    u₀, θ₀, w, ψ      u_l = u₀ + θ₀ l + w,   θ_l = θ₀ + ψ      w and ψ in the places of u_l and θ_l among p,

and D(s), congruent to what it was and with the same determinant, holds 12 EI/l³ beside w alone.
"""

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.relative import SHORT

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import PlacedPiece

PART = 1 / 16       # of the longest piece of a member: what is shorter is short


class RelativeCoordinates(NamedTuple):
    """rows: {coordinate of q: its row over p}, where they differ; short: {number of a piece: the rows of u₀, θ₀, w, ψ};
    ends: the rows of the end values of all pieces, over p."""

    rows: Mapping[int, dict]
    short: Mapping[int, tuple]
    ends: Sequence[tuple]

    def row(self, row: Mapping[int, float]) -> dict:
        """A row over q as one over p."""
        return _over(self.rows, row)

    def matrix(self, n: int) -> np.ndarray:
        """T."""
        found = np.eye(n)
        for i, row in self.rows.items():
            found[i] = 0.0
            for j, x in row.items():
                found[i, j] = x
        return found


def relative_coordinates(pieces: "Sequence[PlacedPiece]", kept: Collection[int] = ()) -> RelativeCoordinates:
    """Those of all pieces that are short and whose right ends move freely; kept: coordinates that stay as they are."""
    rows: dict[int, dict] = {}
    short = {}
    for number in _short(pieces):
        placed = pieces[number]
        own = [next(iter(row.items())) if len(row) == 1 else (-1, 0.0) for row in placed.rows[2:]]
        (i, _), (j, _) = own
        if i == j or any(at < 0 or at in kept or at in rows or x != 1 for at, x in own):
            continue
        left = [_over(rows, row) for row in placed.rows[:2]]
        if any(at in row for row in left for at in (i, j)):
            continue
        line = _sum(left[0], left[1], float(placed.piece.length))
        new = {i: _sum({i: 1.0}, line, 1.0), j: _sum({j: 1.0}, left[1], 1.0)}
        rows = {at: _over(new, row) for at, row in rows.items()} | new
        short[number] = placed.rows[:2]
    ends = [tuple(_over(rows, row) for row in placed.rows) for placed in pieces]
    return RelativeCoordinates(rows, {number: (*(_over(rows, row) for row in left), *(
        {next(iter(row)): 1.0} for row in pieces[number].rows[2:])) for number, left in short.items()}, ends)


def _short(pieces):
    """The numbers of short pieces."""
    longest: dict[str, float] = {}
    for placed in pieces:
        longest[placed.owner] = max(longest.get(placed.owner, 0.0), float(placed.piece.length))
    for number, placed in enumerate(pieces):
        length, piece = float(placed.piece.length), placed.piece
        if piece.order == 4 and length < PART * longest[placed.owner]:
            force = (abs(float(piece.tension)) + abs(float(piece.gradient)) * length) * length**2
            if force <= SHORT * float(piece.bending):
                yield number


def _sum(row, other, factor):
    found = dict(row)
    for i, x in other.items():
        found[i] = found.get(i, 0.0) + factor * x
    return found


def _over(rows, row):
    """A row over q as one over p, given where they differ."""
    found: dict[int, float] = {}
    for i, x in row.items():
        for j, y in rows.get(i, {i: 1.0}).items():
            found[j] = found.get(j, 0.0) + float(x) * y
    return {j: x for j, x in found.items() if x}
