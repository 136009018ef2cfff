"""What is seen within a piece, from the fields of its end values.

A short part of a piece that is divided beside its end is so stiff that D loses the digits of all else. Where a piece
vibrates with its ends held it has no such fields: there the system is divided elsewhere.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.loads import loaded_fields
from vibcli.numerics.pieces.reaction_slopes import reaction_slope

if TYPE_CHECKING:
    from vibcli.analyses.continuous.spread_drives import SpreadDrive
    from vibcli.mechanics.factored_system import PlacedPiece


def weights_within(placed: "PlacedPiece", s: np.ndarray, share: float, order: int,
                   steep: bool) -> tuple[np.ndarray, np.ndarray | None]:
    """(∂ᵒʳᵈᵉʳu/∂xᵒʳᵈᵉʳ at a part of the length that each end value of a piece leaves, its derivative by s), (m, N)."""
    piece = placed.piece._make(float(value) for value in placed.piece)
    unit = np.eye(piece.order)

    def seen(kappa):
        return fields(piece, kappa[..., None], unit, share * piece.length)[..., order]

    kappa = _reaction(piece, s)
    if not steep:
        return seen(kappa).T, None
    slope = reaction_slope(piece, kappa, seen) * (2 * piece.inertia * s + piece.drag)[:, None]
    return seen(kappa).T, slope.T


def loaded_within(drive: "SpreadDrive", placed: "PlacedPiece", s: np.ndarray, share: float, order: int,
                  steep: bool) -> tuple[np.ndarray, np.ndarray | None]:
    """The same that a load along the piece leaves while its ends are held, (N,)."""
    piece = placed.piece._make(float(value) for value in placed.piece)
    form = drive.on(placed)
    if form is None:
        return np.zeros(len(s)), None

    def seen(kappa):
        return loaded_fields(piece, kappa, form, share * piece.length)[..., order:order + 1]

    kappa = _reaction(piece, s)
    slope = reaction_slope(piece, kappa, seen)[:, 0] * (2 * piece.inertia * s + piece.drag) if steep else None
    return seen(kappa)[:, 0], slope


def _reaction(piece, s):
    """κ, real where s is imaginary and nothing drags."""
    return piece.undamped_reaction(s.imag) if not (piece.drag or s.real.any()) else piece.reaction(s)
