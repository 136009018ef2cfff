"""What moves without a force: a basis of what the springs and pieces at rest leave free, xᵀ ∂D/∂s² x = 1."""

from typing import TYPE_CHECKING, Any, cast

import numpy as np

from vibcli.analyses.modal.rigid_body_modes import rank
from vibcli.analyses.modal.scaling import mechanism
from vibcli.numerics.sparse_elimination import product

if TYPE_CHECKING:
    from vibcli.analyses.continuous.system import ContinuousSystem
    from vibcli.mechanics.factored_system import FactoredSystem


def never_grows(elements: Any) -> bool:
    """Is all stiffness that of springs and pieces which cannot be negative?"""
    if any(elements.K.values()) or any(k < 0 for k, _ in elements.springs):
        return False
    return not any(placed.piece.tension < 0 or placed.piece.foundation < 0 or placed.piece.gradient
                   for placed in elements.pieces)


def rigid_count(elements: Any) -> int:
    """How many motions nothing resists, whatever its stiffness is; those that entries of K touch are not among them."""
    return cast("int", elements.n - rank(elements.n, _rows(elements)))


def _rows(elements: "FactoredSystem") -> list[dict[int, float]]:
    """The rows of all springs, those of pieces at rest among them, and of what is no spring."""
    rows = [row for k, row in elements.static_springs if k]
    rows += [row for placed in elements.pieces if placed.piece.foundation for row in placed.rows]
    return rows + [{i: 1.0} for i in {i for pair, x in elements.K.items() if x for i in pair}]


def rigid_shapes(elements: Any, system: "ContinuousSystem", count: int) -> np.ndarray:
    """`count` shapes in columns, (n, count): the first coordinates that can move alone do, one after another."""
    rows = [{i: float(x) for i, x in row.items()} for row in _rows(elements)]
    full = np.array([[row.get(i, 0.0) for i in range(elements.n)] for row in rows]).reshape(len(rows), elements.n)
    full /= np.maximum(abs(full).max(axis=1, keepdims=True), 1e-300) if len(rows) else 1.0
    size = abs(full).max(axis=0, initial=0.0)
    unit = 1 / np.where(size > 0, size, 1.0)        # what no row touches is free whatever its unit
    free = np.linalg.svd(full * unit)[2][elements.n - count:].T * unit[:, None]
    free = _by_leaders(free / abs(free).max(axis=0))
    return _normalised(system, np.array([system.numbers(row) for row in free]))


def _by_leaders(free: np.ndarray) -> np.ndarray:
    """The same space with columns of which each alone moves its leading coordinate."""
    leaders: list[int] = []
    for i in range(len(free)):
        if np.linalg.matrix_rank(free[[*leaders, i]], tol=1e-9) > len(leaders):
            leaders.append(i)
    found = free @ np.linalg.inv(free[leaders])
    return np.where(abs(found) < 1e-13 * abs(found).max(), 0.0, found)


def _normalised(system: "ContinuousSystem", shapes: Any) -> np.ndarray:
    """Columns made orthogonal and of unit inertia, in turn; UnheldCoordinate of one that has none."""
    _, _, inertia = system.dynamic_stiffness(system.numbers([0]))
    for k in range(shapes.shape[1]):
        for other in range(k):
            moved = product(system.pattern, inertia, shapes[:, other:other + 1])[:, 0]
            shapes[:, k] = shapes[:, k] - shapes[:, other] * (moved * shapes[:, k]).sum()
        size = (product(system.pattern, inertia, shapes[:, k:k + 1])[:, 0] * shapes[:, k]).sum()
        if not size > 0:
            raise mechanism(int(np.flatnonzero(shapes[:, k])[0]))
        shapes[:, k] = shapes[:, k] / size ** 0.5
    return cast("np.ndarray", shapes)
