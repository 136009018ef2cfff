"""Waves that leave a piece: where Re s < 0 what a bar, shaft or string answers differs little from the damper −√(Nμ).

Without drag and foundation a piece has, with Z = √(Nμ), x = s l √(μ/N),

    d = Z s [[coth x, −1/sinh x], [−1/sinh x, coth x]],    coth x = −1 + g,    g = 2 e^{2x}/(e^{2x} − 1).

A damper c beside it then adds up to s (c − Z) + Z s g: c − Z is formed once, of the numbers as they are given, so that
nothing of g is lost beside it where the damper is matched, or nearly so.
"""

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:

    from vibcli.numerics.pieces.piece import Piece

SAME = 2.0**-50     # of what is added: c is √(Nμ) as far as floats tell
NEAR = 0.25         # |Re x| below which the poles of g are near


def impedances(piece: "Piece", beta: np.ndarray) -> np.ndarray:
    """√(Nμ) of pieces, columns as of a PieceStack; 0 of those that are no plain bars, shafts or strings."""
    plain = (piece.bending == 0) & (piece.gradient == 0) & (piece.drag == 0) & (piece.foundation == 0)
    plain &= (beta == 0) & (piece.tension > 0) & (piece.inertia > 0)
    return np.sqrt(np.where(plain, piece.tension * piece.inertia, 0.0))


def without_leaving(C: np.ndarray,
                    parts: "Iterable[tuple[float, float, tuple[dict[int, float], ...]]]") -> np.ndarray:
    """C − Σ Z SᵀS of pieces (N, μ, rows S): an entry that is nothing beside what it is added from is 0."""
    found = np.array([[Fraction(0)] * len(C) for _ in C], object)
    size = np.abs(C)
    for tension, inertia, rows in parts:
        Z = _root(tension, inertia)
        for row in rows:
            for i, x in row.items():
                for j, y in row.items():
                    found[i, j] += Z * Fraction(float(x)) * Fraction(float(y))
                    size[i, j] += float(Z) * abs(float(x) * float(y))
    left = np.array([[float(Fraction(c) - part) for c, part in zip(row, parts, strict=True)]
                     for row, parts in zip(C.tolist(), found.tolist(), strict=True)]).reshape(C.shape)
    return np.where(np.abs(left) > SAME * size, left, 0.0)


def _root(tension: float, inertia: float) -> Fraction:
    """√(Nμ) to twice the digits of a float."""
    square = Fraction(tension) * Fraction(inertia)
    near = Fraction(float(np.sqrt(tension * inertia)))
    return near + (square - near * near) / (2 * near)


def leaving(piece: "Piece", Z: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Z s g and its slope by s, (pieces, N), for Re s < 0."""
    delay = piece.length * np.sqrt(piece.inertia / piece.tension)
    x = delay * s
    fading, less = np.exp(2 * x), np.expm1(2 * x)
    g = 2 * fading / less
    return Z * s * g, Z * g - Z * s * delay * 4 * fading / less**2


def leaving_room(piece: "Piece", Z: np.ndarray, s: np.ndarray, step: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """How far Z s g and Z s/sinh x can change within so long a step, (pieces, N); ∞ where a pole may be as near."""
    delay = piece.length * np.sqrt(piece.inertia / piece.tension)
    x, moved = delay * s, delay * step
    depth = -x.real - moved
    far = (depth > 0) & (-x.real > NEAR)
    fading = np.exp(-np.where(far, depth, 1.0))
    square = 4 * fading**2 / (1 - fading**2) ** 2               # 1/sinh²
    cosine = 2 * fading * (1 + fading**2) / (1 - fading**2) ** 2        # cosh/sinh²
    own = step * np.abs(2 * np.exp(2 * x) / np.expm1(2 * x)) + (abs(s) + step) * moved * square
    across = step * np.abs(2 * np.exp(x) / np.expm1(2 * x)) + (abs(s) + step) * moved * cosine
    return np.where(far, Z * own, np.inf), np.where(far, Z * across, np.inf)
