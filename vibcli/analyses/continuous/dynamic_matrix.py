"""The dynamic stiffness of bodies, springs, dampers and members at many complex frequencies at a time:

    D(s) = K + s (C + G) + s² M + Σ (1 + β s) Sᵀ d(κ) S,     κ = k + (μ s² + c s)/(1 + β s),        D′ = dD/ds

A load f(x) along members that is an input has the column −Σ Sᵀ ∫ f H dx, H the fields of the end values. d has poles
where a piece vibrates with its ends held, and D is too large near these to hold what else is in it. The motion is not:
there pieces are divided by a node that is free to move.
"""

from collections import defaultdict
from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.divided_pieces import divided_at
from vibcli.analyses.continuous.leaving_waves import impedances, leaving, without_leaving
from vibcli.analyses.continuous.short_pieces import relative_coordinates
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.relative import in_relative_motions
from vibcli.numerics.pieces.retardation import reaction_rate, retarded_reaction
from vibcli.numerics.pieces.stiffness import stiffness, stiffness_and_slope

if TYPE_CHECKING:
    from collections.abc import Collection, Mapping, Sequence

    from vibcli.analyses.continuous.spread_drives import SpreadDrive
    from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece

SHARES = (3 - 5**0.5) / 2, 0.5, 1 - 0.5**0.5     # of a piece at which it is divided, as tried: no mode has nodes at all
BLOWN = 32.0        # times its natural size: where a piece is as large, it is near a frequency with its ends held


class PieceStack:
    """Pieces of one differential equation, evaluated together: their coefficients as columns; ends[p]: the rows
    {coordinate: component} of the end values of piece p, of short ones of u₀, θ₀, w, ψ; shares[p]: (i, j, a, b, share
    of d[a, b] in D[i, j]) of it; numbers[p]: its place among all pieces; beta: retardations."""

    __slots__ = ("beta", "ends", "numbers", "piece", "retarded", "shares", "short")

    def __init__(self, placed: "Sequence[PlacedPiece]", numbers: "Sequence[int]",
                 ends: "Sequence[tuple[dict[int, float], ...]]", short: bool) -> None:
        self.ends, self.numbers, self.short = list(ends), list(numbers), short
        self.shares = [[(i, j, a, b, float(x * y)) for a, row in enumerate(rows) for b, other in enumerate(rows)
                        for i, x in row.items() for j, y in other.items()] for rows in self.ends]
        self.piece = Piece(*(np.array([[float(getattr(one.piece, name))] for one in placed]) for name in Piece._fields))
        self.beta = np.array([[float(one.retardation)] for one in placed])
        self.retarded = bool(self.beta.any())

    def stiffness(self, s: np.ndarray, steep: bool, bent: bool = True) -> tuple[np.ndarray, np.ndarray | None]:
        """(d, dd/ds if it is `steep`), each (m, m, pieces, N); real where s is imaginary and nothing drags; not `bent`:
        without what bends short pieces as cantilevers."""
        piece, factor = self.piece, (1 + self.beta * s) if self.retarded else 1.0
        kappa = retarded_reaction(piece, s, self.beta)
        if not steep and not self.short:
            return stiffness(piece, kappa).transpose(2, 3, 0, 1) * factor, None
        found = stiffness_and_slope(piece, kappa)
        found = in_relative_motions(piece, kappa, *found, bent) if self.short else found
        d, slope = (part.transpose(2, 3, 0, 1) for part in found)
        slope = slope * reaction_rate(piece, s, self.beta) * factor if steep else None
        return d * factor, slope + self.beta * d if steep and self.retarded else slope

    def excess(self, d: np.ndarray, s: np.ndarray) -> np.ndarray:
        """How many times larger d is than a wave of its length would make it, the most of all pieces: (N,)."""
        piece = self.piece
        kappa, force = np.abs(retarded_reaction(piece, s, self.beta)), np.abs(piece.tension)
        waves = piece.bending**0.25 * np.sqrt(kappa * np.sqrt(kappa))       # κ^¾
        natural = 12 * piece.bending / piece.length**3 + waves + force / piece.length + np.sqrt(force * kappa)
        return cast("np.ndarray", (np.abs(d[0, 0]) / (natural * np.abs(1 + self.beta * s))).max(axis=0))


