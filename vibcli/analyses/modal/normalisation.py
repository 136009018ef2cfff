"""Normalisation of mode shapes, stated with every shape that is shown.

first: the first coordinate is 1 (the next that moves where it rests); largest: the largest amplitude is 1;
mass: φᵀMφ = 1, the first that moves being positive. With members: analyses/continuous/mode_fields.py.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import mpmath
    import numpy as np

NEGLIGIBLE, ROUNDING = 1e-9, 4e-16
WORDS = {"first": "the first coordinate that moves is 1", "largest": "the largest amplitude is 1", "mass": "φᵀMφ = 1"}
ALONG = {"first": "the first coordinate that moves is 1, those of members aside, where none does the largest "
                  "displacement of the first member that moves",
         "largest": "the largest displacement is 1", "mass": "φᵀMφ = 1"}

OF_ROWS = {"first": "the first of these that moves is 1", "largest": "the largest of these amplitudes is 1"}
COMPLEX = "φᴴMφ = 1, φᴴ being φᵀ with the conjugate amplitudes"


def words(how: str, members: Any = (), damped: bool = False) -> str:
    """What a normalisation is, in words, of scenes with or without members, of whose damped modes what is printed is
    all that counts."""
    if damped and how == "mass":
        return COMPLEX
    return ((OF_ROWS if damped else ALONG) if members else WORDS)[how]


def normalised(shape: "Sequence[complex] | np.ndarray", how: str = "first",
               weights: Sequence[float] | None = None) -> "list[complex | mpmath.mpf]":
    """A mode shape in the normalisation asked for, as a list of numbers.

    `weights` √Mᵢᵢ make amplitudes of different units comparable, so that what rests is told from what moves little.
    """
    values = list(shape)
    sizes = [abs(value) * weight for value, weight in zip(values, weights or [1.0] * len(values), strict=True)]
    size = max(sizes, default=0)
    if not size:
        return values
    first = next(value for value, part in zip(values, sizes, strict=True) if part > NEGLIGIBLE * size)
    if how == "mass":
        return values if sign(first) > 0 else [-value for value in values]
    pivot = max(values, key=abs) if how == "largest" else first
    return [cleaned(value / pivot) for value in values]


def sign(value: Any) -> int:
    """Of an amplitude, or of the imaginary part of one that is imaginary."""
    number = complex(value)
    return -1 if (number.real or number.imag) < 0 else 1


def cleaned(value: Any) -> Any:
    """A complex amplitude without a part that is only its rounding."""
    if isinstance(value, complex) and value:
        real = value.real if abs(value.real) > ROUNDING * abs(value) else 0.0
        imaginary = value.imag if abs(value.imag) > ROUNDING * abs(value) else 0.0
        return complex(real, imaginary)
    return value


def weights(elements: Any) -> list[float]:
    """√Mᵢᵢ of each coordinate, of those without inertia an equivalent by stiffness."""
    M, K = [0.0] * elements.n, [0.0] * elements.n
    for diagonal, rows, extra in ((M, elements.inertias, elements.M), (K, elements.springs, elements.K)):
        for weight, row in rows:
            for i, x in row.items():
                diagonal[i] += abs(weight) * x * x
        for (i, j), value in extra.items():
            diagonal[i] += abs(value) * (i == j)
    for placed in elements.pieces:
        half, mass = placed.piece.order // 2, abs(placed.piece.inertia) * placed.piece.length / 3
        for number, row in enumerate(placed.rows):
            for i, x in row.items():
                M[i] += mass * x * x * (placed.piece.length**2 / 35 if number % half else 1)
    fastest = max((k / m for k, m in zip(K, M, strict=True) if m and k), default=1.0)
    return [(m or k / fastest) ** 0.5 for k, m in zip(K, M, strict=True)]
