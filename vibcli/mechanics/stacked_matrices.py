"""M, C and K of a scene at many values of its parameters, by one walk over its expressions with arrays of numbers.

    M = Σ w ∇s ∇sᵀ + M₊      C = Σ c ∇s ∇sᵀ + C₊      K = Σ k ∇s ∇sᵀ + Σ V′ ∇²s + K₊      r = Σ V′ ∇s + r₊

Beside each stands the sum of the sizes of its terms, the scale of its rounding.
"""

from collections import Counter
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.linearisation import nodes_of
from vibcli.mechanics.numeric_linearisation import ALIKE
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.linearisation import Linearisation

BALANCED = 2.0**-50      # of the sizes of so many terms and two


class StackedMatrices(NamedTuple):
    """Arrays of N × n × n numbers, the residual r of N × n; terms: of how many it was added at most."""

    M: np.ndarray
    K: np.ndarray
    M_size: np.ndarray
    K_size: np.ndarray
    C: np.ndarray
    C_size: np.ndarray
    residual: np.ndarray
    residual_size: np.ndarray
    terms: int

    @property
    def balanced(self) -> np.ndarray:
        """N truths: do the forces balance but for the rounding of their terms?"""
        found: np.ndarray = (np.abs(self.residual) <= BALANCED * (self.terms + 2) * self.residual_size).all(1)
        return found


def stacked_matrices(form: "Linearisation", values: "Mapping[str, float | np.ndarray]", count: int) -> StackedMatrices:
    """Those of a Linearisation without members, {symbol: array of `count` numbers}; NaN where it has no value."""
    nodes = list(dict.fromkeys(nodes_of(form)))
    with np.errstate(all="ignore"):
        known = dict(zip(nodes, (np.broadcast_to(x, (count,)) for x in evaluate(nodes, Arrays, values)), strict=True))
        M, C, K, r = (_Sums(count, *[form.n] * axes) for axes in (2, 2, 2, 1))
        for sums, terms in ((M, form.inertias), (C, form.dampers), (K, form.springs)):
            for weight, row in terms:
                sums.add_square(known[weight], {i: known[x] for i, x in row.items()})
        for force, curvature, row in form.curved:
            for pair, second in curvature.items():
                K.add(pair, known[force] * known[second])
            for i, slope in row.items():
                r.add((i,), known[force] * known[slope])
        for sums, parts in ((M, [form.M]), (C, [form.C]), (K, form.K)):
            for pair, node in (entry for part in parts for entry in part.items()):
                sums.add(pair, known[node])
        for i, node in (entry for part in form.residual for entry in part.items()):
            r.add((i,), known[node])
        return StackedMatrices(M.total, K.evened(), M.size, K.size, C.total, C.size, r.total, r.size,
                               max(r.terms.values(), default=0))


class _Sums:
    """Matrices, or columns, that are added up, the sizes of their terms, and how many there are of each."""

    def __init__(self, count: int, *shape: int) -> None:
        self.total, self.size, self.terms = np.zeros((count, *shape)), np.zeros((count, *shape)), Counter()

    def add(self, place: tuple[int, ...], term: np.ndarray) -> None:
        everywhere: Any = (slice(None), *place)
        self.total[everywhere] += term
        self.size[everywhere] += np.abs(term)
        self.terms[place] += 1

    def add_square(self, weight: np.ndarray, row: "Mapping[int, np.ndarray]") -> None:
        for i, x in row.items():
            for j, y in row.items():
                self.add((i, j), weight * x * y)

    def evened(self) -> np.ndarray:
        """The total, its parts that differ from those across the diagonal by rounding alone made equal to them."""
        across = self.total.transpose(0, 2, 1)
        alike = np.abs(self.total - across) <= ALIKE * np.maximum(self.size, self.size.transpose(0, 2, 1))
        return np.where(alike, 0.5 * (self.total + across), self.total)
