"""The parts of a scene with dampers that move without one another, each with its damped modes. What nothing damps has
the natural modes of its own, λ = ± iω, that counts of frequencies prove.

D(s) of all is of blocks: its zeros are those of the blocks, and as many.
"""

from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.continuous.argument_count import zeros_within
from vibcli.analyses.continuous.coincident_roots import coincident_roots
from vibcli.analyses.continuous.damped_estimates import between, estimates, half_turns, inner_estimates
from vibcli.analyses.continuous.damped_roots import ALIKE, DampedRoot, Whole, approached, roots_at
from vibcli.analyses.continuous.damped_series import RootsOfPart
from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix, dynamic_matrix
from vibcli.analyses.continuous.newton_of_members import Divisions, ShapesOf, distinct, polished, settled_from
from vibcli.analyses.continuous.trial_eigenvalues import trial_eigenvalues
from vibcli.analyses.continuous.uncoupled_parts import tied_parts
from vibcli.analyses.modal.mode_sequence import Modes
from vibcli.base.errors import PhysicsError
from vibcli.base.work import uncounted
from vibcli.numerics.pieces.held_count import held_count
from vibcli.numerics.pieces.stiffness import stiffness_and_slope

if TYPE_CHECKING:
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece

SURE = 1e-3         # relative bound of a root that is told
STILL = 1e-11       # of the largest component of a shape: what moves less rests
BESIDE = 1.2        # times a radius: from where estimates may lead into it


class PartWithModes:
    """Coordinates, numbered in a scene of n, and pieces that nothing ties to others; matrix: theirs."""

    def __init__(self, matrix: DynamicMatrix, coordinates: Sequence[int], n: int) -> None:
        self.matrix, self.coordinates, self.n = matrix, list(coordinates), n

    def placed(self, shapes: np.ndarray) -> np.ndarray:
        """Shapes (…, m) over its coordinates, and further nodes, as ones over those of the scene, and the nodes."""
        own = len(self.coordinates)
        found = np.zeros((*shapes.shape[:-1], self.n + shapes.shape[-1] - own), shapes.dtype)
        found[..., self.coordinates], found[..., self.n:] = shapes[..., :own], shapes[..., own:]
        return found

    def numbered(self, pieces: "Sequence[PlacedPiece]") -> "list[PlacedPiece]":
        """Pieces over these coordinates as pieces over those of the scene."""
        own = len(self.coordinates)

        def moved(row: "Mapping[int, float]") -> "dict[int, float]":
            return {self.coordinates[i] if i < own else self.n + i - own: x for i, x in row.items()}

        return [one._replace(rows=tuple(map(moved, one.rows))) for one in pieces]


