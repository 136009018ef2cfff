"""How fast all free vibrations surely fade.

z = e^{−δt} y of D(s − δ) = (K − δ C + δ² M) + s (C − 2 δ M) + s² M: where none of these is negative, the energy of y
never grows.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.numerics.pieces.held_count import held_count
from vibcli.numerics.pieces.stiffness import stiffness

if TYPE_CHECKING:
    from vibcli.analyses.continuous.exact_transfer import ExactTransfer

SHARES = 1.0, 0.5, 0.25, 0.125      # of the most that drag allows
SURE = 1e-8         # of a stiffness in its own size: what is surely positive
ALIKE = 4 * 2.0**-52    # of a drag


def fading(transfer: "ExactTransfer") -> float:
    """Such a δ, 0 where none is known."""
    pieces, (_, C, M) = [one.piece for one in transfer.pieces], transfer.matrix.polynomial
    most = min((one.drag / one.inertia for one in pieces), default=0.0)
    if not most > 0 or not _none_negative(C - (1 - ALIKE) * most * M):
        return 0.0
    return next((share * most / 2 for share in SHARES if _is_held(transfer, share * most / 2)), 0.0)


def _none_negative(C: np.ndarray) -> bool:
    size = np.sqrt(np.abs(np.diagonal(C)))
    return bool((np.linalg.eigvalsh(C / np.outer(*[np.where(size, size, 1.0)] * 2)) >= -ALIKE).all())


def _is_held(transfer: "ExactTransfer", delta: float) -> bool:
    """Is D(−δ) surely positive?"""
    (K, C, M), s = transfer.matrix.polynomial, np.float64(-delta)
    D = K + s * C + s**2 * M
    for one in transfer.pieces:
        kappa = one.piece.reaction(s)
        if held_count(one.piece._replace(foundation=kappa), 0.0).any():
            return False
        rows = np.zeros((one.piece.order, transfer.n))
        for end, row in enumerate(one.rows):
            for i, x in row.items():
                rows[end, i] = x
        D = D + rows.T @ stiffness(one.piece, kappa) @ rows
    size = np.sqrt(np.diagonal(D))
    return bool((size > 0).all() and (np.linalg.eigvalsh(D / np.outer(size, size)) > SURE).all())
