"""H(iΩ) of many degrees of freedom at many frequencies: of coordinates in a row by continued fractions
(coordinates_in_a_row.py), of others by modes (modal_solution.py), and where these lose something by elimination of the
band, all frequencies at once, or by LU.

Each method gives (H, dH/ds or None, whether there is a pole) at each s.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.frequency_response.coordinates_in_a_row import Row, in_a_row
from vibcli.analyses.frequency_response.direct import (
    SINGULAR,
    along,
    direct,
    probe,
    repaired,
    scales,
    symmetric,
)
from vibcli.analyses.frequency_response.modal_solution import modal_solution
from vibcli.analyses.frequency_response.quadratics import polynomial
from vibcli.base.work import counted
from vibcli.numerics import bands
from vibcli.numerics.fixed_point import MILLION

if TYPE_CHECKING:
    pass

NARROW = 16             # widest band on either side
LARGE = 64              # coordinates from which on another order of them is looked for
COUPLED = 400           # degrees of freedom up to which complex modes of a narrow band are worth their time
FEW = 1000              # frequencies times coordinates up to which one matrix after another takes less time
WINDOW, HELD = 2.0**16, 2.0**21     # numbers of all frequencies that a step of the elimination moves, and that it keeps


def chosen(system: Any) -> Any:
    """The method for this system; None where none of them fits."""
    order, width = _ordered(system)
    banded = Banded(system, order, width) if width <= min(NARROW, system.n // 4) else None
    ends = in_a_row(system) if width <= 1 else None
    if ends is not None:
        return Row(system, ends, banded)
    return modal_solution(system, banded or direct, COUPLED if banded else np.inf) or banded


def _ordered(system: Any) -> tuple[np.ndarray, int]:
    """(order of the coordinates, half the width of the band); as they stand where more entries than those of a narrow
    band are not zero."""
    pattern = (system.K != 0) | (system.M != 0) | (system.C != 0)
    order = np.arange(system.n)
    if np.count_nonzero(pattern) > (2 * NARROW + 1) * system.n:
        return order, system.n - 1
    pattern |= pattern.T
    width = _width(pattern)
    if width > NARROW and system.n >= LARGE:
        from scipy.sparse import csr_array
        from scipy.sparse.csgraph import reverse_cuthill_mckee

        order = reverse_cuthill_mckee(csr_array(pattern), symmetric_mode=True)
        width = _width(pattern[np.ix_(order, order)])
    return order, width


def _width(pattern: np.ndarray) -> int:
    rows, columns = np.nonzero(pattern)
    return int(np.abs(rows - columns).max(initial=0))


class Banded:
    """By elimination of the band: K, C, M by rows, (3, n, 2w + 1)."""

    __slots__ = ("back", "order", "rows", "symmetric", "turned", "width")

    def __init__(self, system: Any, order: np.ndarray, width: int) -> None:
        self.order, self.width, self.back = order, width, np.argsort(order)
        parts = [matrix[np.ix_(order, order)] for matrix in (system.K, system.C, system.M)]
        self.symmetric = symmetric(system)
        self.rows = np.stack([_by_rows(part, width) for part in parts])
        self.turned = self.rows if self.symmetric else np.stack([_by_rows(part.T, width) for part in parts])

    def __call__(self, system: Any, s: np.ndarray,
                 steep: bool = False) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
        """(H, dH/ds or None, whether there is a pole)."""
        if len(s) * system.n <= FEW:
            return direct(system, s, steep)
        x, y, lost = self._solved(system, s, steep)
        values = np.einsum("ki,ki->k", polynomial(system.c, s), x) + polynomial(system.d, s)
        return repaired(system, s, values, along(system, s, x, y) if steep else None, lost)

    def fields(self, system: Any, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(D⁻¹b, D⁻ᵀc), (N, n) each."""
        if len(s) * system.n <= FEW:
            return direct.fields(system, s)
        x, y, lost = self._solved(system, s, True)
        if len(lost):
            x[lost], y[lost] = direct.fields(system, s[lost])
        return x, y

    def _solved(self, system: Any, s: np.ndarray, both: bool) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
        """(D⁻¹b, D⁻ᵀc or None, the numbers of the frequencies at which D is singular but for rounding)."""
        across = 2 * self.width + 1
        many = int(max(8, min(WINDOW / (across + 3) / (self.width + 1), HELD / (across + 3) / system.n)))
        parts = [self._block(system, s[k:k + many], both) for k in range(0, len(s), many)]
        x, y, lost = zip(*parts, strict=True)
        return np.concatenate(x), np.concatenate(y) if both else None, np.flatnonzero(np.concatenate(lost))

    def _block(self, system: Any, s: np.ndarray, both: bool) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
        n = system.n
        counted(len(s) * n * (self.width + 1)**2 / MILLION)
        scale = np.ascontiguousarray(scales(system, s)[:, self.order].T)
        b, c = (polynomial(part, s)[:, self.order].T * scale for part in (system.b, system.c))
        right = [b, np.broadcast_to(probe(n)[:, None], b.shape), *([c] if both and self.symmetric else [])]
        found = bands.solved(self._scaled(self.rows, s, scale), np.stack(right, axis=1))
        lost = ~(np.abs(found[:, 1]).max(axis=0) * SINGULAR * 64 < 1)
        found[:, :, lost] = 0.0
        x, y = self._unscaled(found[:, 0], scale), None
        if both:
            if not self.symmetric:
                found = bands.solved(self._scaled(self.turned, s, scale), c[:, None])
                found[:, :, lost] = 0.0
            y = self._unscaled(found[:, -1], scale)
        return x, y, lost

    def _scaled(self, rows: np.ndarray, s: np.ndarray, scale: np.ndarray) -> np.ndarray:
        """D by rows, (n, 2w + 1, N)."""
        K, C, M = rows[..., None]
        D: np.ndarray = K + s * (C + s * M)
        beside = np.pad(scale, ((self.width, self.width), (0, 0)))
        for j in range(D.shape[1]):
            D[:, j] *= scale * beside[j:j + len(scale)]
        return D

    def _unscaled(self, x: np.ndarray, scale: np.ndarray) -> np.ndarray:
        found: np.ndarray = (x * scale).T[:, self.back]
        return found


def _by_rows(matrix: np.ndarray, width: int) -> np.ndarray:
    """(n, 2w + 1): the columns i − w … i + w of row i."""
    n = len(matrix)
    columns = np.arange(n)[:, None] + np.arange(-width, width + 1)
    within = (columns >= 0) & (columns < n)
    return np.where(within, np.take_along_axis(matrix, np.where(within, columns, 0), axis=1), 0.0)
