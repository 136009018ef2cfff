"""The exact dynamic stiffness d(s) of pieces: forces on the ends = d(s) · end values."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.uniform import fourth_order, second_order

if TYPE_CHECKING:
    from vibcli.numerics.pieces.piece import Piece


def dynamic_stiffness(piece: "Piece", s: Any) -> np.ndarray:
    """d(s), (…, m, m): forces (Q₀, Q_l), of beams (Q₀, M₀, Q_l, M_l), on the ends moving as e^{st}, symmetric.

    s and what the piece holds are numbers or arrays that broadcast to (…). Real for real s; of doubles, or of mpmath's
    numbers (an array of objects) where one is. d(0) is the static stiffness.
    """
    return stiffness_and_slope(piece, piece.reaction(s))[0]


def stiffness_and_slope(piece: "Piece", kappa: Any) -> tuple[np.ndarray, np.ndarray]:
    """(d, ∂d/∂κ), each (…, m, m), as functions of κ = μ s² + c s + k alone.

    Undamped at ω with piece.undamped_reaction(ω), real; ∂d/∂(s²) is μ ∂d/∂κ, ∂d/∂s is (2 μ s + c) ∂d/∂κ. φᵀ ∂d/∂κ φ is
    ∫ u² dx of the deflection with end values φ.
    """
    numbers = arithmetic_of(*piece, kappa)
    values = [numbers.array(value) for value in (piece.length, piece.bending, piece.tension, kappa)]
    shape = np.broadcast_shapes(*(value.shape for value in values))
    length, bending, tension, kappa = (np.broadcast_to(value, shape).ravel() for value in values)
    if np.any(piece.gradient):
        raise NotImplementedError("tension that varies along a piece")
    if piece.order == 2:
        found = second_order(length, tension, kappa, numbers)
    else:
        found = fourth_order(length, bending, tension, kappa, numbers)
    ends = (*shape, *found[0].shape[-2:])
    return found[0].reshape(ends), found[1].reshape(ends)
