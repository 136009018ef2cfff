"""Frequency functions of members in letters: what vanishes at the natural frequencies of a chain of uniform pieces.

From the left end on, what the conditions allow is carried along the member: of bars, shafts and strings the solution
(u, S u′), of beams the plane of solutions (u, u′, EI u″, EI u‴) by its six minors. A piece multiplies these, b = βl, by

    cos b, sin b        β² = μω²/S          1, cos b·cosh b, sin b·sinh b, cos b·sinh b, sin b·cosh b       β⁴ = μω²/EI

so that no determinant of all conditions is to be expanded (compound matrices; Pestel & Leckie 1963, ch. 7). At a node
acts an impedance Z = k − ω²M on its displacement and Z = k_t − ω²J on its turn; None where it is held.
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from itertools import combinations, product
from typing import TYPE_CHECKING, Any

from vibcli.analyses.closed_form.pulled_beam import carried_minors, reduced_product
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.normal_form import textbook
from vibcli.symbolic.rationals import HALF, exact

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.analyses.closed_form.pulled_beam import Factor, Indices
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node

    Function = dict[tuple[tuple[int, *tuple[str, ...]], ...], Node]     # {((number of a piece, names), …): coefficient}
    Space = Mapping[Indices, Function]
    Entries = Iterator[tuple[Indices, Function, Factor]]

KRYLOV = [[(name, HALF), (other, sign * HALF)] for sign in (1, -1)          # the first row of a beam's T:
          for name, other in (("cosh", "cos"), ("sinh", "sin"))]            # (cosh b + cos b)/2, …, (sinh b − sin b)/2


COUPLED = (0, 2, 1), (1, 3, -1)     # motion, force of the other one, its sign


class UniformPiece(NamedTuple):
    """β and βl of a piece, and its stiffness: EI of a beam, else EA, GI_o or the tension; α of a beam under an axial
    force, else None."""

    beta: "Node"
    argument: "Node"
    stiffness: "Node"
    alpha: "Node | None" = None


def frequency_function(table: "Table", order: int, pieces: "Sequence[UniformPiece]",
                       impedances: "Sequence[tuple[Node | None, ...]]") -> "Function":
    """{functions: coefficient} of a sum that vanishes at the natural frequencies; functions: a tuple of (number of the
    piece, names of the functions of its βl). `order`: 2, of beams 4; `impedances`: of the displacement, and of beams of
    the turn and of what couples both, at each node from left to right."""
    free, forces = (((0,), (1,)), (1,)) if order == 2 else (((0, 1), (2, 3)), (3, 2))
    space: Space = {free[0]: {(): table.one}}
    for node, impedance in enumerate(impedances):
        for motion, (force, Z) in enumerate(zip(forces, impedance, strict=False)):
            if Z is None:
                space = _collected(table, _held(space, motion, force))
            else:
                space = _collected(table, _loaded(space, motion, force, -Z if force == 3 else Z))
        for motion, force, sign in COUPLED[:2 * (len(impedance) > len(forces))]:
            space = _collected(table, _loaded(space, motion, force, sign * impedance[-1]))
        if node < len(pieces):
            space = _collected(table, _carried(space, node, pieces[node], order))
    return space.get(free[1], {})


def _loaded(space: "Space", motion: int, force: int,
            Z: "Node") -> "Entries":
    """The force grows by Z times the motion: e_motion → e_motion + Z e_force."""
    for key, terms in space.items():
        yield key, terms, 1
        if motion in key and force not in key:
            new, sign = _placed(*(force if i == motion else i for i in key))
            yield new, terms, sign * Z


def _held(space: "Space", motion: int,
          force: int) -> "Entries":
    """What of the space has no such motion, with any force: contracted with e_motion, then times e_force."""
    for key, terms in space.items():
        rest = [i for i in key if i != motion]
        if motion in key and force not in rest:
            new, sign = _placed(*rest, force)
            yield new, terms, sign * (-1) ** key.index(motion)


def _placed(*indices: int) -> tuple[tuple[int, ...], int]:
    """The indices in order, and the sign of their order."""
    return (indices, 1) if indices == tuple(sorted(indices)) else (indices[::-1], -1)


def _carried(space: "Space", number: int,
             piece: UniformPiece, order: int) -> "Entries":
    """The space at the right end of a piece."""
    for row, column, products in _minors(piece, order):
        if column in space:
            for names, factor in products.items():
                more = ((number, *names),) if names else ()
                yield row, {(*functions, *more): node for functions, node in space[column].items()}, factor


def _minors(piece: UniformPiece, order: int) -> "Iterator[tuple[Indices, Indices, dict[tuple[str, ...], Factor]]]":
    """(row, column, {names of functions of βl: factor}) of what a piece multiplies with."""
    if piece.alpha is not None:
        yield from carried_minors(piece.alpha, piece.beta, piece.stiffness)
        return
    scale: list[int | Node] = [1, piece.stiffness * piece.beta] if order == 2 else [
        1, piece.beta, piece.stiffness * piece.beta ** 2, piece.stiffness * piece.beta ** 3]
    for (row, column), products in _compound(order).items():
        size: Any = 1        # a Node, but for the entries on the diagonal
        for i, j in zip(row, column, strict=True):
            size = size * scale[i] / scale[j]
        yield row, column, {names: size * factor for names, factor in products.items()}


def _collected(table: "Table", entries: "Entries") -> "Space":
    """{key: {functions: node}} of (key, terms, factor), what is zero left out."""
    found = {}
    for key, terms, factor in entries:
        target = found.setdefault(key, {})
        for functions, node in terms.items():
            target.setdefault(functions, []).append(node * factor)
    summed = {key: {functions: textbook(table.total(nodes)) for functions, nodes in terms.items()}
              for key, terms in found.items()}
    return {key: {functions: node for functions, node in terms.items() if not node.is_zero}
            for key, terms in summed.items()}


@cache
def _compound(order: int) -> "dict[tuple[Indices, Indices], dict[tuple[str, ...], Fraction | int]]":
    """{(row, column): {names of functions of βl: rational}} of what a piece multiplies with, but for units."""
    if order == 2:
        return {((0,), (0,)): {("cos",): 1}, ((0,), (1,)): {("sin",): 1},
                ((1,), (0,)): {("sin",): -1}, ((1,), (1,)): {("cos",): 1}}
    T = [[KRYLOV[(j - i) % 4] for j in range(4)] for i in range(4)]
    found: dict[tuple[Indices, Indices], dict[tuple[str, ...], Fraction | int]] = {}
    for (i, j), (k, m) in product(combinations(range(4), 2), repeat=2):
        minor = {}
        for one, two, sign in ((T[i][k], T[j][m], 1), (T[i][m], T[j][k], -1)):
            for (name, x), (other, y) in product(one, two):
                for names, factor in reduced_product(*sorted((name, other))):
                    minor[names] = minor.get(names, 0) + sign * x * y * factor
        found[(i, j), (k, m)] = {names: exact(x) for names, x in minor.items() if x}
    return found