class DynamicMatrix:
    """polynomial: K, C + G, M, (3, n, n), without what pieces are at rest; pieces: PlacedPieces; spread: {coordinate of
    an input: SpreadDrive}; kept: where it is given, D is over the `relative` coordinates of short pieces, but for these
    coordinates, and so are polynomial and the rows of pieces then."""

    def __init__(self, polynomial: np.ndarray, pieces: "Sequence[PlacedPiece]",
                 spread: "Mapping[int, SpreadDrive] | None" = None, kept: "Collection[int] | None" = None) -> None:
        self.n, self.spread, self.kept, self._given = polynomial.shape[-1], spread or {}, kept, (polynomial, pieces)
        self.relative = relative_coordinates(pieces, kept) if kept is not None else None
        short = self.relative.short if self.relative is not None else {}
        if self.relative is not None and short:
            T = self.relative.matrix(self.n)
            polynomial = T.T @ polynomial @ T
            pieces = [placed._replace(rows=ends) for placed, ends in zip(pieces, self.relative.ends, strict=True)]
        self.polynomial, self.pieces = polynomial, list(pieces)
        alike = defaultdict(list)
        for number, placed in enumerate(self.pieces):
            piece = placed.piece
            alike[piece.order, bool(piece.tension), bool(piece.gradient), number in short].append(number)
        self.stacks = [PieceStack([self.pieces[k] for k in numbers], numbers,
                                  [short.get(k, self.pieces[k].rows) for k in numbers], kind[-1])
                       for kind, numbers in alike.items()]
        self.impedances = [impedances(stack.piece, stack.beta) for stack in self.stacks]

    @cached_property
    def damping_left(self) -> np.ndarray:
        """C + G without the dampers √(Nμ) that waves feel that leave their pieces, (n, n)."""
        return without_leaving(self.polynomial[1], [
            (float(stack.piece.tension[p, 0]), float(stack.piece.inertia[p, 0]), rows)
            for stack, Z in zip(self.stacks, self.impedances, strict=True)
            for p, rows in enumerate(stack.ends) if Z[p, 0]])

    def leaves(self, s: np.ndarray) -> np.ndarray:
        """Where D is added from what differs from leaving waves: (N,)."""
        return s.real < 0 if any(Z.any() for Z in self.impedances) and not self.retardation else np.zeros(len(s), bool)

    @property
    def undamped(self) -> bool:
        """Is D a real function of s²?"""
        return self.conservative and not self.polynomial[1].any()

    @property
    def conservative(self) -> bool:
        """Does nothing damp, though gyroscopic terms may act?"""
        return bool((self.polynomial[1] == -self.polynomial[1].T).all()) and not any(
            stack.piece.drag.any() or stack.retarded for stack in self.stacks)

    @property
    def retardation(self) -> float:
        """β with which all stiffness resists rates, (1 + β s) of it; 0 where it does not."""
        return max((float(stack.beta.max()) for stack in self.stacks), default=0.0)

    def divided(self, share: float) -> "DynamicMatrix":
        """The same with a free node within each piece."""
        polynomial, whole = self._given
        pieces, n = [], self.n
        for placed in whole:
            parts = divided_at(placed, share * placed.piece.length, n)
            pieces += parts
            n += placed.piece.order // 2
        return DynamicMatrix(_padded(polynomial, n), pieces, self.spread, self.kept)

    def without_damping(self) -> "DynamicMatrix":
        """The same without dampers and drag, gyroscopic terms kept."""
        (K, C, M), pieces = self._given
        pieces = [placed._replace(piece=placed.piece._replace(drag=0.0), retardation=0) for placed in pieces]
        return DynamicMatrix(np.array([K, (C - C.T) / 2, M]), pieces, self.spread, self.kept)

    def mixed(self, other: "DynamicMatrix", share: float) -> "DynamicMatrix":
        """The same and a share of what the other has besides in K, C and M."""
        (one, pieces), (two, _) = self._given, other._given
        return DynamicMatrix(one + share * (two - one), pieces, self.spread, self.kept)

    def seen(self, row: "Mapping[int, float]") -> "Mapping[int, float]":
        """A row over the coordinates of the scene as one over those of D."""
        return row if self.relative is None or not self.relative.rows else self.relative.row(row)

    def in_scene(self, shapes: np.ndarray) -> "tuple[Sequence[PlacedPiece], np.ndarray]":
        """Pieces as they are given, and shapes (…, n) over the coordinates of D as ones over those of these."""
        return self._given[1], shapes @ self.to_scene.T

    @property
    def to_scene(self) -> np.ndarray:
        """T, q = T p of the coordinates p of D: the identity where these are those of the scene."""
        return np.eye(self.n) if self.relative is None else self.relative.matrix(self.n)

    def is_short(self, number: int) -> bool:
        """Has a piece relative coordinates?"""
        return self.relative is not None and number in self.relative.short

    def at(self, s: np.ndarray, steep: bool = False, loaded: bool = True, bent: bool = True) -> "EvaluatedMatrix":
        """D, and D′ if it is `steep`, at each s: (N,); not `loaded`: without the columns of loads along members, not
        `bent`: without what bends short pieces as cantilevers."""
        away = self.leaves(s)
        D, slope = self._polynomial(s, steep, away)
        K, C, M = (np.abs(np.diagonal(part))[:, None] for part in self.polynomial)
        lost = given = np.abs(s) * C
        if away.any():
            lost = np.where(away, np.abs(s) * np.abs(np.diagonal(self.damping_left))[:, None], lost)
        size, excess, ends = K + lost + np.abs(s) ** 2 * M, np.zeros(len(s)), []
        for stack, Z in zip(self.stacks, self.impedances, strict=True):
            d, steeper = stack.stiffness(s, steep, bent)
            D = D.astype(np.result_type(D, d), copy=False)
            excess = np.maximum(excess, stack.excess(d, s))
            ends.append((d, steeper))
            if away.any() and Z.any():
                d, steeper = _left(stack.piece, Z, s, away, d, steeper)
            for p, rows in enumerate(stack.ends):
                for a, row in enumerate(rows):
                    for i, x in row.items():
                        size[i] += float(x) ** 2 * np.abs(d[a, a, p])
                _added(D, stack.shares[p], d[:, :, p])
                if steeper is not None:
                    _added(slope, stack.shares[p], steeper[:, :, p])
        return EvaluatedMatrix(self, D, slope, size, excess, ends, self._put(D, slope, s) if loaded else {}, given)

    def _put(self, D: np.ndarray, slope: np.ndarray | None, s: np.ndarray) -> dict[Any, Any]:
        """Adds the columns of loads along members: {number of a piece: [(coordinate of an input, what it puts on the
        ends (N, m), its slope)]}."""
        found = defaultdict(list)
        for j, drive in self.spread.items():
            for number, placed in enumerate(self.pieces):
                put = drive.end_loads(placed, s)
                if put is None:
                    continue
                steeper = drive.end_loads(placed, s, True) if slope is not None else None
                found[number].append((j, put, steeper))
                for a, row in enumerate(placed.rows):
                    for i, x in row.items():
                        D[i, j] -= float(x) * put[:, a]
                        if slope is not None:
                            slope[i, j] -= float(x) * steeper[:, a]
        return found

    def _polynomial(self, s: np.ndarray, steep: bool, away: np.ndarray) -> tuple[np.ndarray, np.ndarray | None]:
        """K + s C + s² M and its slope, real where it may be: (n, n, N); away: where C is what is left of it."""
        square = s * s if s.real.any() else -s.imag**2
        n, kind = self.n, square.dtype if self.undamped else complex
        D, slope = np.zeros((n, n, len(s)), kind), np.zeros((n, n, len(s)), complex) if steep else None
        left = self.damping_left if away.any() else np.zeros((n, n))
        if left.any():
            D = D.astype(complex)
        for i, j in zip(*np.nonzero(self.polynomial.any(axis=0) | (left != 0)), strict=True):
            k, c, m = self.polynomial[:, i, j].tolist()
            if away.any():
                c = np.where(away, left[i, j], c)
            D[i, j] = k + square * m if not np.count_nonzero(c) else k + s * c + square * m
            if slope is not None:
                slope[i, j] = 2 * s * m + c
        return D, slope


