"""Damped modes of many systems at once, in floats, where all are under-damped, and which of them floats settle.

In the coordinates of the modes without dampers, q = X z, c = Xᵀ C X, the eigenvalues are those of

    d/dt (Ω z, ż) = [[0, Ω], [−Ω, −c]] (Ω z, ż)

With a vector z, |z| = 1, of λ the decay is δ = zᴴ c z/2 and ω_d² = zᴴ Ω² z − δ². An error dz of the vector changes δ by
|(c − 2δ) z| |dz| and ω_max |dz|², since z makes λ stationary where the damping couples no modes.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.modal.damped_modes import DampedMode
from vibcli.analyses.modal.mode_sequence import Modes
from vibcli.analyses.modal.undamped import OSCILLATION
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.modal.stacked_modes import StackedModes
    from vibcli.mechanics.stacked_matrices import StackedMatrices

EPSILON = 2.0**-52
TERMS = 8               # roundings of a term and its sum, a few of each
SETTLED = 1e-12         # relative error of decay and ω_d
ALIKE = 1e-9            # relative difference of |λ|, below which their order is not told
WEAK, STRONG = 1e-9, 0.999      # damping ratios between which a mode is told here


class SwingingDampedModes(NamedTuple):
    """A damped mode of many systems: δ, ω_d, |λ| and the bound of the relative error of λ, arrays."""

    index: int      # type: ignore[assignment]
    decay: np.ndarray
    omega_d: np.ndarray
    omega: np.ndarray
    error: np.ndarray
    kind: str = OSCILLATION

    @property
    def zeta(self) -> np.ndarray:
        found: np.ndarray = self.decay / self.omega
        return found

    @property
    def bounds(self) -> tuple[np.ndarray, np.ndarray]:
        """Of the relative errors of δ and ζ, and of ω_d."""
        return self.error * self.omega / self.decay, self.error * self.omega / self.omega_d


class StackedDamped:
    """Of the systems whose StackedModes are settled: `settled`, N truths; `modes(i)` of one that is."""

    def __init__(self, matrices: "StackedMatrices", natural: "StackedModes") -> None:
        self.settled, self._row = natural.settled.copy(), {}
        self._decay = self._omega_d = self._size = self._errors = np.empty((0, matrices.C.shape[1]))
        self._certain = np.empty(0, dtype=bool)
        places = np.flatnonzero(self.settled)
        if not len(places) or not matrices.C.any():
            self.settled[:] = False
            return
        self._row = {int(place): row for row, place in enumerate(places)}
        with np.errstate(all="ignore"):
            self._solve(*natural.settled_parts(), matrices.C[places], matrices.C_size[places])
        self.settled[places] = self._certain

    def modes(self, i: int) -> list[DampedMode]:
        """The DampedModes of the system with the number i, by ascending |λ|."""
        row, found = self._row[i], []
        for k in range(len(self._decay[row])):
            decay, omega_d, omega = (float(one[row, k]) for one in (self._decay, self._omega_d, self._size))
            found.append(DampedMode(k + 1, complex(-decay, omega_d), omega, decay / omega, self._shapes[row, :, k],
                                    float(self._errors[row, k]), decay=decay))
        return found

    def swinging(self) -> Modes:
        """The damped modes of all systems at once, NaN in those that are not settled."""
        found, places = np.full((4, len(self.settled), *self._decay.shape[1:]), np.nan), list(self._row)
        found[:, places] = np.where(self._certain[:, None], (self._decay, self._omega_d, self._size, self._errors),
                                    np.nan)
        return Modes([SwingingDampedModes(k + 1, *columns)      # type: ignore[misc]
                      for k, columns in enumerate(found.transpose(2, 0, 1))])

    def _solve(self, squares: np.ndarray, shapes: np.ndarray, C: np.ndarray, C_size: np.ndarray) -> None:
        count, n = squares.shape
        omega = np.sqrt(np.where(squares > 0, squares, np.nan))
        c = np.einsum("kim,kij,kjl->kml", shapes, C, shapes)
        c_size = np.einsum("kim,kij,kjl->kml", np.abs(shapes), C_size, np.abs(shapes))
        swinging = np.isfinite(omega).all(1) & np.isfinite(c).all((1, 2))
        A = np.zeros((count, 2 * n, 2 * n))
        A[:, range(n), range(n, 2 * n)], A[:, range(n, 2 * n), range(n)] = omega, -omega
        A[:, n:, n:] = -c
        A[~swinging] = np.eye(2 * n)
        values, vectors = np.linalg.eig(A)
        swinging &= ((values.imag > 0).sum(1) == n) & ((values.imag < 0).sum(1) == n)
        order = np.argsort(np.where(values.imag > 0, np.abs(values), np.inf), axis=1, kind="stable")[:, :n]
        values = np.take_along_axis(values, order, 1)
        full = np.take_along_axis(vectors, order[:, None, :], 2)
        left = np.linalg.norm(A @ full - values[:, None, :] * full, axis=1)
        z = full[:, n:]
        z = z / np.linalg.norm(z, axis=1)[:, None, :]
        self._decay = 0.5 * np.einsum("kim,kij,kjm->km", z.conj(), c, z).real
        square = np.einsum("kim,ki,kim->km", z.conj(), np.where(squares > 0, squares, np.nan), z).real
        self._omega_d = np.sqrt(square - self._decay**2)
        blur = self._blur(A, values, left, np.where(swinging[:, None, None], vectors, np.eye(2 * n)))
        pull = np.linalg.norm(np.einsum("kij,kjm->kim", c, z) - 2 * self._decay[:, None, :] * z, axis=1)
        change = pull * blur + omega.max(1)[:, None] * blur**2
        rounding = EPSILON * (TERMS + 2 * n) * np.einsum("kim,kij,kjm->km", np.abs(z), c_size, np.abs(z))
        self._size = size = np.hypot(self._decay, self._omega_d)
        self._errors = (change + rounding) / size + EPSILON * TERMS
        leads = np.take_along_axis(q := shapes @ z, np.abs(q).argmax(1)[:, None, :], 1)
        self._shapes = q * np.abs(leads) / leads
        zeta = self._decay / size
        apart = (np.diff(size, axis=1) > ALIKE * size[:, 1:]).all(1)
        self._certain = (swinging & apart & ((zeta > WEAK) & (zeta < STRONG)).all(1)
                         & (change + rounding <= SETTLED * self._decay).all(1)
                         & (change <= SETTLED * self._omega_d).all(1)
                         & (np.abs(values.imag - self._omega_d) <= 1e-8 * size).all(1))

    def _blur(self, A: np.ndarray, values: np.ndarray, left: np.ndarray, vectors: np.ndarray) -> np.ndarray:
        """A bound of the error of a vector: what is left of its equation, and that sum's rounding, over the distance of
        the next eigenvalue."""
        n = values.shape[1]
        apart = np.abs(values[:, :, None] - values[:, None, :]) + np.where(np.eye(n), np.inf, 0.0)
        gap = np.minimum(apart.min(2), 2 * values.imag)
        size = np.linalg.norm(A, axis=(1, 2))[:, None]
        found: np.ndarray = (left + 2 * n * EPSILON * size) * np.linalg.cond(vectors)[:, None] / gap
        return found
