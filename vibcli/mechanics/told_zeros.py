"""The matrices of small oscillations, and values at rest, as they are told: without what rounding left in place of a
zero.

A number is one where more digits of the exact data take it along: far below others of its kind in floats, it is looked
at with DIGITS of them, and a zero falls by as many orders as there are.
"""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.mechanics.configuration import Configuration
    from vibcli.symbolic.node import Node

SMALL = 1e-9        # of the largest entry in its row or column, or of such a value: what is looked at
DIGITS, NOTHING = 60, 1e-45


def told_matrices(configuration: "Configuration") -> "Sequence[Mapping[tuple[int, int], float]]":
    """M, C, G, K in floats, each {(i, j): number}."""
    found = configuration.element_data.matrices()
    doubted = [_doubted(matrix) for matrix in found]
    if not any(doubted) or configuration.sources[0] is None:
        return found
    import mpmath

    try:
        with mpmath.workdps(DIGITS):
            finer = configuration.precise_system(DIGITS).matrices()
    except PhysicsError:
        return found
    return tuple(_without(matrix, {pair for pair, size in small.items() if abs(more.get(pair, 0)) <= NOTHING * size})
                 for matrix, small, more in zip(found, doubted, finer, strict=True))


def _doubted(matrix: "Mapping[tuple[int, int], Any]") -> dict[tuple[int, int], float]:
    """{(i, j): the largest entry in its row or column} of entries that may be zeros."""
    largest: dict[tuple[str, int], float] = {}
    for (i, j), value in matrix.items():
        for place in ("row", i), ("column", j):
            largest[place] = max(largest.get(place, 0.0), abs(value))
    found = {(i, j): max(largest["row", i], largest["column", j]) for i, j in matrix}
    return {pair: size for pair, size in found.items() if 0 < abs(matrix[pair]) <= SMALL * size}


def _without(matrix: dict[tuple[int, int], Any], zeros: set[tuple[int, int]]) -> dict[tuple[int, int], Any]:
    return {pair: value for pair, value in matrix.items() if pair not in zeros} if zeros else matrix


def told_values(configuration: "Configuration", nodes: "Sequence[Node]", sizes: "Sequence[float]") -> list[float]:
    """The values of nodes at rest in floats, 0 where one far below its size is 0."""
    values = evaluate(nodes, Floats, configuration.at_rest)
    doubted = [i for i, value in enumerate(values) if 0 < abs(value) <= SMALL * sizes[i]]
    if not doubted or configuration.sources[0] is None:
        return values
    import mpmath

    try:
        with mpmath.workdps(DIGITS):
            arithmetic, at_rest = configuration.precise_rest(DIGITS)
            finer = evaluate([nodes[i] for i in doubted], arithmetic, at_rest)
    except PhysicsError:
        return values
    zeros = {i for i, more in zip(doubted, finer, strict=True) if abs(more) <= NOTHING * sizes[i]}
    return [0.0 if i in zeros else value for i, value in enumerate(values)]
