"""∫ u v dx of two fields of a piece: modal masses and orthogonality."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.panels import panel_rule
from vibcli.numerics.pieces.stiffness import stiffness_and_slope

if TYPE_CHECKING:
    from vibcli.numerics.pieces.piece import Piece

APART = 0.1     # κ that differ by more than this part of the larger are told apart by Green's identity


def product_integral(piece: "Piece", kappa: Any, ends: Any, other_kappa: Any, other_ends: Any) -> Any:
    """∫ u v dx over one piece, of the fields with end values at κ and other end values at another κ, numbers; times μ
    the mass that two motions share.

    At one κ it is endsᵀ ∂d/∂κ ends; else (κ − κ₂) ∫ u v dx = v_endsᵀ (d(κ) − d(κ₂)) u_ends by Green's identity, and by
    Gauss's rule where the difference would leave few digits.
    """
    numbers = arithmetic_of(*piece, kappa, ends, other_kappa, other_ends)
    ends, other_ends = numbers.array(ends), numbers.array(other_ends)
    d, slope = stiffness_and_slope(piece, kappa)
    difference = kappa - other_kappa
    if difference == 0:
        return other_ends @ slope @ ends
    if abs(difference) > APART * max(abs(kappa), abs(other_kappa)):
        return other_ends @ (d - stiffness_and_slope(piece, other_kappa)[0]) @ ends / difference
    y, weights = panel_rule(piece, kappa, 0.0, numbers)
    u, v = (fields(piece, at, values, piece.length * y)[:, 0]
            for at, values in ((kappa, ends), (other_kappa, other_ends)))
    return np.sum(weights * u * v) * piece.length
