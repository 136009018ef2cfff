"""Frequency equations of members that meet in one motion, or in two that a spring or an inertia couples:

    k₁ + k₂ + Z = 0                     (k₁ + Z₁₁) (k₂ + Z₂₂) = Z₁₂²

k = F/H is the dynamic stiffness of a uniform member at its joint, seen along the joint's coordinate: F vanishes at its
frequencies with the joint free, H with the joint held. Both are linear parts of its frequency function with an
impedance Z at the joint, F + Z H (Bishop & Johnson 1960). Where several k are infinite at once the joint rests: with
their denominators multiplied the equation has these roots too, and no others.
"""

from collections import Counter
from collections.abc import Collection, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.free_letters import (
    ARGUMENTS,
    FREQUENCY,
    IMPEDANCES,
    STIFFNESSES,
    free_letter,
    free_letters,
    in_order,
)
from vibcli.analyses.closed_form.frequency_functions import UniformPiece, frequency_function
from vibcli.analyses.closed_form.lumped_impedances import acting, coupled, over, stands_apart
from vibcli.analyses.closed_form.textbook_equation import content, is_small, quotient
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.symbolic_matrices import matrices_in_letters
from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.symbolic.node import Node

JOINTS = 2          # motions in which members of one equation meet


class Tied(NamedTuple):
    """Members that meet at joints: `left` = `right` in k₁, k₂, … and ω; `stiffnesses`: {letter: (F, H)} in θ, those of
    the pieces in `owners`; `repeated`: those of several members at one joint; `arguments`: {θ: (2, θ²) of bars, shafts
    and strings, (4, θ⁴) of beams, by ω}; `letters`: {impedance: what it is, by ω}; the coordinates of what hangs on
    them."""

    members: tuple
    omega: "Node"
    left: "Node"
    right: "Node"
    stiffnesses: "dict[Node, tuple[Node, Node]]"
    owners: "dict[Node, list[PlacedPiece]]"
    repeated: "list[Node]"
    arguments: "dict[Node, tuple[int, Node]]"
    letters: "dict[Node, Node]"
    pieces: "list[PlacedPiece]"
    hung: list


def tied_equations(symbolic: Any, pieces: "Sequence[PlacedPiece]") -> list[tuple]:
    """[(pieces that belong together, their equation, how many coordinates they have with what hangs on them)] of
    `pieces`; None where no equation is told."""
    form, taken = symbolic.linearisation, {*symbolic.scene.coordinates, *symbolic.scene.parameters.nodes}
    M, C, G, K = matrices_in_letters(form)
    entries = {*M, *C, *G, *K}
    return [(group, tied(form, group, taken), len(coupled(entries, _moved(group))))
            for group in components([one for one in form.pieces if any(one is piece for piece in pieces)], entries)]


def _moved(pieces):
    return {i for piece in pieces for row in piece.rows for i in row}


def _in_letters(nodes):
    """Have sums no numbers but small ones?"""
    return all(is_small(Fraction(c)) for part in reachable(nodes) for c in (
        part.coefficient, *(c for _, c in (part.args if part.op == "sum" else ()))))


def components(pieces: "Sequence[PlacedPiece]", entries: "Collection[tuple[int, int]]") -> "list[list[PlacedPiece]]":
    """Pieces in groups that share coordinates, or whose coordinates entries of the matrices tie."""
    found: list = []
    for piece in pieces:
        own = coupled(entries, _moved([piece]))
        near = [group for group in found if group[0] & own]
        found = [group for group in found if group not in near]
        found.append((own.union(*(group[0] for group in near)), [one for group in near for one in group[1]] + [piece]))
    return [sorted(group, key=pieces.index) for _, group in found]


def tied(form: Any, pieces: "Sequence[PlacedPiece]", taken: Collection[str]) -> "Tied | None":
    """The equation of one component; None where a member has several joints or is not uniform, or the joints are
    many."""
    M, _, G, K = matrices_in_letters(form)
    rows = [row for piece in pieces for row in piece.rows]
    if G or any(len(row) > 1 for row in rows) or not all(map(_uniform, pieces)):
        return None
    moved = [i for row in rows for i in row]
    omega = form.table.parameter(free_letter(taken, FREQUENCY))
    Z, hung = acting(M, K, moved, omega ** 2)
    joints = sorted({i for i in moved if moved.count(i) > 1} | {i for i, j in Z if i != j})
    met = [sum(i in joints for row in piece.rows for i in row) for piece in pieces]
    if not 0 < len(joints) <= JOINTS or any(count != 1 for count in met):
        return None
    return _Equation(form.table, omega, taken, Z, joints, pieces).found(hung)


def _uniform(placed):
    """Is a piece a bar, shaft or string of even tension, or a beam without tension?"""
    piece = placed.piece
    return piece.gradient.is_zero and not piece.inertia.is_zero and (piece.bending.is_zero or piece.tension.is_zero)


