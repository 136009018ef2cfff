"""Pieces with further nodes, which are free to move."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.numerics.pieces.piece import Piece


def divided_at(placed: "PlacedPiece", x: Any, n: int) -> "list[PlacedPiece]":
    """A piece in two at x from its left end: the node between has the coordinate n, of beams n and n + 1."""
    piece, half = placed.piece, placed.piece.order // 2
    node = tuple({n + i: 1.0} for i in range(half))
    right = piece._replace(length=piece.length - x, tension=piece.tension + piece.gradient * x)
    if piece.order == 2 and piece.gradient and _ends_slack(piece):      # so does the shorter one, where x rounds
        right = right._replace(gradient=-right.tension / right.length)
    return [placed._replace(piece=piece._replace(length=x), rows=(*placed.rows[:half], *node)),
            placed._replace(piece=right, rows=(*node, *placed.rows[half:]), start=placed.start + x)]


def _ends_slack(piece: "Piece") -> bool:
    from vibcli.numerics.pieces.graded import mirrored
    from vibcli.numerics.pieces.graded_parts import is_slack

    return is_slack(mirrored(piece))
