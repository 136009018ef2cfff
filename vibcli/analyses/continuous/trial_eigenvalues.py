"""Estimates of complex frequencies: members between their nodes in polynomials, from which exact ones are looked for.

    (λ² M + λ C + K) x = 0,    u = nodes' shapes + Σ a_j ∫…∫P_j,    P_j Legendre's polynomials

What the ends do is linear, of beams cubic; integrals of P_j that vanish at both ends (of beams with their slopes) come
besides. Nothing is certain of these: they are where exact roots are looked for.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.polynomial import legendre

from vibcli.analyses.continuous.finite_elements import rows_as_array, slack_ends, with_slack_ends

if TYPE_CHECKING:
    from vibcli.analyses.continuous.dynamic_matrix import DynamicMatrix
    from vibcli.numerics.pieces.piece import Piece

LARGEST = 700       # coordinates of an estimate


def trial_eigenvalues(matrix: "DynamicMatrix", functions: "list[int]", shift: float) -> np.ndarray | None:
    """Eigenvalues with so many functions within each piece; None where these are too many. shift > 0: a real s that is
    none of them, near those that are wanted."""
    at, rows = matrix.n, []
    for placed in matrix.pieces:
        rows.append(with_slack_ends(placed, at))
        at += len(slack_ends(placed))
    size = at + sum(functions)
    if size > LARGEST:
        return None
    K, C, M = (np.pad(part, (0, size - matrix.n)) for part in matrix.polynomial)
    for placed, ends, count in zip(matrix.pieces, rows, functions, strict=True):
        piece = placed.piece._make(float(x) for x in placed.piece)
        k, m = piece_matrices(piece, count)
        S = np.vstack([rows_as_array(ends, size), np.eye(size)[at:at + count]])
        at += count
        K += S.T @ k @ S
        M += S.T @ (piece.inertia * m) @ S
        C += S.T @ (piece.drag * m + float(placed.retardation) * k) @ S
    return eigenvalues(K, C, M, shift)


def eigenvalues(K: np.ndarray, C: np.ndarray, M: np.ndarray, shift: float) -> np.ndarray:
    """All finite λ with Im λ ≥ 0, from 1/(λ − shift), so that M may be singular."""
    n = len(K)
    moved, slope = K + shift * (C + shift * M), (C + 2 * shift * M) * shift
    scale = 1 / np.sqrt(np.maximum(abs(np.diagonal(moved)), 1e-300))
    moved, slope, inertia = (part * scale[:, None] * scale for part in (moved, slope, M * shift**2))
    companion = np.block([[np.linalg.solve(-moved, slope), np.linalg.solve(-moved, inertia)],
                          [np.eye(n), np.zeros((n, n))]])
    nu = np.linalg.eigvals(companion)
    found = shift + shift / nu[abs(nu) > 1e-9]
    return found[found.imag >= 0]


def piece_matrices(piece: "Piece", count: int) -> tuple[np.ndarray, np.ndarray]:
    """Stiffness and ∫φφᵀ dx over the end values and so many functions."""
    degree = count + 5
    x, w = legendre.leggauss(degree + 1)
    w = w * piece.length / 2
    values = _functions(piece, count, x)
    tension = piece.tension + piece.gradient * piece.length * (1 + x) / 2
    k = (values[1] * (w * tension)) @ values[1].T + piece.foundation * (values[0] * w) @ values[0].T
    if piece.order == 4:
        k = k + piece.bending * (values[2] * w) @ values[2].T
    return k, (values[0] * w) @ values[0].T


def _functions(piece: "Piece", count: int, x: np.ndarray) -> "list[Any]":
    """φ, φ′ and φ″ at the points x of −1 … 1, each (functions, points)."""
    half, order = piece.length / 2, piece.order
    P = legendre.legvander(x, count + 4).T
    once = [(P[j + 1] - P[j - 1]) / (2 * j + 1) for j in range(1, count + 3)]      # of P_j from j = 1
    if order == 2:
        ends = [[(1 - x) / 2, (1 + x) / 2], [-0.5 + 0 * x, 0.5 + 0 * x]]
        inner = [once[:count], [P[j] for j in range(1, count + 1)]]
        weights = [np.sqrt(j + 0.5) for j in range(1, count + 1)]
    else:
        a, b = (1 - x) / 2, (1 + x) / 2
        ends = [[a * a * (1 + 2 * b), a * a * b * 2 * half, b * b * (1 + 2 * a), -b * b * a * 2 * half],
                [-3 * a * b, a * (a - 2 * b) * half, 3 * a * b, b * (b - 2 * a) * half],
                [1.5 * (b - a), (b - 2 * a) * half, 1.5 * (a - b), (2 * b - a) * half]]
        twice = [((P[j + 2] - P[j]) / (2 * j + 3) - (P[j] - P[j - 2]) / (2 * j - 1)) / (2 * j + 1)
                 for j in range(2, count + 2)]
        inner = [twice, once[1:count + 1], [P[j] for j in range(2, count + 2)]]
        weights = [np.sqrt(j + 0.5) for j in range(2, count + 2)]
    own = np.array(weights).reshape(-1, 1)
    return [np.vstack([e, np.array(i).reshape(count, len(x)) * own]) / half**power
            for power, (e, i) in enumerate(zip(ends, inner, strict=True))]