class DampedPart(PartWithModes):
    """One whose roots are looked for from estimates, and counted by the argument principle; relative: its matrix over
    coordinates in which short pieces lose no digits; natural: what finds its modes without dampers."""

    def __init__(self, matrix: DynamicMatrix, coordinates: Sequence[int], n: int, relative: DynamicMatrix,
                 natural: Callable[[], Modes]) -> None:
        super().__init__(matrix, coordinates, n)
        self._natural = natural
        self._near = relative if relative.relative.short else matrix
        self._whole, self._too_far = Whole(self._near), np.inf

    def zeros_within(self, radius: float) -> int | None:
        """As of argument_count."""
        return zeros_within(self._near, radius)

    def roots(self, radius: float, effort: float, known: Sequence[DampedRoot], least: float,
              edge: float) -> list[DampedRoot]:
        """The known roots, up to `edge`, and polished ones from estimates between `least` and a radius."""
        found = self._estimates(radius, effort)
        near = sorted({complex(s) for s in found[(abs(found) < BESIDE * radius) & (abs(found) > least)]}, key=abs)
        told = [root.value for root in known]
        points: list[complex] = []
        for s in near:
            root = approached(self._whole, s)
            if root is not None and abs(root) > max(least, edge) and not any(
                    abs(root - one) < ALIKE * abs(one) for one in told + points):
                points.append(root)
        roots = [(s, cleaned(root, self._near)) for s in points for root in roots_at(self._whole, s)]
        roots = _distinct([(s, root) for s, root in roots if root.error < SURE and root.value.imag >= 0])
        return [*known, *(root._replace(shape=self.placed(self._seen(root.shape))) for root in roots)]

    def _seen(self, shape: np.ndarray) -> np.ndarray:
        """A shape over the coordinates of the scene."""
        return cast("np.ndarray", self._near.in_scene(shape[None])[1][0])

    def _estimates(self, radius: float, effort: float) -> np.ndarray:
        """Those of eigenvalues within a radius."""
        waves = []
        for placed in self._near.pieces:
            piece = placed.piece._make(np.array([float(x)]) for x in placed.piece)
            kappa = piece.foundation - piece.inertia * (1.3 * radius)**2
            waves.append(float(held_count(piece._replace(foundation=kappa), 0)[0]))
        found = None
        if radius * effort < self._too_far:
            found = trial_eigenvalues(self._near, [int((2.5 * one + 14) * effort) for one in waves], radius)
        if found is None:
            self._too_far = min(self._too_far, radius * effort)
            raise PhysicsError("so many damped modes of members are not found", "ask for fewer, or lower ones")
        return found

    def series(self, rates: np.ndarray, radius: float, top: float, effort: int) -> RootsOfPart:
        """The known rates, those within a radius, and what is found beyond it up to about a frequency."""
        divisions = Divisions(self._near)
        starts = self._starts(rates, radius, top, effort)
        if effort > 1:
            starts = np.concatenate([starts, self._undamped(radius, top)])
        inner = inner_estimates(self.matrix.pieces, radius, max(abs(starts).max(initial=0.0), top))
        found, slow = settled_from(divisions, starts, inner)
        roots = _beyond(rates, found, radius)
        found, more = settled_from(divisions, between(self.matrix.pieces, roots), inner[:0])
        values, errors, groups = polished(divisions, _beyond(roots, found, radius))
        several = coincident_roots(divisions, values, errors, distinct(np.concatenate([slow, more])))
        return RootsOfPart(values, errors, list(map(self._of_scene, groups)),
                           [one._replace(shapes=self._of_scene(one.shapes)) for one in several])

    def _of_scene(self, shapes: ShapesOf) -> ShapesOf:
        """ShapesOf over its coordinates as ones over those of the scene."""
        return shapes._replace(pieces=self.numbered(shapes.pieces), shapes=self.placed(shapes.shapes))

    def _undamped(self, radius: float, top: float) -> np.ndarray:
        """iω without dampers: each root but those of strong dampers has its own near it."""
        with uncounted():
            return 1j * np.array([float(mode.omega) for mode in self._natural().between(radius / BESIDE, top)])

    def _starts(self, rates: np.ndarray, radius: float, top: float, effort: int) -> np.ndarray:
        if not self.matrix.pieces:
            return trial_eigenvalues(self.matrix, [], top)
        return estimates(self.matrix, rates, radius, float(half_turns(self.matrix.pieces, top)), effort)


class StillPart(PartWithModes):
    """One that nothing damps: its natural modes."""

    def __init__(self, matrix: DynamicMatrix, coordinates: Sequence[int], n: int, natural: Modes) -> None:
        super().__init__(matrix, coordinates, n)
        self._natural = natural

    def zeros_within(self, radius: float) -> int | None:
        """How many λ = ± iω, none of which grows, have |λ| < radius; None where one is next to it."""
        low, high = (len(self._natural.up_to(radius * side)) for side in (1 - SURE * 1e-6, 1 + SURE * 1e-6))
        return 2 * low if low == high else None

    def roots(self, radius: float, effort: float, known: Sequence[DampedRoot], least: float,
              edge: float) -> list[DampedRoot]:
        """All within a radius."""
        return [DampedRoot(1j * float(mode.omega), float(mode.error), self.placed(_shape(mode)[:len(self.coordinates)]))
                for mode in self._natural.up_to(radius) if mode.omega]

    def series(self, rates: np.ndarray, radius: float, top: float, effort: int) -> RootsOfPart:
        """All up to a frequency."""
        modes = [mode for mode in self._natural.up_to(top) if mode.omega]
        omega = np.array([float(mode.omega) for mode in modes])
        alike: dict[Any, list[Any]] = defaultdict(list)
        for number, mode in enumerate(modes):
            alike[id(mode.motion.system)].append(number)
        groups = []
        for numbers in alike.values():
            shapes = np.array([_shape(modes[k]) for k in numbers]) / np.sqrt(2j * omega[numbers])[:, None]
            groups.append(ShapesOf(self.numbered(modes[numbers[0]].motion.system.ordered), np.array(numbers),
                                   self.placed(shapes)))
        return RootsOfPart(1j * omega, np.array([float(mode.error) for mode in modes]), groups)


