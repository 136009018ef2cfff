"""Small oscillations, element by element: the data that the frequency methods work on.

Every element acts through a scalar function s(q); at the equilibrium it leaves a row ∇s and a weight:

    M = Σ w ∇s ∇sᵀ + M₊      C = Σ c ∇s ∇sᵀ + C₊      K = Σ k ∇s ∇sᵀ + K₊

K₊ holds the geometric terms Σ V′∇²s and Σ m g ∇²y and whatever a scene gives as a matrix. Assembling the
sums loses digits (1 + 10¹⁶ == 10¹⁶), so the rows are kept apart as long as the method allows. Forces that no potential
gives (follower forces) make K₊, and with it K, a matrix that is not symmetric.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    import numpy as np

ROUNDING = 2.0 ** -51
MOST_DENSE = 2000       # coordinates of which matrices are made that hold an entry for any two of them

WeightedRow = tuple[Any, dict[int, Any]]


class PlacedPiece(NamedTuple):
    """A uniform piece of the member `owner`, its left end at the place `start`: its Piece, the rows ∇s of the
    displacements of its ends, {coordinate index: component} of (u₀, u_l), of beams (u₀, u₀′, u_l, u_l′), and the
    springs [(weight, row)] that it is at rest. retardation: β with which its stiffness resists rates, N + β N d/dt."""

    owner: str
    start: Any
    piece: Any
    rows: tuple[dict[int, Any], ...]
    springs: list[WeightedRow]
    retardation: Any = 0


class FactoredSystem:
    """Rows and weights in one arithmetic: float, mpmath.mpf or Fraction.

    n: number of coordinates. inertias, springs, dampers: tuples of (weight, row), where a row is a
    dict {coordinate index: component}. M, C, G, K: what is not of that form, dicts {(i, j): value} with both
    triangles written, empty where absent (G skew); drag: the skew part of what loads add to C. K_size: for each entry
    of K, the sum of the magnitudes of the terms it was added from, the scale of its rounding error. rational_rows: the
    spring rows as Fractions where they are rational, else None. massless: indices of coordinates which no inertia
    moves, exactly. pieces: PlacedPieces of members, whose static springs are not among `springs`.
    """

    __slots__ = ("C", "G", "K", "K_size", "M", "dampers", "drag", "inertias", "massless", "n", "pieces",
                 "rational_rows", "springs")

    def __init__(self, n: int, inertias: Iterable[WeightedRow] = (), springs: Iterable[WeightedRow] = (),
                 dampers: Iterable[WeightedRow] = (), M: Any = None, C: Any = None, G: Any = None,
                 K: Mapping[tuple[int, int], Any] | None = None, K_size: Any = None, rational_rows: Any = None,
                 massless: Sequence[Any] = (), drag: Any = None, pieces: Sequence[PlacedPiece] = ()) -> None:
        self.n = n
        self.inertias, self.springs, self.dampers = tuple(inertias), tuple(springs), tuple(dampers)
        self.M, self.C, self.G, self.K = M or {}, C or {}, G or {}, K or {}
        self.K_size, self.drag = K_size or {}, drag or {}
        self.rational_rows, self.massless, self.pieces = rational_rows, tuple(massless), tuple(pieces)

    @property
    def why_modeless(self) -> str:
        """Why a system with dampers has no natural modes without them."""
        if len(self.massless) == self.n:
            return "nothing in this scene has inertia"
        return "without its dampers nothing would hold what has no inertia in this scene"

    def with_parts(self, **parts: Any) -> "FactoredSystem":
        """The same with other parts."""
        return FactoredSystem(**{kind: getattr(self, kind) for kind in self.__slots__} | parts)

    def each(self, change: Any, **given: Any) -> "FactoredSystem":
        """The same with `change` applied to every weight, slope and entry of a matrix, and with the parts `given`."""
        def rows(terms: "Iterable[WeightedRow]") -> "list[WeightedRow]":
            return [(change(weight), {i: change(x) for i, x in row.items()}) for weight, row in terms]

        parts: dict[str, Any] = {kind: rows(getattr(self, kind)) for kind in ("inertias", "springs", "dampers")}
        parts["pieces"] = [PlacedPiece(piece.owner, change(piece.start), piece.piece._make(map(change, piece.piece)),
                                       tuple({i: change(x) for i, x in row.items()} for row in piece.rows),
                                       rows(piece.springs), change(piece.retardation) if piece.retardation else 0)
                           for piece in self.pieces]
        parts |= {kind: {pair: change(x) for pair, x in getattr(self, kind).items()}
                  for kind in ("M", "C", "G", "K", "drag")}
        return self.with_parts(**(parts | given))

    def among(self, numbers: Mapping[int, int], pieces: Sequence[int]) -> "FactoredSystem":
        """What some coordinates, {number: new number}, and pieces do while nothing else moves."""
        def over(row: "Mapping[int, Any]") -> "dict[int, Any]":
            return {numbers[i]: x for i, x in row.items() if i in numbers}

        def rows(terms: "Iterable[WeightedRow]") -> "list[WeightedRow]":
            return [(weight, over(row)) for weight, row in terms if not numbers.keys().isdisjoint(row)]

        parts: dict[str, Any] = {kind: rows(getattr(self, kind)) for kind in ("inertias", "springs", "dampers")}
        parts |= {kind: {(numbers[i], numbers[j]): x for (i, j), x in getattr(self, kind).items()
                         if i in numbers and j in numbers} for kind in ("M", "C", "G", "K", "K_size", "drag")}
        parts["pieces"] = [placed._replace(rows=tuple(map(over, placed.rows)), springs=rows(placed.springs))
                           for placed in (self.pieces[p] for p in pieces)]
        return FactoredSystem(len(numbers), massless=[numbers[i] for i in self.massless if i in numbers], **parts)

    @property
    def damps(self) -> bool:
        """Do forces depend on velocities, the gyroscopic ones of what moves left out?"""
        return bool(self.dampers or self.C or any(self.drag.values()) or any(one.piece.drag for one in self.pieces))

    @property
    def circulatory(self) -> bool:
        """Is K not symmetric? Exactly, or by more than the rounding of its sums where K_size tells that."""
        size = self.K_size
        return any(abs(x - self.K.get((j, i), 0)) > ROUNDING * (size.get((i, j), 0) + size.get((j, i), 0))
                   for (i, j), x in self.K.items() if i != j)

    def matrices(self) -> list[dict[tuple[int, int], Any]]:
        """M, C, G, K assembled, each {(i, j): number}: for printing and for what needs no last digit."""
        return [_assembled(rows, extra) for rows, extra in (
            (self.inertias, self.M), (self.dampers, summed(self.C, self.drag)), ((), self.G),
            (self.static_springs, self.K))]

    def arrays(self) -> "list[np.ndarray]":
        """The same as arrays of floats."""
        return [_as_array(entries, self.n) for entries in self.matrices()]

    def coefficients(self) -> "tuple[np.ndarray, np.ndarray, np.ndarray]":
        """(M, C + G, K) as arrays of floats: what stands before q̈, q̇ and q."""
        M, C, G, K = self.arrays()
        return M, C + G, K

    def stiffness_array(self) -> "np.ndarray":
        """K assembled, as an array of floats."""
        return _as_array(self.stiffness(), self.n)

    def stiffness(self) -> dict[tuple[int, int], Any]:
        """K assembled, that of the pieces at rest included, {(i, j): number}."""
        return _assembled(self.static_springs, self.K)

    @property
    def static_springs(self) -> list[WeightedRow]:
        """The springs, and those that the pieces are at rest."""
        return [*self.springs, *(spring for piece in self.pieces for spring in piece.springs)]


def require_dense(n: int, what: str = "this") -> None:
    """PhysicsError of what makes dense matrices of so many coordinates, where these are too many."""
    if n > MOST_DENSE:
        raise PhysicsError(f"{what} needs dense matrices of all coordinates, {n}; the limit for those is {MOST_DENSE}",
                           "ask for the lowest modes without dampers, as omega[1] or find: [{modes: 10}]")


def summed(one: Any, two: Mapping[Any, Any]) -> dict[Any, Any]:
    """The sum of two matrices {(i, j): entry}; of numbers of mpmath exactly, whatever the precision about them is."""
    found = dict(one)
    for pair, x in two.items():
        found[pair] = _added(found[pair], x) if pair in found else x
    return found


def _added(x: Any, y: Any) -> Any:
    if hasattr(x, "_mpf_") and hasattr(y, "_mpf_"):
        import mpmath

        return mpmath.fadd(x, y, exact=True)
    return x + y


def _as_array(entries: Mapping[tuple[int, int], float], n: int) -> "np.ndarray":
    import numpy as np

    found = np.zeros((n, n))
    for pair, x in entries.items():
        found[pair] = float(x)
    return found


def _assembled(terms: Iterable[WeightedRow], extra: Mapping[tuple[int, int], Any]) -> dict[tuple[int, int], Any]:
    matrix = dict(extra)
    for weight, row in terms:
        for i, x in row.items():
            for j, y in row.items():
                matrix[i, j] = matrix.get((i, j), 0) + weight * x * y
    return matrix
