"""The pieces of members in a linearisation: the rows of the displacements of their ends."""

from collections.abc import Callable, Sequence
from itertools import islice
from typing import TYPE_CHECKING, Any

from vibcli.mechanics.factored_system import PlacedPiece
from vibcli.numerics.pieces.piece import Piece

if TYPE_CHECKING:
    from vibcli.scene.piece_terms import PieceTerm


def exact_springs(piece: PlacedPiece) -> list:
    """The springs at rest of a piece in numbers, whose tension varies along it if it is that of a beam: by elimination
    in d(0), which u₀ = u_l leaves without force, in terms of u_l − u₀, u₀′, u_l′."""
    from vibcli.numerics.pieces.stiffness import dynamic_stiffness

    if piece.piece.order == 2 or not piece.piece.gradient:
        return piece.springs
    first, turned, last, turned_last = piece.rows
    apart = {i: last.get(i, 0) - first.get(i, 0) for i in {*first, *last}}
    rows, d = [apart, turned, turned_last], dynamic_stiffness(piece.piece, 0)
    k = [[d[i][j] for j in (2, 1, 3)] for i in (2, 1, 3)]
    found = []
    for i in range(3):
        share = [k[i][j] / k[i][i] for j in range(3)]
        row: dict = {}
        for j in range(i, 3):
            for q, x in rows[j].items():
                row[q] = row.get(q, 0) + share[j] * x
        found.append((k[i][i], {q: x for q, x in row.items() if x}))
        k = [[k[a][b] - share[a] * share[b] * k[i][i] for b in range(3)] for a in range(3)]
    return found


def placed_pieces(terms: "Sequence[PieceTerm]", row_of: Callable, elastic: Sequence[Any]) -> list[PlacedPiece]:
    """The PlacedPieces of the terms, each with those of the springs `elastic` that are its own."""
    springs = iter(elastic)
    return [PlacedPiece(term.owner, term.start, Piece(*term.coefficients), tuple(map(row_of, term.s)),
                        list(islice(springs, term.springs))) for term in terms]
