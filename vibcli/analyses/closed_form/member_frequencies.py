"""Frequency equations of members as textbooks write them: βL·tan βL = μL/M, cos βL·cosh βL = −1.

A chain of one or two uniform pieces, bars end to end or a beam with something at an inner place, whose stations carry
what acts on one motion each: masses, springs to the ground, what hangs on these. An impedance that is neither a spring
nor an inertia alone stands as a letter.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.free_letters import (
    ARGUMENTS,
    FREQUENCY,
    IMPEDANCES,
    free_letter,
    free_letters,
    in_order,
)
from vibcli.analyses.closed_form.frequency_functions import UniformPiece, frequency_function
from vibcli.analyses.closed_form.lumped_impedances import acting, at_station, coupled, stands_apart
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.symbolic_matrices import matrices_in_letters
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import HALF

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.frequency_functions import Function
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.mechanics.linearisation import Linearisation
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.numerics.pieces.piece import Piece
    from vibcli.symbolic.node import Node

    Impedances = tuple[Node | None, ...]        # of the motions of a station

MOST = 2            # pieces of a chain whose equation is written out
WAVE_NUMBER, SECOND = "βL", "αL"     # products, as notation.names reads them
HYPERBOLIC = "sinh", "cosh"


class FrequencyEquation(NamedTuple):
    """What vanishes at the natural frequencies of the `members`: {functions of the arguments: coefficient}; βL, β that
    of the first piece and L the length of the chain, ω, ω² by βL, the argument of each piece, what acts on the
    stations (on the displacement, the turn, and what couples both), the same as it stands in the function, {letter:
    impedance} by ω of what stands there as a letter, and the coordinates of what hangs on the stations; of a beam under
    an axial force αL besides, the argument of sinh and cosh, and its square by βL."""

    members: tuple[str, ...]
    order: int
    wave_number: "Node"
    omega: "Node"
    square: "Node"
    arguments: "list[Node]"
    function: "Function"
    pieces: "list[PlacedPiece]"
    impedances: "list[tuple[Node | None, ...]]"
    standing: "list[tuple[Node | None, ...]]"
    letters: "dict[Node, Node]"
    hung: list[int]
    second: "Node | None" = None
    second_square: "Node | None" = None

    @property
    def named(self) -> "list[tuple[Node, Node]]":
        """[(letter, what it is)]: that for βL where L is another length, or L where the scene has none, and those of
        impedances."""
        table, x = self.wave_number.table, self.wave_number
        length = textbook(table.total([placed.piece.length for placed in self.pieces]))
        own = [(x, table.parameter("β") * length)] if x.name != WAVE_NUMBER else [] if length.name == "L" else [
            (table.parameter("L"), length)]
        other = [] if self.second is None else [(self.second, table.sqrt(self.second_square))]
        if x.name != WAVE_NUMBER and other:
            own.append((self.second, table.parameter("α") * length))
        return [*own, *other, *self.letters.items()]

    def by_wave_number(self, *nodes: "Node") -> "list[Node]":
        """Nodes without letters of impedances, ω and αL."""
        table = self.omega.table
        other = {} if self.second is None else {self.second: table.sqrt(self.second_square)}
        return substitute(substitute(list(nodes), self.letters), {self.omega: table.sqrt(self.square), **other})

    def called(self, functions: tuple[tuple[int, *tuple[str, ...]], ...]) -> "Node":
        """The product of functions of the arguments, ((number of the piece, names), …)."""
        return self.omega.table.product(*((self.omega.table.call(name, (
            name in HYPERBOLIC and self.second) or self.arguments[piece]), 1) for piece, *names in functions
            for name in names))

    @property
    def terms(self) -> "list[Node]":
        """What the function adds up, by βL alone."""
        return self.by_wave_number(*(coefficient * self.called(functions)
                                     for functions, coefficient in self.function.items()))


def frequency_equations(symbolic: "SymbolicSystem") -> "list[FrequencyEquation | None]":
    """One of each chain of pieces; None of those for which there is none in closed form."""
    form = symbolic.linearisation
    taken = {*symbolic.scene.coordinates, *symbolic.scene.parameters.nodes}
    return [_equation(form, chain, taken) for chain in chains(form.pieces)]


def chains(pieces: "Sequence[PlacedPiece]") -> "list[list[PlacedPiece]]":
    """The pieces in chains from left to right, those of each member and of members that begin where others end."""
    found: list[list[PlacedPiece]] = []
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


def _end(placed: "PlacedPiece", side: int) -> "tuple[dict[int, Node], ...]":
    """The rows of its left (0) or right (1) end; () where all of that is held."""
    half = len(placed.rows) // 2
    rows = placed.rows[side * half:][:half]
    return tuple(rows) if any(rows) else ()


def _equation(form: "Linearisation", chain: "list[PlacedPiece]", taken: set[str]) -> FrequencyEquation | None:
    chain = _joined(form, chain)
    pulled = [part for part in chain if not (part.piece.bending.is_zero or part.piece.tension.is_zero)]
    if len(chain) > (1 if pulled else MOST) or not all(part.piece.gradient.is_zero for part in chain):
        return None
    table, first = form.table, chain[0].piece
    length, order = textbook(table.total([part.piece.length for part in chain])), 2 if first.bending.is_zero else 4
    x, stiffness = _wave_number(length, taken), _stiffness(first)
    in_order(x)
    force = stiffness * (x / length) ** order + first.foundation
    square = (force + first.tension * (x / length) ** 2 if pulled else force) / first.inertia
    omega = table.parameter(free_letter(taken, FREQUENCY))
    acting = impedances(form, chain, omega)
    if acting is None:
        return None
    second = _second(x, taken) if pulled else None
    pieces = _pieces(chain, square, x, length) if second is None else [
        UniformPiece(x / length, x, stiffness, second / length)]
    if pieces is None:
        return None
    at_stations, hung = acting
    letters, standing = _lettered(at_stations, omega, taken, not first.foundation.is_zero)
    of_waves = square if second is None else _square_of_both(first, x, second, length)
    by_x = [tuple(Z and textbook(substitute([Z], {omega: table.sqrt(of_waves)})[0]) for Z in end) for end in standing]
    function = frequency_function(table, order, *((pieces, by_x) if len(pieces) == 1 else _without_units(pieces, by_x)))
    if second is not None and len(function) == 1:       # sines or cosines alone
        function, second = dict.fromkeys(function, table.one), None
    found = FrequencyEquation(tuple(dict.fromkeys(part.owner for part in chain)), order, x, omega, square,
                              [piece.argument for piece in pieces], function, chain, [], by_x, letters, hung, second,
                              None if second is None else x ** 2 + first.tension * length ** 2 / first.bending)
    return found._replace(
        impedances=[tuple(Z and textbook(*found.by_wave_number(Z)) for Z in end) for end in at_stations])


def _joined(form: "Linearisation", chain: "list[PlacedPiece]") -> "list[PlacedPiece]":
    """The chain with stretches as one that are alike and meet where nothing acts on them."""
    if len(chain) < 2:
        return chain
    M, _, G, K = matrices_in_letters(form)
    acted, found = {i for pair in (*M, *G, *K) for i in pair}, chain[:1]
    for part in chain[1:]:
        last, half = found[-1], len(part.rows) // 2
        between = [i for row in part.rows[:half] for i in row]
        others = {i for one in form.pieces if one.owner != part.owner for row in one.rows for i in row}
        alike = last.owner == part.owner and last.piece._replace(length=part.piece.length) == part.piece
        if alike and last.rows[half:] == part.rows[:half] and len(set(between)) == half and not (
                acted | others).intersection(between):
            both = last.piece._replace(length=textbook(last.piece.length + part.piece.length))
            found[-1] = last._replace(piece=both, rows=last.rows[:half] + part.rows[half:])
        else:
            found.append(part)
    return found


def _second(x: "Node", taken: set[str]) -> "Node":
    """αL, or a letter for it where βL is one."""
    second = x.table.parameter(SECOND if x.name == WAVE_NUMBER else free_letter({*taken, x.name}, ARGUMENTS))
    in_order(second)
    return second


def _square_of_both(piece: "Piece", x: "Node", second: "Node", length: "Node") -> "Node":
    """ω² of a beam under an axial force: EI α²β² + k = μ ω²."""
    return textbook((piece.bending * x ** 2 * second ** 2 / length ** 4 + piece.foundation) / piece.inertia)


def _wave_number(length: "Node", taken: set[str]) -> "Node":
    """βL, or a letter for it where L is not the length."""
    table = length.table
    alike = "L" not in taken or length is table.parameter("L")
    return table.parameter(WAVE_NUMBER if alike else free_letter(taken, ARGUMENTS))


def _pieces(chain: "Sequence[PlacedPiece]", square: "Node", x: "Node", length: "Node") -> list[UniformPiece] | None:
    """A UniformPiece of each by β of the first; None where one stands on a foundation of its own."""
    first, found = chain[0].piece, []
    for part in chain:
        own, order = _stiffness(part.piece), 2 if part.piece.bending.is_zero else 4
        power = textbook((part.piece.inertia * square - part.piece.foundation) / own)
        of_first = textbook((first.inertia * square - first.foundation) / _stiffness(first))
        ratio = textbook(single(power / of_first)) if part is not chain[0] else x.table.one
        if x in reachable([ratio]):
            return None
        number = x / length * ratio ** (HALF if order == 2 else HALF / 2)
        found.append(UniformPiece(number, number * part.piece.length, own))
    return found


def _lettered(impedances: "Sequence[tuple[Node | None, ...]]", omega: "Node", taken: set[str],
              bedded: bool) -> "tuple[dict[Node, Node], list[tuple[Node | None, ...]]]":
    """{letter: impedance} of what is neither a spring nor an inertia alone, and the impedances with these letters."""
    many = dict.fromkeys(Z for end in impedances for Z in end if Z is not None and stands_apart(Z, omega, bedded))
    names = free_letters(taken, IMPEDANCES, len(many))
    letters = {Z: omega.table.parameter(name) for Z, name in zip(many, names, strict=True)}
    return {letter: Z for Z, letter in letters.items()}, [tuple(letters.get(Z, Z) for Z in end) for end in impedances]


def _without_units(pieces: Sequence[UniformPiece], impedances: "Sequence[Impedances]",
                   ) -> "tuple[list[UniformPiece], list[Impedances]]":
    """β, the stiffness S and the impedances of several pieces by those of the first: β/β₁, S/S₁, Z/(S₁ β₁³) of the
    displacement of a beam, Z/(S₁ β₁) of what has one motion or of a turn,
    Z/(S₁ β₁²) of what couples both."""
    beta, stiffness = pieces[0].beta, pieces[0].stiffness
    scales = [stiffness * beta ** power for power in ((1,) if len(impedances[0]) == 1 else (3, 1, 2))]
    return [UniformPiece(piece.beta / beta, piece.argument, piece.stiffness / stiffness) for piece in pieces], [
        tuple(None if Z is None else textbook(Z / scale) for Z, scale in zip(end, scales, strict=False))
            for end in impedances]


def _stiffness(piece: "Piece") -> "Node":
    found: Node = piece.tension if piece.bending.is_zero else piece.bending
    return found


def _stations(chain: "Sequence[PlacedPiece]") -> "list[tuple[dict[int, Node], ...]]":
    """[rows of the motions] of the stations from left to right."""
    half = len(chain[0].rows) // 2
    return [chain[0].rows[:half], *(part.rows[half:] for part in chain)]


def impedances(form: Any, chain: "Sequence[PlacedPiece]",
               omega: "Node") -> "tuple[list[tuple[Node | None, ...]], list[int]] | None":
    """[(Z of the displacement, of beams of the turn, what couples both where anything does)] of the stations, None of
    what is held, and the coordinates of what hangs on them; None where what acts on one station is coupled to another,
    or to another member."""
    stations = _stations(chain)
    own = [sorted({i for row in rows for i in row}) for rows in stations]
    moving = [i for one in own for i in one]
    owners = {part.owner for part in chain}
    elsewhere = {i for piece in form.pieces if piece.owner not in owners for row in piece.rows for i in row}
    M, _, G, K = matrices_in_letters(form)
    if G or len(set(moving)) != len(moving) or elsewhere & coupled({*M, *K}, moving):
        return None
    Z, hung = acting(M, K, moving, omega ** 2)
    if any(len(one) != sum(map(bool, rows)) for one, rows in zip(own, stations, strict=True)) or any(
            i != j and not any(i in one and j in one for one in own) for i, j in Z):
        return None
    return [at_station(rows, Z, omega.table.zero) for rows in stations], hung
