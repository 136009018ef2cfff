"""The matrices of small oscillations as they are told: without what rounding left in place of a zero.

An entry is one where more digits of the exact data take it along: far below the others of its row and column in floats,
it is looked at with DIGITS of them, and a zero falls by as many orders as there are.
"""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from vibcli.mechanics.configuration import Configuration

SMALL = 1e-9        # of the largest entry in its row or column: what is looked at
DIGITS, NOTHING = 60, 1e-45


def told_matrices(configuration: "Configuration") -> "Sequence[Mapping[tuple[int, int], float]]":
    """M, C, G, K in floats, each {(i, j): number}."""
    found = configuration.linear_system.matrices()
    doubted = [_doubted(matrix) for matrix in found]
    if not any(doubted) or configuration.sources[0] is None:
        return found
    try:
        finer = configuration.precise_system(DIGITS).matrices()
    except PhysicsError:
        return found
    return tuple(_without(matrix, {pair for pair, size in small.items() if abs(more.get(pair, 0)) <= NOTHING * size})
                 for matrix, small, more in zip(found, doubted, finer, strict=True))


def _doubted(matrix: "Mapping[tuple[int, int], Any]") -> dict[tuple[int, int], float]:
    """{(i, j): the largest entry in its row or column} of entries that may be zeros."""
    largest: dict = {}
    for (i, j), value in matrix.items():
        for place in ("row", i), ("column", j):
            largest[place] = max(largest.get(place, 0.0), abs(value))
    found = {(i, j): max(largest["row", i], largest["column", j]) for i, j in matrix}
    return {pair: size for pair, size in found.items() if 0 < abs(matrix[pair]) <= SMALL * size}


def _without(matrix, zeros):
    return {pair: value for pair, value in matrix.items() if pair not in zeros} if zeros else matrix
