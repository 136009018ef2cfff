"""Loads spread along pieces: what they put on the ends, and the deflection that they leave between held ends."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.numerics.pieces.arithmetic import arithmetic_of
from vibcli.numerics.pieces.fields import fields
from vibcli.numerics.pieces.panels import panel_rule
from vibcli.numerics.pieces.piece import Piece
from vibcli.numerics.pieces.stiffness import stiffness_and_slope

if TYPE_CHECKING:
    from vibcli.numerics.pieces.arithmetic import Arithmetic

AT_ONCE = 200_000       # fields at a time


def end_loads(piece: Piece, kappa: Any, load: Callable[[np.ndarray], np.ndarray], rate: float) -> np.ndarray:
    """∫ q H_i dx, (…, order): what acts on the ends in place of a load q(x) e^{st}: d · ends = forces + these.

    H_i is the field with the i-th end value 1, so that ∫ q u dx of a field is these times its end values. q: an array
    function of x, smooth on the piece; rate: the largest |λ| of its e^{λx}, 0 of polynomials. By Gauss's rule to
    rounding, whatever κ: nothing is divided by what vanishes at resonance of q's own form or at rest.
    """
    numbers = arithmetic_of(*piece, kappa)
    return _end_loads(piece, numbers.array(kappa), 0, load, rate, numbers)


def _end_loads(piece: Piece, kappa: np.ndarray, origin: Any, load: Callable, rate: float,
               numbers: "Arithmetic") -> np.ndarray:
    """With x counted on from an origin each, arrays."""
    y, weights = panel_rule(piece, kappa, rate, numbers)
    shape = np.broadcast_shapes(kappa.shape, np.shape(origin), *(np.shape(value) for value in piece))
    arrays = [np.broadcast_to(numbers.array(value), shape).reshape(-1, 1, 1) for value in (*piece, kappa, origin)]
    step, found = max(1, AT_ONCE // (len(y) * piece.order)), []
    unit = numbers.array(np.eye(piece.order))[:, None, :]
    for i in range(0, len(arrays[0]), step):
        *some, at, start = (values[i:i + step] for values in arrays)
        x = some[0] * y
        shapes = fields(Piece(*some), at, unit, x)[..., 0]
        found.append((shapes * load(start + x) * weights).sum(axis=-1) * some[0][..., 0])
    return np.concatenate(found).reshape((*shape, piece.order))


def loaded_fields(piece: Piece, kappa: Any, load: Callable[[np.ndarray], np.ndarray], rate: float,
                  x: Any) -> np.ndarray:
    """(u, u′) or (u, u′, u″, u‴) at 0 ≤ x ≤ length under a load between ends that are held, (…, order).

    As of `fields`, to which it adds. The piece is cut at x, where the ends of both parts take what is spread on them.
    """
    numbers = arithmetic_of(*piece, kappa, x)
    values = np.broadcast_arrays(*(numbers.array(value) for value in (*piece, kappa, x)))
    *coefficients, kappa, x = (value.reshape(-1) for value in values)
    whole, h = Piece(*coefficients), piece.order // 2
    moved, pulled = np.zeros((2, len(x), h), np.result_type(kappa, x, load(x[:1])))
    inside = (x > 0) & (x < whole.length)
    if inside.any():
        parts = Piece(*(value[inside] for value in whole)), kappa[inside], x[inside]
        moved[inside], pulled[inside] = _cut(*parts, load, rate, numbers)
    if not inside.all():
        ends = _end_loads(Piece(*(value[~inside] for value in whole)), kappa[~inside], 0, load, rate, numbers)
        pulled[~inside] = np.where((x[~inside] > 0)[:, None], -ends[:, h:], ends[:, :h])
    return _state(whole, x, moved, pulled).reshape((*values[0].shape, piece.order))


def _cut(piece, kappa, x, load, rate, numbers):
    """(u, u′) and (N u′ − B u‴, B u″) at cuts, of beams; (u), (N u′) else."""
    h = piece.order // 2
    left = piece._replace(length=x)
    right = piece._replace(length=piece.length - x, tension=piece.tension + piece.gradient * x)
    own, other = stiffness_and_slope(left, kappa)[0], stiffness_and_slope(right, kappa)[0]
    force = _end_loads(left, kappa, 0 * x, load, rate, numbers)[:, h:]
    both = force + _end_loads(right, kappa, x, load, rate, numbers)[:, :h]
    moved = (numbers.inverse(own[:, h:, h:] + other[:, :h, :h]) @ both[..., None])[..., 0]
    return moved, (own[:, h:, h:] @ moved[..., None])[..., 0] - force


def _state(piece, x, moved, pulled):
    if moved.shape[-1] == 1:
        return np.stack([moved[:, 0], pulled[:, 0] / (piece.tension + piece.gradient * x)], axis=-1)
    third = ((piece.tension + piece.gradient * x) * moved[:, 1] - pulled[:, 0]) / piece.bending
    return np.stack([moved[:, 0], moved[:, 1], pulled[:, 1] / piece.bending, third], axis=-1)
