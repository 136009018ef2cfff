"""What is seen at a place within a piece: in floats by the fields of its end values, which lose no digits beside an
end; else as rows of the motions of nodes, the piece being divided there.

With Q, M the forces and moments on the ends of a piece, positive along u and as turns, the right end of the left piece
and the left end of the right one show

    B = 0      N u′ = Q_l = −Q₀
    beams      B u″ = M_l = −M₀,  B u‴ = N u′ − Q_l = N u′ + Q₀.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vibcli.analyses.continuous.divided_pieces import divided_at
from vibcli.analyses.frequency_response.member_system import MemberOutput

if TYPE_CHECKING:
    from collections.abc import Sequence

    import mpmath

    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.mechanics.inputs_outputs.place_signals import PlaceOutput


def seen_at(place: "PlaceOutput", pieces: "Sequence[PlacedPiece]", n: int,
            number: Any = float) -> "tuple[list[PlacedPiece], int, MemberOutput]":
    """(pieces divided at a place, how many coordinates they have with the new node, the MemberOutput); pieces: all of
    a scene of n coordinates; number: makes a number of its arithmetic."""
    pieces, k, share = list(pieces), place.piece, number(place.share)
    if number is float and 0 < share < 1:
        return pieces, n, MemberOutput(({}, {}, {}), (), ((float(place.factor), k, share, place.order),))
    if 0 < share < 1:
        half = pieces[k].piece.order // 2
        pieces[k:k + 1] = divided_at(pieces[k], share * pieces[k].piece.length, n)
        k, n, share = k + 1, n + half, number(0)
    return pieces, n, _derivative(pieces[k], k, share == 1, place.order, number(place.factor))


def _derivative(placed: "PlacedPiece", k: int, right: bool, order: int, factor: "float | mpmath.mpf") -> MemberOutput:
    """A derivative of u at the right end of a piece, else at its left one, times a factor."""
    piece, half = placed.piece, placed.piece.order // 2
    first, sign = (half, 1.0) if right else (0, -1.0)
    tension = piece.tension + piece.gradient * piece.length if right else piece.tension
    if order < half:
        return MemberOutput((_scaled(placed.rows[first + order], factor), {}, {}))
    if half == 1:
        return MemberOutput(({}, {}, {}), ((sign * factor / tension, k, first),))
    if order == 2:
        return MemberOutput(({}, {}, {}), ((sign * factor / piece.bending, k, first + 1),))
    row = _scaled(placed.rows[first + 1], factor * tension / piece.bending)
    return MemberOutput((row, {}, {}), ((-sign * factor / piece.bending, k, first),))


def _scaled(row: Mapping[Any, Any], factor: "float | mpmath.mpf") -> dict[Any, Any]:
    return {i: x * factor for i, x in row.items() if x and factor}
