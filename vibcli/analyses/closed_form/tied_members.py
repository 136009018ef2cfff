"""Frequency equations of members that meet in one motion, in two that a spring or an inertia couples, or of two beams
clamped to each other, two stretches of one among these:

    k₁ + k₂ + Z = 0       (k₁ + Z₁₁) (k₂ + Z₂₂) = Z₁₂²       (k₁ + k₂ + Z₁₁) (R₁ + R₂ + Z₂₂) = (G₁ + G₂ + Z₁₂)²

k is the dynamic stiffness of a uniform member at its joint, seen along the joint's coordinate (Bishop & Johnson 1960);
of clamped ones R is that of the turn, G that of both. Where several are infinite at once the joint rests: with their
denominators multiplied, once for each member, the equation has these roots too, and no others.
"""

from collections import Counter
from collections.abc import Collection, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.end_stiffness import WaveArguments, end_stiffness, is_pulled, wave_power
from vibcli.analyses.closed_form.free_letters import (
    ARGUMENTS,
    BOTH,
    FREQUENCY,
    IMPEDANCES,
    STIFFNESSES,
    TURNS,
    free_letter,
    free_letters,
    in_order,
)
from vibcli.analyses.closed_form.hanging_stiffness import BesselArguments, bessel_powers, hanging_stiffness
from vibcli.analyses.closed_form.hanging_strings import names_bessel
from vibcli.analyses.closed_form.lumped_impedances import acting, coupled, over, stands_apart
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.symbolic_matrices import matrices_in_letters
from vibcli.symbolic.derivatives import substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from typing import TypeVar

    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.numerics.pieces.piece import Piece
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

    Thing = TypeVar("Thing")

ZEROS = ("z", "y", "w")       # letters of arguments of Bessel's functions
JOINTS = 2          # motions in which members of one equation meet
ROLES = {(0, 0): "force by displacement", (1, 1): "moment by turn", (0, 1): "moment by displacement"}


class Tied(NamedTuple):
    """Members that meet at joints: a product `left` = `right` in k₁, k₂, … and ω; `stiffnesses`: {letter: (F, H)} in
    θ, those of the pieces in `owners`; `repeated`: those of several members at one joint; `arguments`: {θ: (2, θ²) of
    bars, shafts and strings, (4, θ⁴) of beams, by ω}, under an axial force θ² and η²; `letters`: {impedance: what it
    is, by ω}; the coordinates of what hangs on them; of clamped ones the stiffness of each along the displacement, and
    {letter: what it tells}."""

    members: tuple[str, ...]
    omega: "Node"
    left: "list[Node]"
    right: "Node"
    stiffnesses: "dict[Node, tuple[Node, Node]]"
    owners: "dict[Node, list[PlacedPiece]]"
    repeated: "list[Node]"
    arguments: "dict[Node, tuple[int, Node]]"
    letters: "dict[Node, Node]"
    pieces: "list[PlacedPiece]"
    hung: list[int]
    clamped: "list[Node]"
    roles: "dict[Node, str]"


def tied_equations(symbolic: Any,
                   pieces: "Sequence[PlacedPiece]") -> "list[tuple[list[PlacedPiece], Tied | None, int]]":
    """[(pieces that belong together, their equation, how many coordinates they have with what hangs on them)] of
    `pieces`; None where no equation is told."""
    form, taken = symbolic.linearisation, {*symbolic.scene.coordinates, *symbolic.scene.parameters.nodes}
    M, C, G, K = matrices_in_letters(form)
    entries = {*M, *C, *G, *K}
    return [(group, tied(form, group, taken), len(coupled(entries, _moved(group))))
            for group in components([one for one in form.pieces if any(one is piece for piece in pieces)], entries)]


def _moved(pieces: "Sequence[PlacedPiece]") -> set[int]:
    return {i for piece in pieces for row in piece.rows for i in row}