def _beyond(rates: np.ndarray, found: np.ndarray, radius: float) -> np.ndarray:
    """Rates, and of those found what lies beyond a radius, none twice."""
    return distinct(np.concatenate([rates, found[abs(found) > radius * (1 - ALIKE * 0.01)]]))


def _shape(mode: "Mode") -> np.ndarray:
    """Over all coordinates and nodes of its system, xᵀ D′ x = 1 as a function of s²."""
    return np.array([float(x) for x in mode.motion.shape])


def damped_parts(elements: "FactoredSystem", matrix: DynamicMatrix) -> list[DampedPart | StillPart]:
    """Those of a system, and its DynamicMatrix."""
    tied = tied_parts(list(matrix.polynomial), [placed.rows for placed in matrix.pieces])
    numbers = sorted({*tied.coordinates, *tied.pieces})
    if len(numbers) < 2:
        return [DampedPart(matrix, range(matrix.n), matrix.n, dynamic_matrix(elements, kept=()),
                           partial(_natural, elements))]
    found: list[DampedPart | StillPart] = []
    for number in numbers:
        coordinates = [i for i, part in enumerate(tied.coordinates) if part == number]
        own = elements.among({i: k for k, i in enumerate(coordinates)},
                             [p for p, part in enumerate(tied.pieces) if part == number])
        found.append(_part(own, coordinates, matrix.n))
    return found


def _part(elements: "FactoredSystem", coordinates: list[int], n: int) -> DampedPart | StillPart:
    """A StillPart where nothing damps it and none of it grows."""
    matrix = dynamic_matrix(elements)
    if matrix.undamped and any(placed.piece.inertia for placed in elements.pieces):
        natural = _natural(elements)
        if not natural.grow:
            return StillPart(matrix, coordinates, n, natural)
    return DampedPart(matrix, coordinates, n, dynamic_matrix(elements, kept=()), partial(_natural, elements))


def _natural(elements: "FactoredSystem") -> Modes:
    """Its modes without dampers."""
    from vibcli.analyses.continuous.mode_source import NaturalModes

    return Modes((), NaturalModes(elements.with_parts(dampers=(), C=None, G=None, drag=None)))


def _distinct(roots: Sequence[tuple[complex, DampedRoot]]) -> list[DampedRoot]:
    """Roots of which none is another one found twice, from a neighbouring estimate."""
    found: list[tuple[complex, DampedRoot]] = []
    for at, root in roots:
        if not any(at != other and abs(root.value - one.value) <= 4 * (root.error + one.error) * abs(root.value)
                   for other, one in found):
            found.append((at, root))
    return [root for _, root in found]


def cleaned(root: DampedRoot, matrix: DynamicMatrix) -> DampedRoot:
    """A root whose imaginary part is nothing beside its bound has none; where its real part is, that is
    −(xᴴCx + Σ c ∫|u|² dx)/2, as far as the shape moves what C holds to."""
    size = 2 * root.error * abs(root.value)
    value = root.value
    if abs(value.imag) <= size:
        value = complex(value.real, 0.0)
    elif abs(value.real) <= size:
        largest = max(abs(root.shape).max(initial=0.0), _usual(matrix))
        x = np.where(abs(root.shape) > STILL * largest, root.shape, 0.0)
        damping = (matrix.polynomial[1] + matrix.polynomial[1].T) / 2       # gyroscopic terms lose nothing
        lost = float((x.conj() @ damping @ x).real) + _dragged(matrix, x, value.imag)
        value = complex(-lost / 2, value.imag)
    return root._replace(value=value)


def _usual(matrix: DynamicMatrix) -> float:
    """The displacement that all members have where they move alike with unit ∫μu²: a mode all of whose nodes rest has
    no other size among its coordinates."""
    inertia = sum(float(placed.piece.inertia * placed.piece.length) for placed in matrix.pieces)
    return inertia**-0.5 if inertia else 0.0


def _dragged(matrix: DynamicMatrix, x: np.ndarray, omega: float) -> float:
    """Σ c ∫|u|² dx of pieces with drag."""
    found = 0.0
    for placed in matrix.pieces:
        if placed.piece.drag:
            ends = np.array([sum(value * x[i] for i, value in row.items()) for row in placed.rows])
            slope = stiffness_and_slope(placed.piece, placed.piece.undamped_reaction(omega))[1]
            found += float(placed.piece.drag * (ends.conj() @ slope @ ends).real)
    return found
