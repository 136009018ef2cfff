"""Further nodes where a frequency is near one that a piece has with its ends held: d is infinite there.

A piece in two has other such frequencies. The node between is free, so that nothing of the motion changes; modes that
rest at every joint move there.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.piece_groups import held_by

if TYPE_CHECKING:
    from vibcli.analyses.continuous.system import ContinuousSystem
    from vibcli.numerics.pieces.piece import Piece

PARTS = (0.5, 0.4375, 0.390625, 0.359375, 0.328125, 0.296875, 0.265625, 0.234375,
         1.5 - 5**0.5 / 2, 2**0.5 - 1, 2 - 3**0.5)      # the last where nodes of modes divide a piece evenly
NEAR = 2.0 ** -np.array([1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 18, 23])    # relative distances of poles looked for in z
LEAST = 2.0 ** -20      # of what is natural to the system: a z as small has poles as far away as one of this size
CLEAR = 1 / 16      # a piece without a pole as near as that stays whole,
AMONG = 1 / 4       # and one whose poles are closer together, where the n-th is about 2/n from the next


def away_from_poles(system: "ContinuousSystem", low: Any, high: Any) -> "ContinuousSystem":
    """The system with nodes within those pieces that have a frequency of their own between or near low and high."""
    places, index, least = {}, 0, float(system.scale) * LEAST
    for group in system.groups:
        pieces = [placed.piece._make(float(x) for x in placed.piece) for placed in group.pieces]
        known = _best_parts(list(dict.fromkeys(pieces)), float(low), float(high), least)
        for number, piece in enumerate(pieces, index):
            if piece in known:
                places[number] = system.number(known[piece])
        index += len(pieces)
    return system.refined(places) if places else system


def divided_at_poles(system: "ContinuousSystem", low: np.ndarray, high: np.ndarray, part: float) -> "ContinuousSystem":
    """The system with a node at this part of those pieces that have a frequency of their own between one of `low` and
    `high`."""
    crossed = (system.held(low) != system.held(high)).any(axis=1)
    return system.refined({number: system.number(part) for number in np.flatnonzero(crossed).tolist()})


def _best_parts(pieces: "list[Piece]", low: float, high: float, least: float) -> "dict[Piece, float]":
    """The parts of their length where pieces of one kind had better be divided, of those for which it is better."""
    distances, counts = _clearance(pieces, low, high, least)
    whole = dict(zip(pieces, distances.tolist(), strict=True))
    clear = dict(zip(pieces, np.minimum(CLEAR, AMONG / (counts + 1)).tolist(), strict=True))
    near = [piece for piece in pieces if whole[piece] < clear[piece]]
    if not near:
        return {}
    best: dict[Any, tuple[int, float]] = {}
    for part in PARTS:
        distances, _ = _clearance([half for piece in near for half in divided(piece, part)], low, high, least)
        for piece, worst in zip(near, distances.reshape(-1, 2).min(axis=1).tolist(), strict=True):
            best[piece] = max(best.get(piece, (whole[piece], 0.0)), (worst, -part))
        near = [piece for piece in near if best[piece][0] < clear[piece]]
        if not near:
            break
    return {piece: -part for piece, (_, part) in best.items() if part}


def _clearance(pieces: "list[Piece]", low: float, high: float, least: float) -> tuple[np.ndarray, np.ndarray]:
    """For each piece the relative distance of the widest surrounding of low … high that is without a pole of it, one of
    NEAR or 0; and the number of its poles below."""
    z = np.concatenate([low - max(abs(low), least) * NEAR, high + max(abs(high), least) * NEAR])
    held = held_by(pieces, z)
    same = held[:, :len(NEAR)] == held[:, len(NEAR):]
    return np.where(same.any(axis=1), NEAR[same.argmax(axis=1)], 0.0), held[:, len(NEAR) - 1]


def divided(piece: Any, part: Any) -> tuple[Any, Any]:
    """A piece in two at this part of its length."""
    near = piece.length * part
    return (piece._replace(length=near),
            piece._replace(length=piece.length * (1 - part), tension=piece.tension + piece.gradient * near))
