"""The pieces of members in a linearisation: the rows of the displacements of their ends."""

from collections.abc import Callable, Sequence
from itertools import islice
from typing import TYPE_CHECKING

from vibcli.mechanics.factored_system import PlacedPiece
from vibcli.numerics.pieces.piece import Piece

if TYPE_CHECKING:
    from vibcli.scene.piece_terms import PieceTerm
    from vibcli.symbolic.node import Node


def placed_pieces(terms: "Sequence[PieceTerm]", row_of: "Callable[..., dict[int, Node]]",
                  elastic: "Sequence[tuple[Node, dict[int, Node]]]") -> list[PlacedPiece]:
    """The PlacedPieces of the terms, each with those of the springs `elastic` that are its own."""
    springs = iter(elastic)
    return [PlacedPiece(term.owner, term.start, Piece(*term.coefficients), tuple(map(row_of, term.s)),
                        list(islice(springs, term.springs))) for term in terms]
