"""Deflection, slope and higher derivatives along pieces from their end values."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.uniform_fields import fourth_order_fields, second_order_fields

if TYPE_CHECKING:
    from vibcli.numerics.pieces.piece import Piece


def fields(piece: "Piece", kappa: Any, ends: Any, x: Any) -> np.ndarray:
    """(u, u′) of bars, (u, u′, u″, u‴) of beams at 0 ≤ x ≤ length, (…, order), moving with end values (…, order).

    All else broadcasts to (…), κ as in stiffness_and_slope. The force N u′ − B u‴ and the moment B u″ follow. A piece
    that vibrates while its ends rest has no field of end values: divide it elsewhere.
    """
    numbers = arithmetic_of(*piece, kappa, ends, x)
    ends = numbers.array(ends)
    values = [numbers.array(value) for value in (piece.length, piece.bending, piece.tension, kappa, x)]
    shape = np.broadcast_shapes(*(value.shape for value in values), ends.shape[:-1])
    length, bending, tension, kappa, x = (np.broadcast_to(value, shape).ravel() for value in values)
    ends = np.broadcast_to(ends, (*shape, piece.order)).reshape(-1, piece.order)
    half, rest = length / 2, length - x
    near = np.where(x < rest, x, rest) / half
    xi = np.where(x < rest, near - 1, 1 - near)
    if piece.order == 2:
        found = second_order_fields(xi, near, half, tension, kappa, ends, numbers)
    else:
        found = fourth_order_fields(xi, near, half, bending, tension, kappa, ends, numbers)
    return found.reshape(*shape, piece.order)
