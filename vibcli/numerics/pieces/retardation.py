"""Pieces whose stiffness resists rates too (Kelvin and Voigt), B and N having the factor 1 + β s, as k has:

    (1 + β s) (B u⁗ − ((N + n x) u′)′ + k u) + (μ s² + c s) u = q

so that u is that of κ = k + (μ s² + c s)/(1 + β s), under q/(1 + β s).
"""

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from vibcli.numerics.pieces.piece import Piece


def retarded_reaction(piece: "Piece", s: Any, beta: Any) -> Any:
    """κ; real where s is imaginary and nothing damps."""
    if np.any(beta):
        return piece.foundation + (piece.inertia * s + piece.drag) * s / (1 + beta * s)
    return piece.reaction(s) if np.any(piece.drag) or np.any(np.real(s)) else piece.undamped_reaction(s.imag)


def reaction_rate(piece: "Piece", s: Any, beta: Any) -> Any:
    """dκ/ds."""
    rate = 2 * piece.inertia * s + piece.drag
    if not np.any(beta):
        return rate
    return (rate - beta * (piece.inertia * s + piece.drag) * s / (1 + beta * s)) / (1 + beta * s)