class _Equation:
    """What stands in the equation of members that meet at joints, each letter once."""

    def __init__(self, table, omega, taken, Z, joints, pieces):
        self.table, self.omega, self.taken, self.Z, self.joints, self.pieces = table, omega, taken, Z, joints, pieces
        far = [node for piece in pieces for row in piece.rows for i, slope in row.items() if i not in joints
               for node in [self._impedance(i, slope)] if stands_apart(node, omega, not piece.piece.foundation.is_zero)]
        self.letters = self._named(far, IMPEDANCES)
        powers = [self._power(piece.piece) for piece in pieces]
        self.arguments = self._named(powers, ARGUMENTS)
        in_order(*self.arguments.values())
        parts = [self._stiffness(piece, self.arguments[power]) for piece, power in zip(pieces, powers, strict=True)]
        self.stiffnesses = self._named(parts, STIFFNESSES)
        self.parts = parts

    def _named(self, things, names):
        """{thing: letter}, what is alike once."""
        once = list(dict.fromkeys(things))
        found = free_letters(self.taken, names, len(once))
        return {thing: self.table.parameter(name) for thing, name in zip(once, found, strict=True)}

    def _impedance(self, i, slope):
        return over(self.Z.get((i, i), self.table.zero), slope)

    def _power(self, piece):
        """(order, θ to that power) by ω."""
        order = 2 if piece.bending.is_zero else 4
        stiffness = piece.tension if order == 2 else piece.bending
        load = piece.inertia * self.omega ** 2 - piece.foundation
        return order, textbook(piece.length ** order / stiffness) * (load if load.op == "sum" else textbook(load))

    def _stiffness(self, placed, theta):
        """(F, H) of a member by its θ."""
        piece, table = placed.piece, self.table
        order, half = (2, 1) if piece.bending.is_zero else (4, 2)
        stiffness, beta = piece.tension if order == 2 else piece.bending, theta / piece.length
        square = (stiffness * beta ** order + piece.foundation) / piece.inertia
        unknown = table.parameter("Z at the joint")
        scales = [stiffness * beta ** (3 if half > 1 else 1), stiffness * beta]
        ends, power = [], None
        for number, row in enumerate(placed.rows):
            scale = scales[number % half]
            if not row:
                ends.append(None)
            elif next(iter(row)) in self.joints:
                power = scale
                ends.append(unknown)
            else:
                (i, slope), = row.items()
                known = self._impedance(i, slope)
                node = self.letters.get(known) or substitute([known], {self.omega: table.sqrt(square)})[0]
                ends.append(textbook(node / scale))
        function = frequency_function(table, order, [UniformPiece(table.one, theta, table.one)],
                                      [tuple(ends[:half]), tuple(ends[half:])])
        return self._quotient(function, unknown, theta, power)

    def _quotient(self, function, unknown, theta, power):
        """F and H of F + Z H, the stiffness of the member with F."""
        table, sums = self.table, []
        free = {names: substitute([node], {unknown: table.zero})[0] for names, node in function.items()}
        held = {names: textbook((node - free[names]) / unknown) for names, node in function.items()}
        for terms in (free, held):
            sums.append([(coefficient, table.product(*((table.call(name, theta), 1) for _, *called in names
                                                       for name in called)))
                         for names, coefficient in terms.items() if not coefficient.is_zero])
        scale = next((size for size, _ in sums[1] if all(part.op != "sum" for part in reachable([size]))), table.one)
        raw = [table.total([textbook(coefficient / scale) * calls for coefficient, calls in terms]) for terms in sums]
        cleared = [single(total) for total in raw]
        if not _in_letters(cleared):
            return textbook(power) * raw[0], raw[1]
        (above, one), (below, other) = map(content, cleared)
        return quotient(textbook(power * one / other) * above / below)

    def _joint(self, placed):
        """(the coordinate of the joint, how much the end of a member moves by it)."""
        return next((i, slope) for row in placed.rows for i, slope in row.items() if i in self.joints)

    def found(self, hung: list[int]) -> Tied:
        """The equation."""
        table, sums = self.table, dict.fromkeys(self.joints, self.table.zero)
        for placed, part in zip(self.pieces, self.parts, strict=True):
            joint, slope = self._joint(placed)
            sums[joint] += textbook(slope ** 2) * self.stiffnesses[part]
        left = [sums[i] + self.Z.get((i, i), table.zero) for i in self.joints]
        right = table.zero if len(left) == 1 else self.Z[tuple(self.joints)] ** 2
        owners: dict = {}
        for placed, part in zip(self.pieces, self.parts, strict=True):
            owners.setdefault(self.stiffnesses[part], []).append(placed)
        repeated = [letter for letter, count in Counter(
            (self._joint(placed)[0], self.stiffnesses[part])
            for placed, part in zip(self.pieces, self.parts, strict=True)).items() if count > 1]
        return Tied(tuple(dict.fromkeys(placed.owner for placed in self.pieces)), self.omega, table.product(
            *((node, 1) for node in left)), right, {letter: part for part, letter in self.stiffnesses.items()}, owners,
            list(dict.fromkeys(letter for _, letter in repeated)),
            {letter: power for power, letter in self.arguments.items()},
            {letter: node for node, letter in self.letters.items()}, list(self.pieces), hung)
