"""Where damped modes of members are looked for: along the imaginary axis, between places to which waves turn by a part
of π on all pieces together; along rays for what decays faster; and where pieces vibrate with their ends held.
"""

from typing import TYPE_CHECKING, Any, cast

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.numerics.pieces.piece import Piece

RAYS, TURNS = 60, 7     # estimates on each of so many rays from the negative real axis on
WIDE = 1.5              # half turns of waves between roots beyond which one is looked for there,
DECAYS = 0.05, 0.5, 0.95        # with decays of all roots: quantiles


def estimates(matrix: "DynamicMatrix", rates: np.ndarray, radius: float, count: float, effort: int) -> np.ndarray:
    """Points from which roots beyond a radius are looked for, up to about `count` turns of waves, the rates within it
    being known; effort: times as many."""
    phases = np.arange(0.0, count + matrix.n + 4 * len(matrix.pieces), 0.5 / effort)
    line = where_waves_turn(matrix.pieces, np.pi * phases)
    line = line[line > 0.8 * radius]
    if not len(line):
        return np.zeros(0, complex)
    tail = rates[rates.imag > 0][-4:].real
    decay = float(tail.mean()) if len(tail) else 0.0
    rows = [decay + 1j * line[::2], 1j * line[1::2], *(-line[0] / 16 * k + 1j * line for k in range(1, effort))]
    rays = np.geomspace(0.9 * radius, line[-1], RAYS * effort)
    turned = np.exp(1j * np.pi * (1 - np.arange(TURNS) / (2 * TURNS)))
    return np.concatenate([*rows, np.outer(turned, rays).ravel()])


def inner_estimates(pieces: "Sequence[PlacedPiece]", low: float, high: float) -> np.ndarray:
    """Where pieces vibrate with their ends held, or nearly so: low < |s| < high."""
    found = [np.zeros(0, complex)]
    for one in (placed.piece for placed in pieces):
        last = int(one.length * float(_wave_number(one, np.float64(high))) / np.pi) + 1
        k = np.pi * (np.arange(1, last + 1) + (0.5 if one.order == 4 else 0.0)) / one.length
        stiff = one.foundation + (one.tension + one.gradient * one.length / 2) * k**2 + one.bending * k**4
        s = (np.sqrt(one.drag**2 - 4 * one.inertia * stiff + 0j) - one.drag) / (2 * one.inertia)
        found.append(s[(abs(s) > 0.8 * low) & (abs(s) < high)])
    return np.concatenate(found)


def between(pieces: "Sequence[PlacedPiece]", roots: np.ndarray) -> np.ndarray:
    """Points in the gaps of roots across which waves turn so far that one of them may have been missed."""
    swinging = roots[roots.imag > 0]
    line = np.sort(swinging.imag)
    wide = np.flatnonzero(np.diff(half_turns(pieces, line)) > WIDE)
    if not len(wide):
        return np.zeros(0, complex)
    found: np.ndarray = np.add.outer(np.quantile(swinging.real, DECAYS), 0.5j * (line[wide] + line[wide + 1])).ravel()
    return found


def half_turns(pieces: "Sequence[PlacedPiece]", omega: Any) -> Any:
    """Σ k l/π of waves at frequencies."""
    return sum((one.piece.length * _wave_number(one.piece, omega) for one in pieces), 0 * omega) / np.pi


def where_waves_turn(pieces: "Sequence[PlacedPiece]", phases: np.ndarray) -> np.ndarray:
    """ω at which Σ k l is each of these."""
    low, high, turns = np.zeros(len(phases)), np.ones(len(phases)), phases / np.pi
    while (half_turns(pieces, high) < turns).any():
        high = high * 4
    for _ in range(60):
        middle = (low + high) / 2
        short = half_turns(pieces, middle) < turns
        low, high = np.where(short, middle, low), np.where(short, high, middle)
    return high


def _wave_number(piece: "Piece", omega: float | np.ndarray) -> float | np.ndarray:
    """k of waves with B k⁴ + N k² = μ ω² − κ; 0 where none travel."""
    tension, inertia = piece.tension + piece.gradient * piece.length / 2, piece.inertia * omega**2 - piece.foundation
    inertia = np.maximum(inertia, 0.0)
    if piece.order == 2:
        return cast("float | np.ndarray", np.sqrt(inertia / tension))
    square = np.sqrt(tension**2 + 4 * piece.bending * inertia) - tension
    return cast("float | np.ndarray", np.sqrt(np.maximum(square, 0.0) / (2 * piece.bending)))
