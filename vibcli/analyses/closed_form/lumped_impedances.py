"""What acts on the motions of members besides themselves, at one frequency: Z = K − ω² M of the coordinates that they
move; what hangs on these, masses on springs or pendulums, is eliminated (Schur's complement).
"""

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.symbolic.common_denominator import single
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.nested_form import letters
from vibcli.symbolic.normal_form import textbook

if TYPE_CHECKING:
    from vibcli.symbolic.node import Node


def coupled(entries: "Collection[tuple[int, int]]", start: Collection[int]) -> set[int]:
    """The coordinates that entries of a matrix tie to some, these among them."""
    found, pending = set(start), list(start)
    while pending:
        i = pending.pop()
        new = {k for j, k in entries if j == i} - found
        found |= new
        pending += new
    return found


def acting(M: Any, K: Any, moving: Collection[int], square: "Node") -> "tuple[dict[tuple[int, int], Node], list[int]]":
    """({(i, j): Z} of the coordinates that members move, those that hang on them); `square`: ω²."""
    zero = square.table.zero
    inside = coupled({*M, *K}, moving)
    Z = {(i, j): textbook(K.get((i, j), zero) - square * M.get((i, j), zero)) for i, j in {*M, *K} if i in inside}
    hung = left = sorted(inside.difference(moving))
    while left:
        out = min(left, key=lambda h: sum(i == h for i, _ in Z))
        left = [h for h in left if h != out]
        beside = [j for i, j in Z if i == out and j != out]
        for i in beside:
            for j in beside:
                Z[i, j] = _without(Z.get((i, j), zero), Z[i, out], Z[out, j], Z[out, out])
        Z = {pair: node for pair, node in Z.items() if out not in pair}
    return {pair: written for pair, node in Z.items() if not (written := _shortest(node)).is_zero}, hung


def _without(Z: "Node", row: "Node", column: "Node", own: "Node") -> "Node":
    """Z − row·column/own; k − M ω² − k²/(k − m ω²) of an oscillator as −M ω² − k m ω²/(k − m ω²)."""
    freed, rest = textbook(Z + row), textbook(own + column)
    if row is column and _count(freed) < _count(Z):
        return freed - row * rest / own
    return Z - row * column / own


def _count(node: "Node") -> int:
    """Of the terms of a sum."""
    return 0 if node.is_zero else len(node.args) + bool(node.coefficient) if node.op == "sum" else 1


def _shortest(node: "Node") -> "Node":
    return min((node, textbook(node), single(node)), key=letters)


def stands_apart(Z: "Node", omega: "Node", bedded: bool) -> bool:
    """Is an impedance neither a spring alone nor an inertia alone of what has no foundation, so that a letter is to
    stand for it?"""
    return omega in reachable([Z]) and (bedded or omega in reachable([textbook(Z / omega ** 2)]))


def over(Z: "Node", scale: "Node") -> "Node":
    """An impedance of a motion that is `scale` times that of the coordinate: Z/scale², term by term."""
    table = Z.table
    terms = [table.number(Z.coefficient), *(c * part for part, c in Z.args)] if Z.op == "sum" else [Z]
    return table.total([single(term / scale ** 2) for term in terms])


def at_station(rows: "Sequence[Mapping[int, Node]]", Z: "Mapping[tuple[int, int], Node]",
               zero: "Node") -> "tuple[Node | None, ...]":
    """The impedances of the motions of a station, None of what is held, and of two motions what couples them where
    anything does; `rows`: the motions by coordinates, as many as move."""
    if all(len(row) < 2 for row in rows):
        found = [over(Z.get((i, i), zero), slope) if row else None for row in rows
                 for i, slope in (row or {None: None}).items()]
        pair = [(i, slope) for row in rows for i, slope in row.items()]
        both = Z.get((pair[0][0], pair[1][0]), zero) / (pair[0][1] * pair[1][1]) if len(pair) == 2 else zero
        return (*found, *([] if both.is_zero else [both]))
    inverse = by_motions(rows)
    entry = [[zero.table.total([one[m] * Z.get((i, j), zero) * other[n] for i, one in inverse.items()
                                for j, other in inverse.items()]) for n in (0, 1)] for m in (0, 1)]
    (across, both), (_, turn) = [[_shortest(node) for node in row] for row in entry]
    return (across, turn, *([] if both.is_zero else [both]))


def by_motions(rows: "Sequence[Mapping[int, Node]]") -> "dict[int, tuple[Node, ...]]":
    """{coordinate: its parts by the motions of a station}, of motions that move, by as many coordinates."""
    if all(len(row) < 2 for row in rows):
        return {i: tuple(1 / slope if one is row else 0 * slope for one in rows) for row in rows
                for i, slope in row.items()}
    i, j = sorted({i for row in rows for i in row})
    zero = next(iter(rows[0].values())) * 0
    (a, b), (c, d) = [[row.get(k, zero) for k in (i, j)] for row in rows]
    det = a * d - b * c
    return {i: (d / det, -b / det), j: (-c / det, a / det)}