def _added(D: np.ndarray, shares: Iterable[tuple[int, int, int, int, float]], d: np.ndarray) -> None:
    """Adds Sᵀ d S to D."""
    for i, j, a, b, share in shares:
        D[i, j] += d[a, b] if share == 1.0 else share * d[a, b]


def _left(piece: Piece, Z: np.ndarray, s: np.ndarray, away: np.ndarray, d: np.ndarray,
          steeper: np.ndarray | None) -> tuple[np.ndarray, np.ndarray | None]:
    """d and dd/ds with √(Nμ) s added to what ends answer themselves, where waves leave."""
    with np.errstate(all="ignore"):
        own, rise = leaving(piece, np.where(Z, Z, 1.0), s)
    here = away & (Z > 0)
    d, steeper = d.astype(complex), None if steeper is None else steeper.astype(complex)
    for end in range(2):
        d[end, end] = np.where(here, own, d[end, end])
        if steeper is not None:
            steeper[end, end] = np.where(here, rise, steeper[end, end])
    return d, steeper


class EvaluatedMatrix:
    """D and D′ (n, n, N); size: of the parts that the diagonal was added from, given: of the dampers that are in these,
    or taken off, (n, N); excess: that of the pieces; ends: (d, dd/ds) of each stack; put: {number of a piece:
    [(coordinate of an input, what its load puts on the ends (N, m), the slope of that)]}."""

    __slots__ = ("D", "ends", "excess", "given", "matrix", "put", "size", "slope")

    def __init__(self, matrix: DynamicMatrix, D: np.ndarray, slope: np.ndarray | None, size: np.ndarray,
                 excess: np.ndarray, ends: "list[tuple[np.ndarray, np.ndarray | None]]", put: "Mapping[int, list[Any]]",
                 given: np.ndarray) -> None:
        self.matrix, self.D, self.slope, self.size, self.excess, self.ends = matrix, D, slope, size, excess, ends
        self.put, self.given = put, given

    def of_end(self, number: int, end: int) -> "list[tuple[int, float, np.ndarray, np.ndarray | None]]":
        """The force on an end of a piece: [(coordinate, factor, its weight (N,), the slope of that or None)]."""
        for stack, (d, slope) in zip(self.matrix.stacks, self.ends, strict=True):
            if number in stack.numbers:
                at = stack.numbers.index(number)
                shares = {end: 1.0}
                if stack.short:     # of the forces along u₀, θ₀, w, ψ
                    shares = ({0: 1.0, 2: -1.0}, {1: 1.0, 2: -float(stack.piece.length[at, 0]), 3: -1.0}, {2: 1.0},
                              {3: 1.0})[end]
                return [(i, float(x), sum(part * d[a, b, at] for a, part in shares.items()), None if slope is None else
                         sum(part * slope[a, b, at] for a, part in shares.items()))
                        for b, row in enumerate(stack.ends[at]) for i, x in row.items()]
        raise IndexError(number)


