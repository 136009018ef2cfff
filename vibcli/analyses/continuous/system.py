"""Bodies, springs and continuous members at one frequency, in z = ω²:

    D(z) = K − z M + i√z G + Σ Sᵀ d S        J(z) = Σ J₀(z) + s{D(z)}      (Wittrick & Williams 1971)

d is the exact dynamic stiffness of a piece between its end values, S their rows; J counts the natural frequencies below
√z, s{·} negative eigenvalues, J₀ what a piece has with its ends held. Negative z are real s = √−z: what grows. Dampers
are left out.
"""

from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.piece_groups import PieceGroup
from vibcli.analyses.continuous.refinement import divided
from vibcli.analyses.continuous.short_pieces import relative_coordinates
from vibcli.numerics.sparse_elimination import Elimination, Pattern, product

if TYPE_CHECKING:
    import mpmath

    from vibcli.mechanics.factored_system import PlacedPiece


class Matrix:
    """Entries {(i, j): value} of a symmetric or Hermitian matrix, and the magnitudes that each was added from."""

    __slots__ = ("entries", "magnitudes")

    def __init__(self, terms: Iterable[tuple[Any, Mapping[int, Any]]], extra: Mapping[tuple[int, int], Any],
                 sizes: Mapping[tuple[int, int], Any] | None = None) -> None:
        self.entries: dict[tuple[int, int], Any] = defaultdict(int)
        self.magnitudes: dict[tuple[int, int], Any] = defaultdict(int)
        for weight, row in terms:
            for i, x in row.items():
                for j, y in row.items():
                    if i <= j:
                        self.entries[i, j] += weight * x * y
                        self.magnitudes[i, j] += abs(weight * x * y)
        for (i, j), x in extra.items():
            if i <= j:
                self.entries[i, j] += x
                self.magnitudes[i, j] += max((sizes or {}).get((i, j), 0), abs(x))


    def over(self, T: np.ndarray) -> "Matrix":
        """Tᵀ A T of floats."""
        found = []
        for entries, turn in ((self.entries, T), (self.magnitudes, abs(T))):
            full = np.zeros((len(T), len(T)))
            for (i, j), x in entries.items():
                full[i, j] = full[j, i] = float(x)
            found.append(turn.T @ full @ turn)
        entries, sizes = ({(i, j): float(part[i, j]) for i, j in zip(*np.nonzero(found[1]), strict=True)}
                          for part in found)
        return Matrix((), entries, sizes)


