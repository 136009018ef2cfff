"""Deflection, slope and higher derivatives along pieces from their end values."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.numerics.pieces.flattening import flattened
from vibcli.numerics.pieces.uniform_fields import fourth_order_fields, second_order_fields

if TYPE_CHECKING:
    from vibcli.numerics.pieces.piece import Piece


def fields(piece: "Piece", kappa: Any, ends: Any, x: Any) -> np.ndarray:
    """(u, u′) of bars, (u, u′, u″, u‴) of beams at 0 ≤ x ≤ length, (…, order), moving with end values (…, order).

    All else broadcasts to (…), κ as in stiffness_and_slope. The force N u′ − B u‴ and the moment B u″ follow. A piece
    that vibrates while its ends rest has no field of end values: divide it elsewhere.
    """
    ends = np.asarray(ends)
    flat = flattened(piece, kappa, x, *(ends[..., i] for i in range(ends.shape[-1])))

    def uniform(one: "Piece", kappa: np.ndarray, x: np.ndarray, *ends: np.ndarray) -> np.ndarray:
        half, rest = one.length / 2, one.length - x
        near = np.where(x < rest, x, rest) / half
        xi = np.where(x < rest, near - 1, 1 - near)
        if flat.order == 2:
            return second_order_fields(xi, near, half, one.tension, kappa, np.array(ends).T, flat.numbers)
        return fourth_order_fields(xi, near, half, one.bending, one.tension, kappa, np.array(ends).T,
                                   flat.numbers)

    def graded(one: "Piece", kappa: np.ndarray, x: np.ndarray, *ends: np.ndarray) -> np.ndarray:
        from vibcli.numerics.pieces.graded import graded_fields

        return graded_fields(one, kappa, np.array(ends).T, x, flat.numbers)

    return flat.filled((flat.order,), uniform, graded)
