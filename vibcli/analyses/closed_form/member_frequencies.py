"""Frequency equations of members as textbooks write them: βL·tan βL = μL/M, cos βL·cosh βL = −1.

A chain of one or two uniform pieces, bars end to end or a beam with something at an inner place, whose stations carry
what acts on one motion each: masses, springs to the ground, oscillators. Of what is coupled otherwise there is none.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.frequency_functions import UniformPiece, frequency_function
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.symbolic_matrices import matrices_in_letters
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.symbolic.node import Node

MOST = 2            # pieces of a chain whose equation is written out
WAVE_NUMBER = "βL"      # of notation.PRODUCTS


class FrequencyEquation(NamedTuple):
    """What vanishes at the natural frequencies of the `members`: {functions of the arguments: coefficient}; βL, β that
    of the first piece and L the length of the chain, ω² by βL, the argument of each piece, what acts on the stations,
    and the coordinates of what hangs on those."""

    members: tuple
    order: int
    wave_number: "Node"
    square: "Node"
    arguments: list
    function: dict
    pieces: "list[PlacedPiece]"
    impedances: "list[tuple]"
    hung: list


def frequency_equations(symbolic: "SymbolicSystem") -> "list[FrequencyEquation | None]":
    """One of each chain of pieces; None of those for which there is none in closed form."""
    form = symbolic.linearisation
    return [_equation(form, chain) for chain in chains(form.pieces)]


def chains(pieces: "Sequence[PlacedPiece]") -> "list[list[PlacedPiece]]":
    """The pieces in chains from left to right, those of each member and of members that begin where others end."""
    found: list = []
    for piece in pieces:
        if found and found[-1][-1].owner == piece.owner:
            found[-1].append(piece)
        else:
            found.append([piece])
    for chain in list(found):
        before = next((one for one in found if one is not chain and _end(one[-1], 1) == _end(chain[0], 0) != ()), None)
        if before is not None:
            before += chain
            found = [one for one in found if one is not chain]
    return found


def _end(placed, side):
    """The rows of its left (0) or right (1) end; () where all of that is held."""
    half = len(placed.rows) // 2
    rows = placed.rows[side * half:][:half]
    return tuple(rows) if any(rows) else ()


def _equation(form, chain):
    pressed = [part for part in chain if not (part.piece.bending.is_zero or part.piece.tension.is_zero)]
    if len(chain) > (1 if pressed else MOST) or not all(part.piece.gradient.is_zero for part in chain) or any(
            len(row) > 1 for part in chain for row in part.rows):
        return None
    elsewhere = {i for piece in form.pieces if piece not in chain for row in piece.rows for i in row}
    M, _, G, K = matrices_in_letters(form)
    table, first = form.table, chain[0].piece
    x, order = table.parameter(WAVE_NUMBER), 2 if first.bending.is_zero else 4
    stiffness = _stiffness(first)
    length = textbook(table.total([part.piece.length for part in chain]))
    force = stiffness * (x / length) ** order + first.foundation
    square = (force + first.tension * (x / length) ** 2 if pressed else force) / first.inertia
    acting = None if G else _impedances(form.n, M, K, square, _stations(chain), elsewhere, table)
    if acting is None or (pressed and not _sines(acting[0])):
        return None
    pieces, beta = [], x / length
    for part in chain:
        own = _stiffness(part.piece)
        power = textbook((part.piece.inertia * square - part.piece.foundation) / own)
        of_first = textbook((first.inertia * square - first.foundation) / stiffness)
        ratio = textbook(single(power / of_first)) if part is not chain[0] else table.one
        if x in reachable([ratio]):
            return None         # on a foundation of its own
        number = beta * ratio ** (HALF if order == 2 else HALF / 2)
        pieces.append(UniformPiece(number, number * part.piece.length, own))
    function = frequency_function(table, order, *(
        (pieces, acting[0]) if len(pieces) == 1 else _without_units(pieces, acting[0])))
    return FrequencyEquation(tuple(dict.fromkeys(part.owner for part in chain)), order, x, square,
                             [piece.argument for piece in pieces], function, chain, *acting)


def _without_units(pieces, impedances):
    """β, the stiffness S and the impedances of several pieces by those of the first: β/β₁, S/S₁, Z/(S₁ β₁³) of the
    displacement of a beam, Z/(S₁ β₁) of what has one motion or of a turn."""
    beta, stiffness, half = pieces[0].beta, pieces[0].stiffness, len(impedances[0])
    scales = [stiffness * beta ** (3 if half > 1 and not part else 1) for part in range(half)]
    return [UniformPiece(piece.beta / beta, piece.argument, piece.stiffness / stiffness) for piece in pieces], [
        tuple(None if Z is None else textbook(Z / scale) for Z, scale in zip(end, scales, strict=True))
            for end in impedances]


def _sines(impedances):
    """Is each end of a beam pinned or guided and nothing else, so that sines and cosines are its shapes under any
    tension N: B β⁴ + N β² + k = μ ω²?"""
    return all([Z.is_zero for Z in end if Z is not None] == [True] for end in impedances)


def _stiffness(piece):
    return piece.tension if piece.bending.is_zero else piece.bending


def _stations(chain):
    """[rows of the motions] of the stations from left to right."""
    half = len(chain[0].rows) // 2
    return [chain[0].rows[:half], *(part.rows[half:] for part in chain)]


def _impedances(n, M, K, square, stations, elsewhere, table):
    """[(Z of the displacement, of beams of the turn)] of the stations, None of what is held, and the coordinates of
    what hangs on them; None where what acts on one motion is coupled to another, or to another member (`elsewhere`)."""
    moving = [next(iter(row)) for rows in stations for row in rows if row]
    if len(set(moving)) != len(moving) or elsewhere.intersection(moving):
        return None
    entries = {pair: K.get(pair, table.zero) - square * M.get(pair, table.zero) for pair in {*K, *M}}
    beside = {i: {j for i2, j in entries if i2 == i and j != i} for i in range(n)}
    if any(j in moving for i in moving for j in beside[i]):
        return None
    hung = {j: i for i in moving for j in beside[i]}
    if any(beside[j] != {hung[j]} for j in hung) or elsewhere.intersection(hung):
        return None
    return [tuple(_impedance(row, entries, beside, table) for row in rows) for rows in stations], list(hung)


def _impedance(row: "Mapping[int, Node]", entries: Any, beside: Any, table: Any):
    """Z of the force along a motion by what acts on its coordinate; what hangs on that is eliminated."""
    if not row:
        return None
    (i, slope), = row.items()
    Z = entries.get((i, i), table.zero)
    for j in beside[i]:
        Z = Z - entries[i, j] * entries[j, i] / entries[j, j]
    return textbook(Z / slope**2)
