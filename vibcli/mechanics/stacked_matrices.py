"""M, C and K of a scene at many values of its parameters, by one walk over its expressions with arrays of numbers.

    M = Σ w ∇s ∇sᵀ + M₊      C = Σ c ∇s ∇sᵀ + C₊      K = Σ k ∇s ∇sᵀ + Σ V′ ∇²s + K₊

Beside each stands the sum of the sizes of its terms, the scale of its rounding.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from vibcli.mechanics.linearisation import nodes_of, residual_terms
from vibcli.symbolic.array_arithmetic import Arrays
from vibcli.symbolic.evaluation import evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.linearisation import Linearisation

BALANCED = 2.0**-50      # of the sizes of so many terms and two


class StackedMatrices(NamedTuple):
    """Arrays of N × n × n numbers; balanced: N truths, are the forces in balance but for rounding?"""

    M: np.ndarray
    K: np.ndarray
    M_size: np.ndarray
    K_size: np.ndarray
    C: np.ndarray
    C_size: np.ndarray
    balanced: np.ndarray


def stacked_matrices(form: "Linearisation", values: Mapping[str, np.ndarray], count: int) -> StackedMatrices:
    """Those of a Linearisation without members, {symbol: array of `count` numbers}; NaN where it has no value."""
    nodes = list(dict.fromkeys(nodes_of(form)))
    with np.errstate(all="ignore"):
        known = dict(zip(nodes, (np.broadcast_to(x, (count,)) for x in evaluate(nodes, Arrays, values)), strict=True))
        M, C, K = (_Sums(count, form.n) for _ in range(3))
        for sums, terms in ((M, form.inertias), (C, form.dampers), (K, form.springs)):
            for weight, row in terms:
                sums.add_square(known[weight], {i: known[x] for i, x in row.items()})
        for sums, entries in ((M, form.M), (C, form.C)):
            for pair, node in entries.items():
                sums.add(pair, known[node])
        for force, curvature, _ in form.curved:
            for pair, second in curvature.items():
                K.add(pair, known[force] * known[second])
        for part in form.K:
            for pair, node in part.items():
                K.add(pair, known[node])
        return StackedMatrices(M.total, K.total, M.size, K.size, C.total, C.size,
                               _balanced(form, values, count))


def _balanced(form, values, count):
    """Do the forces balance in the position of the form, but for the rounding of their terms?"""
    found = np.ones(count, dtype=bool)
    for terms in residual_terms(form):
        parts = [np.broadcast_to(x, (count,)) for x in evaluate(terms, Arrays, values)]
        if parts:
            found &= np.abs(sum(parts)) <= BALANCED * (len(parts) + 2) * sum(map(np.abs, parts))
    return found


class _Sums:
    """Matrices that are added up, and the sizes of their terms."""

    def __init__(self, count, n):
        self.total, self.size = np.zeros((count, n, n)), np.zeros((count, n, n))

    def add(self, pair: tuple[int, int], term: np.ndarray) -> None:
        self.total[:, pair[0], pair[1]] += term
        self.size[:, pair[0], pair[1]] += np.abs(term)

    def add_square(self, weight: np.ndarray, row: "Mapping[int, np.ndarray]") -> None:
        for i, x in row.items():
            for j, y in row.items():
                self.add((i, j), weight * x * y)
