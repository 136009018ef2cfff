"""What is seen within a piece, from the fields of its end values.

A short part of a piece that is divided beside its end is so stiff that D loses the digits of all else. Where a piece
vibrates with its ends held it has no such fields: there the system is divided elsewhere.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.loads import loaded_fields
from vibcli.numerics.pieces.reaction_slopes import reaction_slope
from vibcli.numerics.pieces.retardation import reaction_rate, retarded_reaction

if TYPE_CHECKING:
    from vibcli.analyses.continuous.spread_drives import SpreadDrive
    from vibcli.mechanics.factored_system import PlacedPiece


def weights_within(placed: "PlacedPiece", s: np.ndarray, share: float, order: int,
                   steep: bool) -> tuple[np.ndarray, np.ndarray | None]:
    """(∂ᵒʳᵈᵉʳu/∂xᵒʳᵈᵉʳ at a part of the length that each end value of a piece leaves, its derivative by s), (m, N)."""
    piece = placed.piece._make(float(value) for value in placed.piece)
    unit = np.eye(piece.order)

    def seen(kappa: np.ndarray) -> np.ndarray:
        return fields(piece, kappa[..., None], unit, share * piece.length)[..., order]

    kappa = retarded_reaction(piece, s, placed.retardation)
    if not steep:
        return seen(kappa).T, None
    slope = reaction_slope(piece, kappa, seen) * reaction_rate(piece, s, placed.retardation)[:, None]
    return seen(kappa).T, slope.T


def loaded_within(drive: "SpreadDrive", placed: "PlacedPiece", s: np.ndarray, share: float, order: int,
                  steep: bool) -> tuple[np.ndarray, np.ndarray | None]:
    """The same that a load along the piece leaves while its ends are held, (N,)."""
    piece, beta = placed.piece._make(float(value) for value in placed.piece), float(placed.retardation)
    form = drive.on(placed)
    if form is None:
        return np.zeros(len(s)), None

    def seen(kappa: np.ndarray) -> np.ndarray:
        return loaded_fields(piece, kappa, form, share * piece.length)[..., order:order + 1]

    kappa, factor = retarded_reaction(piece, s, beta), 1 + beta * s if beta else 1.0
    found = seen(kappa)[:, 0]
    if not steep:
        return found / factor, None
    slope = reaction_slope(piece, kappa, seen)[:, 0] * reaction_rate(piece, s, beta)
    return found / factor, (slope - beta * found / factor) / factor
