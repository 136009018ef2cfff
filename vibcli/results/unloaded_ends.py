"""Ends of members that nothing else holds, loads or moves: what they bear there is 0 in every small motion."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vibcli.mechanics.inputs_outputs.place_signals import PlaceOutput
    from vibcli.results.response_of_members import ResponseOfMembers

SAME = 1e-14        # of the length of a piece


def is_unloaded(response: "ResponseOfMembers", place: "PlaceOutput") -> bool:
    """Does a place show what an end bears whose motion is a coordinate of no other piece, matrix or load?

    N u′ and B u″ there, and B u‴ where no tension leans with the end; not where stiffness resists rates, beside which
    a bend of the start creeps back.
    """
    one, right = response.placed[place.piece], place.share > 0.5
    piece, half, given = one.piece, one.piece.order // 2, response.problem.modal.member_damping
    if one.retardation or (given is not None and given.creeps):
        return False
    if (1 - place.share if right else place.share) > SAME or place.order < half:
        return False
    if half == 1 and not piece.tension + (piece.gradient * piece.length if right else 0):
        return False
    if place.order == 3 and (piece.tension or piece.gradient):
        return False
    motion = 2 * half - 1 - place.order
    at = 2 * sum(len(other.rows) // 2 for other in response.placed[:place.piece]) + half * right + motion
    row, driven = response.ends_of_pieces[at]
    return driven is None and len(row) == 1 and _stands_alone(response, at, *row)


def _stands_alone(response: "ResponseOfMembers", at: int, i: int) -> bool:
    """Is coordinate i that of an end of a piece alone?"""
    others = any(i in row for number, (row, _) in enumerate(response.ends_of_pieces) if number != at)
    return not (others or i in response.loads or any(part[i].any() or part[:, i].any() for part in response.matrices))
