"""How many eigenvalues of K x = λ M x lie below σ: as many as K − σM has negative pivots (Sylvester's law of inertia).

K − σM = L D Lᵀ without exchanges, by SuperLU in an order of little fill. The factors are those of K − σM + Δ with
|Δ| ≤ γ |L||D||Lᵀ| entry by entry (Higham 2002, theorem 9.3), and with what K − σM itself is rounded by; so the count is
that of a σ at most ‖Δ‖/τ away, where τ M's smallest eigenvalue is above.
"""

from typing import Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.base.work import counted
from vibcli.numerics.sparse_form import UNIT, SparseForm

MILLION = 1e6       # products are a step of work


class ShiftedFactors(NamedTuple):
    """shift: σ; below: the number of negative pivots; margin: the eigenvalues below σ − margin are no more, those
    below σ + margin no fewer; solve: (K − σM)⁻¹ times columns, of which each costs so many steps of work."""

    shift: float
    below: int
    margin: float
    solve: Any
    cost: float


class Pencil:
    """K, M as SparseForms; sizes: the sums over rows of the magnitudes that each is added from; least: a lower bound of
    the eigenvalues of M, 0 where none above is found."""

    __slots__ = ("K", "M", "_K", "_M", "least", "sizes")

    def __init__(self, K: SparseForm, M: SparseForm) -> None:
        self.K, self.M, self._K, self._M = K, M, K.assembled().tocsc(), M.assembled().tocsc()
        self.sizes = K.magnitudes(), M.magnitudes()
        self.least = _least(M, self._M, self.sizes[1])

    @property
    def top(self) -> float:
        """A bound of the size of the eigenvalues."""
        return float(self.sizes[0].max()) / self.least

    def factors(self, shift: float) -> ShiftedFactors | None:
        """The ShiftedFactors of K − σM; None where a pivot vanishes."""
        found = _factored(self._K - shift * self._M)
        if found is None:
            return None
        lu, below, rounding = found
        size = self.sizes[0] + abs(shift) * self.sizes[1]
        more = (self.K.terms + self.M.terms + 3) * UNIT * float(size.max())
        return ShiftedFactors(shift, below, (rounding + more) / self.least, lu.solve, 2 * lu.nnz / MILLION)


def _least(M: SparseForm, assembled: Any, size: np.ndarray) -> float:
    """A bound below which M has no eigenvalue; 0 where none is found."""
    diagonal = assembled.diagonal()
    bound = float(diagonal.min())
    if M.is_diagonal:
        return bound * (1 - (M.terms + 3) * UNIT)
    from scipy.sparse import identity

    rounding = (M.terms + 3) * UNIT * float(size.max())
    while bound > 4 * rounding:
        bound /= 4
        found = _factored(assembled - bound * identity(M.n, format="csc"))
        if found is not None and not found[1] and found[2] + rounding < bound / 2:
            return bound / 2
    return 0.0


def _factored(matrix: Any) -> tuple[Any, int, float] | None:
    """(factors, number of negative pivots, bound of ‖Δ‖); None where a pivot vanishes."""
    from scipy.sparse.linalg import splu

    try:
        lu = splu(matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    except RuntimeError:
        return None
    if not np.array_equal(lu.perm_r, lu.perm_c):
        return None
    counted(lu.nnz ** 2 / len(lu.perm_r) / 2 / MILLION)
    lower, upper = lu.L, lu.U
    longest = np.bincount(lower.indices, minlength=len(lu.perm_r)).max()
    size = abs(lower) @ (abs(upper) @ np.ones(len(lu.perm_r)))
    return lu, int((upper.diagonal() < 0).sum()), float((longest + 2) * UNIT * size.max())
