"""What moves freely, told apart from what K in floats makes of it.

K R = 0 holds of rigid motions R, but of K in floats only where nothing was rounded: with a gear ratio in it K r is as
large as a rounding, and λ = 0 comes out as 1e-13 rad/s, of either sign. In the coordinates u of q = T u, T = [R, E]
with unit vectors E of all coordinates but some that R moves, K has zeros in the rows and columns of R, and C has them
in those of what no damper resists.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.transient.static_condensation import leading
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.transient.modal_block import ModalBlock

EPSILON = 2.0**-52
NONE = 1e-8         # relative: a motion that these coordinates do not take part in
ROUNDINGS = 16
ALIKE = 1 - 1e-9    # relative: rows of which rounding does not tell the longer one


class Freed(NamedTuple):
    """M, C, K of u, q = T u; zeros: how many eigenvalues vanish exactly."""

    M: np.ndarray
    C: np.ndarray
    K: np.ndarray
    T: np.ndarray
    zeros: int

    def back(self, block: "ModalBlock") -> "ModalBlock":
        """A ModalBlock of u as one of q."""
        inverse = np.linalg.inv(self.T)
        return block._replace(X=self.T @ block.X, P=block.P @ inverse, R=block.R @ inverse, W=block.W @ self.T.T)


def freed(M: np.ndarray, C: np.ndarray, K: np.ndarray, rigid: np.ndarray) -> Freed | None:
    """The Freed of M, C, K, symmetric K, and of what moves freely, columns of `rigid`; None where nothing of it moves
    these coordinates, or not those that have inertia."""
    Q, sizes, _ = np.linalg.svd(rigid, full_matrices=False)
    Q = Q[:, sizes > NONE * max(1.0, sizes.max(initial=0.0))]
    heavy = leading(M, C)[0]
    if not Q.shape[1] or np.linalg.svd(Q[:heavy], compute_uv=False).min(initial=1.0) < NONE:
        return None
    _, resisted, turn = np.linalg.svd(C @ Q, full_matrices=False)
    loose = resisted <= ROUNDINGS * len(M) * EPSILON * np.abs(C).max(initial=0.0)
    Q = Q @ turn.T
    T, own = np.eye(len(M)), []
    for part in (Q[:, loose], Q[:, ~loose]):
        part = part - T.take(own, 1) @ part[own]
        places = _places(part[:heavy])
        for place, column in zip(places, (part @ np.linalg.inv(part[places])).T, strict=True):
            T[:, place] = column
        own += places
    free = own[:int(loose.sum())]
    K, C = _without(K, own), _without(T.T @ C @ T, free)
    return Freed(T.T @ M @ T, C, K, T, len(own) + len(free))


def exact(blocks: "Sequence[ModalBlock]") -> int:
    """How many eigenvalues of all blocks are exactly zero."""
    return sum(not node for block in blocks for node in block.nodes)


def _without(matrix: np.ndarray, places: list[int]) -> np.ndarray:
    """A matrix with zeros in some of its rows and columns."""
    kept = np.ones(len(matrix))
    kept[places] = 0.0
    found: np.ndarray = kept[:, None] * matrix * kept
    return found


def _places(columns: np.ndarray) -> list[int]:
    """As many rows as there are columns, on which they are far from dependent: each the longest one of what the others
    leave (QR with pivots, Golub and Van Loan 2013, 5.4.2), of those alike the first."""
    left, found = columns.copy(), []
    for _ in range(columns.shape[1]):
        sizes = np.linalg.norm(left, axis=1)
        found.append(int(np.argmax(sizes >= ALIKE * sizes.max())))
        along = left[found[-1]] / sizes[found[-1]]
        left -= np.outer(left @ along, along)
    return found