def dynamic_matrix(elements: "FactoredSystem", pieces: "Sequence[PlacedPiece] | None" = None, n: int | None = None,
                   spread: "Mapping[int, SpreadDrive] | None" = None,
                   kept: "Collection[int] | None" = None) -> DynamicMatrix:
    """The DynamicMatrix of a FactoredSystem; pieces, n: divided ones, and how many coordinates they need; spread, kept:
    as there."""
    polynomial = _padded(_polynomial(elements, elements.n), elements.n if n is None else n)
    return DynamicMatrix(polynomial, elements.pieces if pieces is None else pieces, spread, kept)


def _padded(polynomial: np.ndarray, n: int) -> np.ndarray:
    """With further coordinates."""
    more = n - polynomial.shape[-1]
    return np.pad(polynomial, ((0, 0), (0, more), (0, more)))


def _polynomial(elements: "FactoredSystem", n: int) -> np.ndarray:
    """K, C + G, M as (3, n, n), without the springs that pieces are at rest."""
    M, C, G, _ = elements.matrices()
    K = dict(elements.K)
    for weight, row in elements.springs:
        for i, x in row.items():
            for j, y in row.items():
                K[i, j] = K.get((i, j), 0) + weight * x * y
    found = np.zeros((3, n, n))
    for power, entries in ((0, K), (1, C), (1, G), (2, M)):
        for pair, x in entries.items():
            found[power][pair] += float(x)
    return found
