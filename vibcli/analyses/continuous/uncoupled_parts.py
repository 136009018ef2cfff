"""Parts of a system that move without one another, as a straight beam stretches along and bends across: what one of
them is driven by does nothing to the others."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.excitation.linear_output import LinearOutput
    from vibcli.mechanics.factored_system import PlacedPiece

FELT = 1e-9         # of the largest entry of a mode: what moves in it
ROUNDING = 1e-12    # of the largest slope of an end: what is none


class UncoupledParts(NamedTuple):
    """The numbers of the parts that coordinates and pieces belong to."""

    coordinates: list[int]
    pieces: list[int]

    def split(self, output: "LinearOutput") -> "list[tuple[int, LinearOutput]]":
        """[(part, what an output reads of it)]."""
        if len({*self.coordinates, *self.pieces}) < 2:
            return [(0, output)]
        found = []
        for part in sorted({*self.coordinates, *self.pieces}):
            own = [{i: x for i, x in row.items() if self.coordinates[i] == part} for row in (
                output.q, output.v, output.a)]
            places = {place: x for place, x in output.places.items() if self.pieces[place.piece] == part}
            if places or any(own):
                found.append((part, output._replace(q=own[0], v=own[1], a=own[2], places=places)))
        return found


def uncoupled_parts(K: np.ndarray, M: np.ndarray, pieces: "Sequence[PlacedPiece]",
                    shapes: np.ndarray) -> UncoupledParts:
    """Those of coordinates that neither K, M nor pieces tie; one where a piece has no coordinates, or where modes of
    these shapes (coordinates, modes) mix them, as at one frequency they may."""
    n, parts = len(K), tied_parts((K, M), [placed.rows for placed in pieces])
    felt = np.abs(shapes) > FELT * np.abs(shapes).max(axis=0, initial=0.0)
    moved = [felt[[i for i in range(n) if parts.coordinates[i] == part]].any(axis=0) for part in set(parts.coordinates)]
    mixed = bool((np.sum(moved, axis=0) > 1).any())
    return UncoupledParts([0] * n, [0] * len(pieces)) if mixed or max(parts.pieces, default=0) >= n else parts


def tied_parts(matrices: Sequence[np.ndarray], rows: "Sequence[Sequence[Mapping[int, Any]]]") -> UncoupledParts:
    """Those of coordinates that neither matrices tie nor pieces, whose ends have these rows; a piece without
    coordinates is a part of its own, numbered behind them."""
    n = len(matrices[0])
    ties = np.eye(n, dtype=bool) | np.any([matrix != 0 for matrix in matrices], axis=0)
    ties |= ties.T
    held = [[i for row in ends for i, x in row.items()
             if i < n and abs(x) > ROUNDING * max(map(abs, row.values()))] for ends in rows]
    for group in held:
        ties[np.ix_(group, group)] = True
    numbers = list(range(n))
    for _ in range(n):
        numbers = [min(numbers[j] for j in np.flatnonzero(ties[i])) for i in range(n)]
    return UncoupledParts(numbers, [numbers[group[0]] if group else n + p for p, group in enumerate(held)])