def components(pieces: "Sequence[PlacedPiece]", entries: "Collection[tuple[int, int]]") -> "list[list[PlacedPiece]]":
    """Pieces in groups that share coordinates, or whose coordinates entries of the matrices tie."""
    found: list[tuple[set[int], list[PlacedPiece]]] = []
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
    if G or any(len(row) > 1 for row in rows) or not all(map(_even, pieces)):
        return None
    moved = [i for row in rows for i in row]
    varied = [piece for piece in pieces if _varies(piece)]
    if varied and (names_bessel(form.table, taken) or any(not one.piece.foundation.is_zero for one in varied)):
        return None
    omega = form.table.parameter(free_letter(taken, FREQUENCY))
    Z, hung = acting(M, K, moved, omega ** 2)
    joints = sorted({i for i in moved if moved.count(i) > 1} | {i for i, j in Z if i != j})
    met = [_met(piece, joints) for piece in pieces]
    if not 0 < len(joints) <= JOINTS or not all(met) or (len(pieces) > JOINTS and any(len(one) > 1 for one in met)):
        return None
    equation = _Equation(form.table, omega, taken, Z, joints, pieces)
    return equation.found(hung) if equation.told else None


def _varies(placed: "PlacedPiece") -> bool:
    return not placed.piece.gradient.is_zero


def _even(placed: "PlacedPiece") -> bool:
    """Has a piece inertia, and one tension along it unless it is a string?"""
    return (placed.piece.gradient.is_zero or placed.piece.bending.is_zero) and not placed.piece.inertia.is_zero


