"""Further nodes where a frequency is near one that a piece has with its ends held: d is infinite there.

A piece in two has other such frequencies. The node between is free, so that nothing of the motion changes; modes that
rest at every joint move there.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.piece_groups import held_by

if TYPE_CHECKING:
    from vibcli.analyses.continuous.system import ContinuousSystem

PARTS = 0.5, 0.4375, 0.390625, 0.359375, 0.328125, 0.296875, 0.265625, 0.234375
NEAR = 2.0 ** -np.arange(1, 24)     # relative distances in z at which poles are looked for
CLEAR = 3                           # place in NEAR: a piece without a pole as near as that stays whole


def away_from_poles(system: "ContinuousSystem", low: Any, high: Any) -> "ContinuousSystem":
    """The system with nodes within those pieces that have a frequency of their own between or near low and high."""
    places, known = {}, {}
    for index, placed in enumerate(system.ordered):
        piece = placed.piece
        if piece not in known:
            known[piece] = _best_part(piece, low, high, system.number)
        if known[piece] is not None:
            places[index] = known[piece]
    return system.refined(places) if places else system


def _best_part(piece, low, high, number):
    """The part of its length where a piece had better be divided; None where it is well as it is."""
    whole = _clearance([piece], low, high)[0]
    if whole < CLEAR:
        return None
    parts = [number(share) for share in PARTS]
    distances = _clearance([half for part in parts for half in divided(piece, part)], low, high)
    worst = distances.reshape(-1, 2).max(axis=1)
    best = int(np.argmin(worst))
    return parts[best] if worst[best] < whole else None


def _clearance(pieces, low, high):
    """For each piece the place in NEAR of the widest surrounding of low … high that is without a pole of it."""
    widths = NEAR if not hasattr(low, "_mpf_") else [type(low)(x) for x in NEAR.tolist()]
    held = held_by(pieces, [low - abs(low) * x for x in widths] + [high + abs(high) * x for x in widths])
    same = held[:, :len(NEAR)] == held[:, len(NEAR):]
    return np.where(same.any(axis=1), same.argmax(axis=1), len(NEAR))


def divided(piece: Any, part: Any) -> tuple[Any, Any]:
    """A piece in two at this part of its length."""
    near = piece.length * part
    return (piece._replace(length=near),
            piece._replace(length=piece.length * (1 - part), tension=piece.tension + piece.gradient * near))
