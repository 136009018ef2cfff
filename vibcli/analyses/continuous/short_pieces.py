"""Coordinates for pieces of beams that are short beside the others of their member: how the right end leaves the line
that the left end points along. With q = T p a piece of length l then has the rows

    u₀, θ₀, w, ψ      u_l = u₀ + θ₀ l + w,   θ_l = θ₀ + ψ      w and ψ in the places of u_l and θ_l among p,

and D(s), congruent to what it was and with the same determinant, holds 12 EI/l³ beside w alone. Where the right end is
held, its left end leaves the line of the right one, w = −w′ − l ψ′, ψ = −ψ′; where nothing moves it as a rigid body the
coordinates stay as they are.

What bends it as a cantilever, F and P, is what all else leaves: R x = (w, ψ), Rᵀ (F, P) = f − D₀ p, D₀ without that.
"""

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.pieces.relative import SHORT, cantilever

if TYPE_CHECKING:
    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.numerics.pieces.piece import Piece

PART = 1 / 16       # of the longest piece of a member: what is shorter is short


class RelativeCoordinates(NamedTuple):
    """rows: {coordinate of q: its row over p}, where they differ; short: {number of a piece: the rows of u₀, θ₀, w, ψ};
    ends: the rows of the end values of all pieces, over p."""

    rows: Mapping[int, dict[int, Any]]
    short: Mapping[int, tuple[Any, ...]]
    ends: Sequence[tuple[Any, ...]]

    def row(self, row: Mapping[int, float]) -> dict[int, float]:
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

    def bends(self, pieces: "Sequence[PlacedPiece]", p: np.ndarray, left: np.ndarray) -> dict[int, np.ndarray]:
        """{number of a short piece: u₀, θ₀, F, P (…, 4)} of what moves by p, (…, n); left: f − D₀ p."""
        return {number: _bends(pieces[number].piece, rows, p, left, self._alone(number))
                for number, rows in self.short.items()}

    def _alone(self, number: int) -> list[int]:
        """The coordinates of w and ψ of a piece; none where they bend others too."""
        own, others = ({i for rows in parts for row in rows[2:] for i in row} for parts in (
            [self.short[number]], [rows for k, rows in self.short.items() if k != number]))
        return sorted(own) if own.isdisjoint(others) else []


def bends(matrix: "DynamicMatrix", p: np.ndarray, s: np.ndarray,
          loads: np.ndarray | float = 0.0) -> dict[int, np.ndarray]:
    """u₀, θ₀, F, P of short pieces, {number of a piece: (…, N, 4)}, where D(s) p = loads, p: (…, N, n)."""
    if matrix.relative is None or not matrix.relative.short:
        return {}
    left = loads - np.einsum("ijs,...sj->...si", matrix.at(s, loaded=False, bent=False).D, p)
    found = matrix.relative.bends(matrix.pieces, p, left)
    for number, own in found.items():
        own[..., 2:] /= (1 + float(matrix.pieces[number].retardation) * s)[:, None]
    return found


def _bends(piece: "Piece", rows: tuple[dict[int, float], dict[int, float], dict[int, float], dict[int, float]],
           p: np.ndarray, left: np.ndarray, alone: list[int]) -> np.ndarray:
    u, turn, w, psi = (sum((x * p[..., i] for i, x in row.items()), 0 * p[..., :1].sum(axis=-1)) for row in rows)
    S = cantilever(piece)
    if alone:
        R = np.array([[row.get(i, 0.0) for i in alone] for row in rows[2:]])
        of_left = np.linalg.inv(R).T if len(alone) == 2 else S @ R / (R.T @ S @ R)      # Rᵀ S R is scaled too badly
        F, P = np.moveaxis(left[..., alone] @ of_left.T, -1, 0)
    else:
        F, P = (a * w + b * psi for a, b in S)
    return np.stack([u, turn, F, P], axis=-1)


def relative_coordinates(pieces: "Sequence[PlacedPiece]", kept: Collection[int] = ()) -> RelativeCoordinates:
    """Those of all pieces that are short and of which an end moves freely, or none of both as a rigid body; kept:
    coordinates that stay as they are."""
    numbers = list(_short(pieces))
    rows: dict[int, dict[int, Any]] = {}
    own: dict[int, tuple[Any, ...]] = {}
    for mirrored in (True, False):
        for number in reversed(numbers) if mirrored else numbers:
            found = None if number in own else _turned(pieces[number], mirrored, kept, rows)
            if found is not None:
                new, own[number] = found
                rows = {at: _over(new, row) for at, row in rows.items()} | new
    ends = [tuple(_over(rows, row) for row in placed.rows) for placed in pieces]
    short = {number: (*ends[number][:2], *own[number]) for number in own}
    for number in numbers:
        if number not in own and _stays(ends[number]):
            u, turn, end, last = ends[number]
            line = _sum(u, turn, float(pieces[number].piece.length))
            short[number] = u, turn, _sum(end, line, -1.0), _sum(last, turn, -1.0)
    return RelativeCoordinates(rows, short, ends)


def _turned(placed: "PlacedPiece", mirrored: bool, kept: "Collection[int]", rows: dict[int, dict[int, float]]
            ) -> "tuple[dict[int, dict[int, float]], tuple[dict[int, Any], ...]] | None":
    """({coordinate of the end that moves freely: its row over p}, the rows of w and ψ over p): of the right end, or
    mirrored of the left one where the right one does not move so."""
    left, right = placed.rows[:2], placed.rows[2:]
    if mirrored and _freely(right, kept, rows):
        return None
    base, moving = (right, left) if mirrored else (left, right)
    if not _freely(moving, kept, rows):
        return None
    (i, j), length = (next(iter(row)) for row in moving), float(placed.piece.length)
    u, turn = (_over(rows, row) for row in base)
    if {i, j} & {*u, *turn}:
        return None
    line = _sum(u, turn, -length if mirrored else length)
    own = ({i: -1.0, j: -length}, {j: -1.0}) if mirrored else ({i: 1.0}, {j: 1.0})
    return {i: _sum({i: 1.0}, line, 1.0), j: _sum({j: 1.0}, turn, 1.0)}, own


def _freely(end: tuple[dict[int, Any], ...], kept: Collection[int],
            rows: Mapping[int, dict[int, float]]) -> bool:
    """Has an end coordinates of its own, which are what they were?"""
    places = [i for row in end for i in row]
    return (len(set(places)) == 2 and all([*row.values()] == [1] for row in end)
            and not any(i in kept or i in rows for i in places))


def _stays(ends: Sequence[Mapping[int, Any]]) -> bool:
    """Does no motion of a piece as a rigid body go with end values that move by themselves? Then two do at most."""
    places = [i for row in ends for i in row]
    both = ends[0] and ends[2]
    return all(len(row) < 2 for row in ends) and len(places) == len(set(places)) < 3 and not both


def _short(pieces: "Sequence[PlacedPiece]") -> Iterator[int]:
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


def _sum(row: Mapping[int, float], other: Mapping[int, float], factor: float) -> dict[int, float]:
    found = dict(row)
    for i, x in other.items():
        found[i] = found.get(i, 0.0) + factor * x
    return found


def _over(rows: Mapping[int, dict[int, float]], row: Mapping[int, float]) -> dict[int, float]:
    """A row over q as one over p, given where they differ."""
    found: dict[int, float] = {}
    for i, x in row.items():
        for j, y in rows.get(i, {i: 1.0}).items():
            found[j] = found.get(j, 0.0) + float(x) * y
    return {j: x for j, x in found.items() if x}