def _met(placed: "PlacedPiece", joints: Sequence[int]) -> list[int]:
    """The motions of one end of a piece that are joints; nothing where both ends have some."""
    half = len(placed.rows) // 2
    found = [(number // half, number % half) for number, row in enumerate(placed.rows)
             if row and next(iter(row)) in joints]
    return [motion for _, motion in found] if len({side for side, _ in found}) == 1 else []


def _opposite(part: "tuple[Node, Node]") -> "tuple[Node, Node]":
    return -part[0], part[1]


class _Equation:
    """What stands in the equation of members that meet at joints, each letter once."""

    def __init__(self, table: "Table", omega: "Node", taken: Collection[str], Z: "dict[tuple[int, int], Node]",
                 joints: list[int], pieces: "Sequence[PlacedPiece]") -> None:
        self.table, self.omega, self.taken, self.Z, self.joints, self.pieces = table, omega, taken, Z, joints, pieces
        far = [node for piece in pieces for row in piece.rows for i, slope in row.items() if i not in joints
               for node in [self._impedance(i, slope)] if stands_apart(node, omega, not piece.piece.foundation.is_zero)]
        self.letters = self._named(far, IMPEDANCES)
        self.arguments: dict[Node, tuple[int, Node]] = {}
        self.waves = self._waves()
        fars = [partial(self._far, piece.piece, waves) for piece, waves in zip(pieces, self.waves, strict=True)]
        self.parts = [end_stiffness(piece, waves, joints, far) if isinstance(waves, WaveArguments)
                      else hanging_stiffness(piece, waves, joints, far)
                      for piece, waves, far in zip(pieces, self.waves, fars, strict=True)]
        self.told = None not in self.parts
        if not self.told:
            return
        self.clamped = any(len(one) > 1 for one in self.parts)
        self.letters_of: dict[tuple[Node, Node], Node] = {}
        self.stiffnesses: dict[tuple[Node, Node], Node] = {}
        for names, keys in ((STIFFNESSES, [(0, 0)]), (TURNS, [(1, 1)]), (BOTH, [(0, 1)])) if self.clamped else (
                (STIFFNESSES, [(0, 0), (1, 1)]),):
            self._name([one[key] for one in self.parts for key in keys if key in one and not one[key][0].is_zero],
                       names)

    def _waves(self) -> list[WaveArguments | BesselArguments]:
        """θ of each piece, with η where an axial force acts; z at both ends of strings whose tension varies."""
        pairs = [bessel_powers(placed.piece, self.omega) for placed in self.pieces if _varies(placed)]
        zs = self._named([power for pair in pairs for power in pair if power], ZEROS)
        powers = [None if _varies(placed) else wave_power(placed.piece, self.omega) for placed in self.pieces]
        thetas = self._named([power for power in powers if power], ARGUMENTS)
        self.arguments = {letter: power for named in (zs, thetas) for power, letter in named.items()}
        in_order(*thetas.values())
        pulled = {power: textbook(placed.piece.length ** 2 * placed.piece.tension / placed.piece.bending)
                  for placed, power in zip(self.pieces, powers, strict=True) if is_pulled(placed.piece)}
        others = [name for name in ARGUMENTS if not any(theta.name.startswith(name) for theta in self.arguments)]
        etas = dict(zip(pulled, self._named(list(pulled), others).values(), strict=True))
        self.arguments |= {eta: (2, thetas[power] ** 2 + pulled[power]) for power, eta in etas.items()}
        in_order(*etas.values())
        ends = iter(pairs)
        return [WaveArguments(thetas[power], etas.get(power)) if power else BesselArguments(*map(zs.get, next(ends)))
                for power in powers]

    def _named(self, things: "Sequence[Thing]", names: Sequence[str]) -> "dict[Thing, Node]":
        """{thing: letter}, what is alike once."""
        once = list(dict.fromkeys(things))
        found = free_letters(self.taken, names, len(once))
        return {thing: self.table.parameter(name) for thing, name in zip(once, found, strict=True)}

    def _name(self, parts: "Sequence[tuple[Node, Node]]", names: Sequence[str]) -> None:
        """Letters of stiffnesses, those of opposite sign by the same one."""
        once: list[tuple[Node, Node]] = []
        for part in parts:
            once += [part] if _opposite(part) not in once else []
        named = self._named(once, names)
        self.letters_of |= named
        self.stiffnesses |= named | {part: -named[_opposite(part)] for part in parts if part not in named}

    def _impedance(self, i: int, slope: "Node") -> "Node":
        return over(self.Z.get((i, i), self.table.zero), slope)

    def _far(self, piece: "Piece", waves: WaveArguments | BesselArguments, i: int, slope: "Node") -> "Node":
        """What acts on an end that is no joint: a letter, or by θ."""
        known = self._impedance(i, slope)
        if isinstance(waves, BesselArguments):
            return self.letters.get(known, known)
        return self.letters.get(known) or substitute([known], {self.omega: self.table.sqrt(waves.square(piece))})[0]

    def _joints(self, placed: "PlacedPiece") -> "dict[int, tuple[int, Node]]":
        """{motion: (the coordinate of the joint, how much the end of a member moves by it)}."""
        half = len(placed.rows) // 2
        return {number % half: pair for number, row in enumerate(placed.rows) for pair in row.items()
                if pair[0] in self.joints}

    def found(self, hung: list[int]) -> Tied:
        """The equation."""
        table = self.table
        sums = {(i, j): self.Z.get((i, j), table.zero) for i in self.joints for j in self.joints}
        owners: dict[Node, list[PlacedPiece]] = {}
        for placed, part in zip(self.pieces, self.parts, strict=True):
            met = self._joints(placed)
            for (m, n), stiffness in part.items():
                if not stiffness[0].is_zero:
                    (i, first), (j, second) = met[m], met[n]
                    sums[min(i, j), max(i, j)] += textbook(first * second) * self.stiffnesses[stiffness]
                    if stiffness in self.letters_of:
                        owners.setdefault(self.letters_of[stiffness], []).append(placed)
        left = [sums[i, i] for i in self.joints]
        off = table.zero if len(left) == 1 else sums[min(self.joints), max(self.joints)]
        repeated = [letter for letter, count in Counter(
            (self._joints(placed)[m][0], self.stiffnesses[one]) for placed, part in zip(
                self.pieces, self.parts, strict=True) for (m, _), one in part.items()).items()
            if count > 1] if not self.clamped else []
        roles = {self.letters_of[one]: ROLES[key] for part in self.parts if len(part) > 1 for key, one in part.items()
                 if one in self.letters_of}
        stands = reachable([*left, off])
        return Tied(
            tuple(dict.fromkeys(placed.owner for placed in self.pieces)), self.omega, left, off ** 2,
            {letter: part for part, letter in self.letters_of.items() if letter in stands}, owners,
            list(dict.fromkeys(letter for _, letter in repeated)), self.arguments,
            {letter: node for node, letter in self.letters.items()}, list(self.pieces), hung,
            [self.stiffnesses[next(iter(part.values()))] for part in self.parts] if self.clamped else [], roles)