class ContinuousSystem:
    """D and J of a system of n coordinates, in floats, then over the `near` relative coordinates of short pieces where
    there are any, or, `digits` given, in numbers of mpmath.

    pieces: PlacedPieces; stiffness, inertia: Matrix; turning: the entries of G. unit: the rounding of a number;
    fine: a relative bound that need not be narrower; aside: the part of a z by which one stays away from where D has
    no inverse; scale: a z natural to the system; closest: the part of it below which a z is not told from zero.
    """

    def __init__(self, n: int, stiffness: Matrix, inertia: Matrix, turning: Mapping[tuple[int, int], Any],
                 pieces: "Sequence[PlacedPiece]", digits: int | None = None, plain: bool = False) -> None:
        self.n, self.turning, self.digits, self._plain = n, turning, digits, plain
        self._given = stiffness, inertia, tuple(pieces)
        near = None if plain or digits is not None or any(turning.values()) else relative_coordinates(pieces)
        self.near = near if near is not None and near.short else None
        if self.near is not None:
            stiffness, inertia = (part.over(self.near.matrix(n)) for part in (stiffness, inertia))
            moved = [self.near.short.get(k, ends) for k, ends in enumerate(self.near.ends)]
            pieces = [placed._replace(rows=rows) for placed, rows in zip(pieces, moved, strict=True)]
        self.stiffness, self.inertia, self.pieces = stiffness, inertia, tuple(pieces)
        self.unit = 2.0 ** -53 if digits is None else 10.0 ** -digits
        self.aside = 2.0 ** -20 if digits is None else self.number(10) ** (-digits // 3)
        self.fine = 4 * self.unit if digits is None else 10.0 ** (20 - digits)
        self.closest = 1e-13 if digits is None else 10.0 ** (-digits // 2)
        self.scale = _scale(self)
        tied = [pair for part in (stiffness.entries, inertia.entries, turning) for pair in part]
        tied += [(i, j) for piece in self.pieces for i in _touched(piece) for j in _touched(piece)]
        self.pattern = Pattern(n, tied)
        alike = _alike(self.pieces, self.near.short if self.near is not None else ())
        self._order = [k for numbers in alike for k in numbers]
        self.groups = [PieceGroup(self.pattern, [self.pieces[k] for k in numbers], digits, self.is_short(numbers[0]))
                       for numbers in alike]
        self._constant = self._columns(stiffness.entries), self._columns(inertia.entries)
        self._sizes = self._columns(stiffness.magnitudes), self._columns(inertia.magnitudes)
        self._turning = self._columns({(i, j): x for (i, j), x in turning.items() if i < j}) if any(
            turning.values()) else None

    def _columns(self, entries: "dict[Any, Any] | Mapping[tuple[int, int], float | mpmath.mpf]") -> np.ndarray:
        out = np.zeros((self.pattern.size, 1), float if self.digits is None else object)
        for (i, j), x in entries.items():
            out[self.pattern.places[i, j], 0] = x if self.digits else float(x)
        return out

    def numbers(self, values: Iterable[Any]) -> np.ndarray:
        """An array in the arithmetic of the system."""
        return np.array([self.number(x) for x in values], float if self.digits is None else object)

    def number(self, value: Any) -> Any:
        """A number in the arithmetic of the system."""
        if self.digits is None:
            return float(value)
        from mpmath import mp

        return mp.mpf(value)

    def dynamic_stiffness(self, z: np.ndarray, bent: bool = True) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """For each z the entries of D, the magnitudes added in them, and the entries of −∂D/∂z = ∂D/∂s², the inertia
        that a motion has at this frequency: arrays (entries of the pattern, number of z); not `bent`: without what
        bends short pieces as cantilevers."""
        (k, m), (k_size, m_size) = self._constant, self._sizes
        found, sizes, slope = k - m * z, k_size + m_size * abs(z), m + 0 * z
        for group in self.groups:
            group.add(z, found, sizes, slope, bent)
        if self._turning is not None:
            omega = self._root(z)
            found = found + 1j * self._turning * omega
            slope = slope - 0.5j * self._turning / np.where(omega == 0, omega + 1, omega)
        return found, sizes, slope

    def _root(self, z: np.ndarray) -> np.ndarray:
        if self.digits is None:
            return cast("np.ndarray", np.sqrt(z))
        from mpmath import mp

        return np.array([mp.sqrt(x) for x in z], object)

    def held(self, z: np.ndarray) -> np.ndarray:
        """J₀ of each piece, (pieces, number of z)."""
        if not self.groups:
            return np.zeros((0, len(z)), int)
        return np.concatenate([group.held(z) for group in self.groups])

    def eliminated(self, entries: np.ndarray, sizes: np.ndarray) -> Elimination:
        """The factors of matrices of these entries."""
        return Elimination(self.pattern, entries, sizes[:self.n] * self.unit + 1e-300)

    def refined(self, places: Mapping[int, Any]) -> "ContinuousSystem":
        """The same with further nodes within pieces, {index of the piece: part of its length}, free to move there."""
        pieces, n, (stiffness, inertia, _) = [], self.n, self._given
        for index, placed in enumerate(self.ordered):
            if index not in places:
                pieces.append(placed)
                continue
            pieces += _divided(placed, places[index], n, self.number)
            n += placed.piece.order // 2
        return ContinuousSystem(n, stiffness, inertia, self.turning, pieces, self.digits, self._plain)

    def is_short(self, number: int) -> bool:
        """Has a piece relative coordinates?"""
        return self.near is not None and number in self.near.short

    @property
    def plain(self) -> "ContinuousSystem":
        """The same over the coordinates of the scene."""
        stiffness, inertia, pieces = self._given
        return ContinuousSystem(self.n, stiffness, inertia, self.turning, pieces, self.digits, True)

    def in_scene(self, shape: np.ndarray) -> np.ndarray:
        """A shape over the coordinates of D as one over those of the scene."""
        return shape if self.near is None else self.near.matrix(self.n) @ shape

    @property
    def ordered(self) -> "list[PlacedPiece]":
        """The pieces in the order of `held`, over the coordinates of the scene."""
        return [self._given[2][k] for k in self._order]

    def bends(self, z: np.ndarray, shapes: np.ndarray) -> dict[int, np.ndarray]:
        """u₀, θ₀, F, P of short pieces in modes, {place in that order: (modes, 4)}; shapes: (modes, n), over the
        coordinates of D."""
        if self.near is None:
            return {}
        left = -product(self.pattern, self.dynamic_stiffness(z, False)[0], shapes.T).T
        return {self._order.index(k): own for k, own in self.near.bends(self.pieces, shapes, left).items()}


def continuous_system(elements: Any, digits: int | None = None) -> ContinuousSystem:
    """The ContinuousSystem of a FactoredSystem, without its dampers; its numbers are taken as they are."""
    springs: list[Any] = [*elements.springs]
    for placed in elements.pieces:
        if not placed.piece.inertia:
            springs += placed.springs
    return ContinuousSystem(elements.n, Matrix(springs, elements.K, elements.K_size),
                            Matrix(elements.inertias, elements.M), elements.G,
                            [placed for placed in elements.pieces if placed.piece.inertia], digits)


def _scale(system: ContinuousSystem) -> "float | mpmath.mpf":
    """A z that is natural to the system: that of its slowest piece or coordinate by itself."""
    found = []
    for placed in system.pieces:
        piece = placed.piece
        tension = max(abs(piece.tension), abs(piece.tension + piece.gradient * piece.length))
        found.append((tension / piece.length ** 2 + abs(piece.bending) / piece.length ** 4
                      + abs(piece.foundation)) / piece.inertia)
    for (i, j), m in system.inertia.magnitudes.items():
        k = system.stiffness.magnitudes.get((i, i), 0)
        if i == j and m and k:
            found.append(k / m)
    return system.number(min(found, default=1.0))


def _touched(placed: "PlacedPiece") -> set[int]:
    return {i for row in placed.rows for i, x in row.items() if x}


def _alike(pieces: "tuple[PlacedPiece, ...]",
           short: "Collection[int]") -> list[list[int]]:
    """The numbers of pieces that one formula serves, together."""
    groups = defaultdict(list)
    for number, placed in enumerate(pieces):
        piece = placed.piece
        groups[piece.order, bool(piece.tension), bool(piece.gradient), number in short].append(number)
    return list(groups.values())


def _divided(placed: "PlacedPiece", part: "float | mpmath.mpf", n: int,
             number: Callable[[Any], Any]) -> "list[PlacedPiece]":
    """A piece in two with a free node between, whose coordinates are n, of beams n and n + 1."""
    half = placed.piece.order // 2
    left, right = divided(placed.piece, part)
    node = tuple({n + i: number(1)} for i in range(half))
    return [placed._replace(piece=left, rows=(*placed.rows[:half], *node)),
            placed._replace(piece=right, rows=(*node, *placed.rows[half:]), start=placed.start + left.length)]
