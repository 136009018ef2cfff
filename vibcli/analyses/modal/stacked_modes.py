"""Natural modes of many systems M q̈ + K q = 0 at once, in floats, and which of them floats settle.

With D = diag M, M = D½ L Lᵀ D½ and L⁻¹ D⁻½ K D⁻½ L⁻ᵀ y = λ y the shapes are x = D⁻½ L⁻ᵀ y. Each λ is the Rayleigh
quotient of its shape, whose error is that of the sums and the square of that of the shape (Parlett 1980, 4.6):

    |δλ| ≤ ε c (|x|ᵀ |K| |x| + λ |x|ᵀ |M| |x|) + λ_max δx²,       δx ≤ ε c λ_max κ(L Lᵀ)/gap

where |K| and |M| are the sums of the sizes of their terms. What is closer together than that tells, moves freely in
more than one way, or has an amplitude that rounding may have left, is settled one by one elsewhere.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.modal.mode_sequence import Modes
from vibcli.analyses.modal.undamped import OSCILLATION, Mode
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.mechanics.stacked_matrices import StackedMatrices

EPSILON = 2.0**-52
TERMS = 8               # roundings of a term and its sum, a few of each
SETTLED, SHAPED = 2e-13, 1e-12      # relative error of ω, and of shapes
APART = 1e-4            # relative gap of frequencies
LEFT = 1e-9             # of the largest amplitude: what rounding may leave


class SwingingModes(NamedTuple):
    """A mode of many systems, in each of which it oscillates: ω and the bound of its relative error, arrays."""

    index: int      # type: ignore[assignment]
    omega: np.ndarray
    error: np.ndarray
    growth_rate: None = None
    rigid: bool = False
    kind: str = OSCILLATION


class StackedModes:
    """Of N systems with n coordinates: `settled`, N truths; `modes(i)` of one that is. `free`: has each of them, by its
    structure, one mode without frequency?"""

    def __init__(self, matrices: "StackedMatrices", free: bool = False) -> None:
        M, K = matrices.M, matrices.K
        diagonal = np.einsum("kii->ki", M)
        finite = np.isfinite(M).all((1, 2)) & np.isfinite(K).all((1, 2)) & (diagonal > 0).all(1)
        self.settled, self._free = np.zeros(len(M), dtype=bool), free
        self._squares = self._rates = self._bounds = np.empty((0, M.shape[1]))
        self._certain = np.empty(0, dtype=bool)
        places = np.flatnonzero(finite)
        self._row = {int(place): row for row, place in enumerate(places)}
        if len(places):
            with np.errstate(all="ignore"):
                self._solve(*(part[places] for part in matrices[:4]))
            self.settled[places] = self._certain

    def modes(self, i: int) -> list[Mode]:
        """The Modes of the system with the number i: those that grow first, then by ascending ω."""
        row = self._row[i]
        found = []
        for k, (square, rate, error) in enumerate(zip(self._squares[row].tolist(), self._rates[row].tolist(),
                                                      self._bounds[row].tolist(), strict=True)):
            shape = self._shapes[row, :, k]
            rates = (None, rate) if square < 0 else (rate, None)
            found.append(Mode(k + 1, *rates, shape, shape, error))
        return found

    def swinging(self) -> Modes:
        """The modes of all systems at once, NaN in those that are not settled, or where one does not oscillate."""
        found = np.full((2, len(self.settled), *self._squares.shape[1:]), np.nan)
        swings, places = self._certain[:, None] & (self._squares > 0), list(self._row)
        found[:, places] = np.where(swings, (self._rates, self._bounds), np.nan)
        return Modes([SwingingModes(k + 1, *columns)        # type: ignore[misc]
                      for k, columns in enumerate(found.transpose(2, 0, 1))])

    @property
    def held(self) -> np.ndarray:
        """N truths: has every mode of a system a frequency?"""
        found = np.zeros(len(self.settled), dtype=bool)
        found[list(self._row)] = (self._squares > 0).all(1)
        return found

    def settled_parts(self) -> tuple[np.ndarray, np.ndarray]:
        """(ω², shapes) of those that are settled, in order."""
        return self._squares[self._certain], self._shapes[self._certain]

    def _solve(self, M: np.ndarray, K: np.ndarray, M_size: np.ndarray, K_size: np.ndarray) -> None:
        n = M.shape[1]
        d = np.sqrt(np.einsum("kii->ki", M))
        scale = d[:, :, None] * d[:, None, :]
        spectrum = np.linalg.eigvalsh(M / scale)
        definite = spectrum[:, 0] > n * EPSILON * TERMS
        unit = np.where(definite[:, None, None], M / scale, np.eye(n))
        lower = np.linalg.cholesky(unit)
        half = np.linalg.solve(lower, K / scale)
        reduced = np.linalg.solve(lower, half.transpose(0, 2, 1))
        values, vectors = np.linalg.eigh(0.5 * (reduced + reduced.transpose(0, 2, 1)))
        shapes = np.linalg.solve(lower.transpose(0, 2, 1), vectors) / d[:, :, None]
        shapes /= np.sqrt(_quotient(shapes, M))[:, None, :]
        self._shapes, self._squares = shapes, _quotient(shapes, K)
        sizes = np.abs(shapes)
        most, gap = np.abs(values).max(1)[:, None], _gaps(values)
        blur = EPSILON * TERMS * n * most * (spectrum[:, -1] / spectrum[:, 0])[:, None] / gap
        rounding = EPSILON * (TERMS + 2 * n) * (
            _quotient(sizes, K_size) + np.abs(self._squares) * _quotient(sizes, M_size))
        rounding += most * blur**2
        if self._free:
            rounding, sizes = self._at_rest(rounding, sizes, d)
        self._errors = np.divide(rounding, np.abs(self._squares), out=np.zeros_like(rounding), where=rounding > 0)
        self._rates = np.sqrt(np.abs(self._squares))
        self._bounds = 0.5 * self._errors + EPSILON * (self._rates > 0)
        order = (np.diff(self._squares, axis=1) > 0).all(1)
        symmetric = np.equal(K, K.transpose(0, 2, 1)).all((1, 2)) & np.equal(M, M.transpose(0, 2, 1)).all((1, 2))
        self._certain = (definite & order & symmetric & (self._errors <= SETTLED).all(1) & (blur <= SHAPED).all(1)
                         & (gap >= APART * np.abs(values)).all(1) & _told(sizes * d[:, :, None]))

    def _at_rest(self, rounding: np.ndarray, sizes: np.ndarray, d: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The one mode that rounding does not tell from rest has no frequency, and exactly none."""
        rest = np.abs(self._squares) <= rounding
        alone = rest & (rest.sum(1) == 1)[:, None]
        self._squares = np.where(alone, 0.0, self._squares)
        felt = sizes * d[:, :, None]
        left = alone[:, None, :] & (felt <= LEFT * felt.max(1, keepdims=True))
        self._shapes = np.where(left, 0.0, self._shapes)
        return np.where(alone, 0.0, rounding), np.abs(self._shapes)


def _quotient(shapes: np.ndarray, matrices: np.ndarray) -> np.ndarray:
    """xᵀ A x of each column x."""
    found: np.ndarray = np.einsum("kim,kij,kjm->km", shapes, matrices, shapes)
    return found


def _gaps(values: np.ndarray) -> np.ndarray:
    """How far each value is from the next, infinite of one alone."""
    steps = np.diff(values, axis=1)
    wide = np.full((len(values), 1), np.inf)
    found: np.ndarray = np.minimum(np.hstack([wide, steps]), np.hstack([steps, wide]))
    return found


def _told(sizes: np.ndarray) -> np.ndarray:
    """Is every amplitude exactly zero, or larger than what rounding leaves?"""
    found: np.ndarray = ((sizes == 0) | (sizes > LEFT * sizes.max(1, keepdims=True))).all((1, 2))
    return found
