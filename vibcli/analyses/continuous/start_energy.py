"""Twice the energy of what a motion starts with: ∫ B u″² + N u′² + k u² + μ v² dx of members and that of all else."""

from math import inf
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.disturbances import derivatives
from vibcli.numerics.pieces.stiffness import stiffness

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.exact_transfer import ExactTransfer
    from vibcli.analyses.excitation.forcing import Forcing, Segment
    from vibcli.mechanics.factored_system import PlacedPiece

PLACES, WAVES = 16, 4.0     # of Gauss's rule on a panel, and how far fields may turn or grow over one
GAP = 1e-11         # of the largest end value: what is none


def start_energy(transfer: "ExactTransfer", begun: tuple[np.ndarray, np.ndarray], given: "Sequence[Any]") -> float:
    """Of coordinates and their rates and of (u, v) over each piece, Forcings of the place, None where a piece is at
    rest between its ends; inf where a piece is torn off them, or bent sharply."""
    (q, v), (K, _, M) = begun, transfer.matrix.polynomial
    found = float(q @ K @ q + v @ M @ v)
    for one, (u, speed) in zip(transfer.pieces, given, strict=True):
        ends = np.array([sum(x * q[i] for i, x in row.items() if i < len(q)) for row in one.rows])
        if u is None:
            found += float(ends @ stiffness(one.piece, np.float64(one.piece.foundation)) @ ends)
        else:
            found += of_field(one, u, ends)
        found += 0.0 if speed is None else one.piece.inertia * _squares(speed, one.piece.length)[0]
    return found


def of_field(one: "PlacedPiece", u: "Forcing", ends: np.ndarray) -> float:
    """Of a field, whose values and slopes have to be those of the ends and continuous."""
    piece, half = one.piece, one.piece.order // 2
    edges = edges_of(u, piece.length)
    sides = [np.array([_along(segment, x) for x in (low, high)]) for segment, low, high in edges]
    joined = [ends[:half], *(side[at][:half] for side in sides for at in range(2)), ends[half:]]
    for order in range(half):
        values = np.array([part[order] for part in joined]).reshape(-1, 2)
        if (np.abs(values[:, 0] - values[:, 1]) > GAP * np.abs(values).max()).any():
            return inf
    squares = _squares(u, piece.length)
    tension = piece.tension * squares[1] + piece.gradient * squares[3]
    return float(piece.foundation * squares[0] + tension + (piece.bending * squares[2] if half == 2 else 0.0))


def edges_of(given: "Forcing", length: float) -> "list[tuple[Segment, float, float]]":
    """[(segment, from, to)], counted from the start of the piece."""
    segments = given.segments(inf)
    starts = [max(0.0, one.start) for one in segments]
    return [(one, low, high) for one, low, high in zip(segments, starts, [*starts[1:], length], strict=True)
            if low < min(high, length)]


def _along(segment: "Segment", x: float) -> np.ndarray:
    """u, u′ and u″."""
    return sum((derivatives(wave, x - segment.start, 3)[0] for wave in segment.waves if not wave.channel), np.zeros(3))


def _squares(given: "Forcing", length: float) -> np.ndarray:
    """∫ u² dx, ∫ u′² dx, ∫ u″² dx and ∫ x u′² dx."""
    found = np.zeros(4)
    for segment, low, high in edges_of(given, length):
        x, rule = rule_between([segment], low, high, length)
        u = np.array([_along(segment, place) for place in x])
        found += rule @ np.column_stack([u**2, x * u[:, 1] ** 2])
    return found


def rule_between(segments: "Sequence[Segment]", low: float, high: float,
                 length: float) -> tuple[np.ndarray, np.ndarray]:
    """(places, weights) of Gauss's rule for squares of fields between two places of a piece."""
    nodes, weights = np.polynomial.legendre.leggauss(PLACES)
    waves = [wave for one in segments for wave in one.waves]
    pace = max((abs(complex(wave.exponent)) + wave.power / length for wave in waves), default=0.0)
    panels = 1 + int(pace * (high - low) / WAVES)
    x = low + (high - low) / panels * (np.arange(panels)[:, None] + (1 + nodes) / 2).ravel()
    return x, np.tile(weights, panels) * (high - low) / panels / 2
