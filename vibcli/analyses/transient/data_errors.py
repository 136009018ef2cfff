"""How far the floats that a linear motion starts from may lie from the numbers of the scene.

An element's weight is a few roundings off, which keeps its row: a stiff spring between two masses errs in their
difference alone. What a sum of several loses is known to the last bit, by adding its terms without rounding.
"""

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.mechanics.factored_system import FactoredSystem

DATA = 2.0**-51     # relative, of what an expression of parameters gives
SLOPES = 3          # roundings of the product of two slopes that are no powers of two


class DataErrors(NamedTuple):
    """Bounds of the errors in K, C, M (in this order) and in the start.

    weights: of each the errors of its elements, and their rows (elements, n); entries: of each those of what is added
    up or given as a matrix, (n, n); q0, v0: (n,), of the start; rest: (n,), of the equilibrium.
    """

    weights: tuple[tuple[np.ndarray, np.ndarray], ...]
    entries: tuple[np.ndarray, ...]
    q0: np.ndarray
    v0: np.ndarray
    rest: np.ndarray

    def started(self, q0: np.ndarray, v0: np.ndarray) -> "DataErrors":
        """The same with other errors of the start."""
        return self._replace(q0=q0, v0=v0)

    def of_rest(self, output: "LinearOutput") -> float:
        """What the error of the equilibrium adds to an output."""
        return float(sum(abs(x) * self.rest[i] for i, x in output.q.items()))

    def besides(self, other: "DataErrors") -> "DataErrors":
        """The same with the errors of another start added to those of its own."""
        return self.started(self.q0 + other.q0, self.v0 + other.v0)


def of_matrices(M: np.ndarray, C: np.ndarray, K: np.ndarray) -> DataErrors:
    """Of matrices that are given as they are, and a start."""
    n = len(M)
    none = np.zeros(0), np.zeros((0, n))
    return DataErrors((none,) * 3, tuple(np.zeros((n, n)) for _ in range(3)), *np.zeros((3, n)))


def of_elements(elements: "FactoredSystem", matrices: Sequence[np.ndarray], start: tuple[np.ndarray, np.ndarray],
                rest: np.ndarray) -> DataErrors:
    """Of elements whose sums are `matrices` (M, C, K); start: places and velocities; rest: the errors of the places in
    equilibrium, from which the motion is counted."""
    M, C, K = matrices
    size = elements.K_size or {pair: abs(x) for pair, x in elements.K.items()}
    parts = ((elements.springs, (elements.K,), size, K),
             (elements.dampers, (elements.C, elements.drag, elements.G), {}, C),
             (elements.inertias, (elements.M,), {}, M))
    weights = tuple(_weights(rows, elements.n) for rows, *_ in parts)
    entries = tuple(_entries(*part) for part in parts)
    places, speeds = start
    return DataErrors(weights, entries, DATA * np.abs(places) + 2 * rest, DATA * np.abs(speeds), rest)


def _weights(rows: Sequence[tuple[float, dict[int, float]]], n: int) -> tuple[np.ndarray, np.ndarray]:
    dense = np.zeros((len(rows), n))
    for at, (_, row) in enumerate(rows):
        for i, x in row.items():
            dense[at, i] = x
    return DATA * np.abs(np.array([weight for weight, _ in rows], float)), dense


def _entries(rows: Sequence[tuple[float, Mapping[int, float]]], given: Any, size: Mapping[Any, float],
             total: np.ndarray) -> np.ndarray:
    """The errors of the sums Σ w xᵢ xⱼ + given."""
    terms: dict[Any, list[float]] = {}
    found = np.zeros(total.shape)
    for weight, row in rows:
        for i, x in row.items():
            for j, y in row.items():
                terms.setdefault((i, j), []).append(weight * x * y)
                if not (_is_power(x) and _is_power(y)):
                    found[i, j] += SLOPES * DATA * abs(weight * x * y)
    for matrix in given:
        for pair, x in matrix.items():
            terms.setdefault(pair, []).append(x)
            found[pair] += 2 * DATA * size.get(pair, abs(x))
    for pair, parts in terms.items():
        found[pair] += abs(math.fsum([*parts, -total[pair]]))
    return found


def _is_power(x: float) -> bool:
    """Is it a power of two, with which nothing is rounded?"""
    return abs(math.frexp(x)[0]) == 0.5 or not x
