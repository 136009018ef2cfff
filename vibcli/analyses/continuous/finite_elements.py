"""Members in finite elements, with which approximations are made: cubic displacements of beams, linear ones of others.

    K = ∫ (B N″N″ᵀ + (N + n x) N′N′ᵀ + k N Nᵀ) dx      M = ∫ μ N Nᵀ dx      (Przemieniecki 1968, ch. 5 and 11)
"""

from typing import TYPE_CHECKING, Any, cast

import numpy as np

if TYPE_CHECKING:
    from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
    from vibcli.numerics.pieces.piece import Piece

AT, WEIGHTS = np.polynomial.legendre.leggauss(5)
SLACK = 1e-13       # of the largest tension: less is none
AT, WEIGHTS = (AT + 1) / 2, WEIGHTS / 2     # exact to degree 9


def finite_elements(elements: "FactoredSystem", divisions: int) -> tuple[np.ndarray, np.ndarray]:
    """K and M of a system each of whose pieces is so many elements: (n + inner nodes) square; inner nodes come last."""
    size, nodes = element_nodes(elements, divisions)
    parts = [(one, (*rows[i], *rows[i + 1])) for placed, rows in zip(elements.pieces, nodes, strict=True)
             for i, one in enumerate(divided(placed.piece, divisions))]
    K, M = np.zeros((size, size)), np.zeros((size, size))
    discrete = elements.with_parts(pieces=()).arrays()
    M[:elements.n, :elements.n], K[:elements.n, :elements.n] = discrete[0], discrete[3]
    for part, rows in parts:
        S = rows_as_array(rows, size)
        moved = np.flatnonzero(S.any(axis=0))       # few of many
        S, at = S[:, moved], np.ix_(moved, moved)
        k, m = element_matrices(part)
        K[at] += S.T @ k @ S
        M[at] += S.T @ m @ S
    return K, M


def element_nodes(elements: "FactoredSystem", divisions: int) -> tuple[int, list[list[tuple[dict[int, float], ...]]]]:
    """(how many coordinates there are, [rows of each node of a piece, its ends among them] of each piece)."""
    size, found = elements.n, []
    for placed in elements.pieces:
        half = len(placed.rows) // 2
        rows = with_slack_ends(placed, size)
        size += len(slack_ends(placed))
        inner = [tuple({size + half * k + i: 1.0} for i in range(half)) for k in range(divisions - 1)]
        size += half * len(inner)
        found.append([rows[:half], *inner, rows[half:]])
    return size, found


def divided(piece: "Piece", divisions: int) -> "list[Piece]":
    """Its elements."""
    length = piece.length / divisions
    return [piece._replace(length=length, tension=piece.tension + piece.gradient * i * length)
            for i in range(divisions)]


def slack_ends(placed: "PlacedPiece") -> list[int]:
    """Which of its ends have no coordinate and no tension: they move unheld."""
    piece = placed.piece
    if piece.order == 4:
        return []
    tensions = [float(piece.tension), float(piece.tension + piece.gradient * piece.length)]
    least = SLACK * max(map(abs, tensions))
    return [i for i, tension in enumerate(tensions) if not placed.rows[i] and abs(tension) <= least]


def with_slack_ends(placed: "PlacedPiece", size: int) -> tuple[dict[int, float], ...]:
    """Its rows, those of slack ends with coordinates of their own, which count from `size` on."""
    rows = list(placed.rows)
    for j, i in enumerate(slack_ends(placed)):
        rows[i] = {size + j: 1.0}
    return tuple(rows)


def rows_as_array(rows: Any, size: int) -> np.ndarray:
    """Rows {coordinate index: component} as an array."""
    found = np.zeros((len(rows), size))
    for i, row in enumerate(rows):
        for j, x in row.items():
            found[i, j] = x
    return found


def element_matrices(piece: "Piece") -> tuple[np.ndarray, np.ndarray]:
    """K and M of one element, of (u₀, u_l), of beams (u₀, u₀′, u_l, u_l′)."""
    length = float(piece.length)
    values = shapes(piece.order, length, AT)[:3]
    tension = float(piece.tension) + float(piece.gradient) * AT * length
    K: Any = sum(_products(f, factor * WEIGHTS * length) for f, factor in zip(
        values[::-1], (float(piece.bending), tension, float(piece.foundation))[-len(values):], strict=True))
    return K, _products(values[0], float(piece.inertia) * WEIGHTS * length)


def _products(values: np.ndarray, weights: np.ndarray) -> np.ndarray:
    return cast("np.ndarray", (values * weights) @ values.T)


def shapes(order: int, length: float, x: np.ndarray) -> tuple[np.ndarray, ...]:
    """N, N′, …, as far as they are not zero, at parts x of the length, for each of the coordinates of an element."""
    if order == 2:
        return np.array([1 - x, x]), np.array([0 * x - 1, 0 * x + 1]) / length
    return (np.array([1 - 3*x**2 + 2*x**3, length * (x - 2*x**2 + x**3), 3*x**2 - 2*x**3, length * (x**3 - x**2)]),
            np.array([(6*x**2 - 6*x) / length, 1 - 4*x + 3*x**2, (6*x - 6*x**2) / length, 3*x**2 - 2*x]),
            np.array([(12*x - 6) / length, 6*x - 4, (6 - 12*x) / length, 6*x - 2]) / length,
            np.array([0*x + 12 / length, 0*x + 6, 0*x - 12 / length, 0*x + 6]) / length**2)
