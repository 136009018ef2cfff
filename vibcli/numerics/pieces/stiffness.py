"""The exact dynamic stiffness d(s) of pieces: forces on the ends = d(s) · end values."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.numerics.pieces.flattening import flattened
from vibcli.numerics.pieces.uniform import fourth_order, second_order

if TYPE_CHECKING:
    import mpmath

    from vibcli.numerics.pieces.piece import Piece


def dynamic_stiffness(piece: "Piece", s: Any) -> np.ndarray:
    """d(s), (…, m, m): forces (Q₀, Q_l), of beams (Q₀, M₀, Q_l, M_l), on the ends moving as e^{st}, symmetric.

    s and what the piece holds are numbers or arrays that broadcast to (…). Real for real s; of doubles, or of mpmath's
    numbers (an array of objects) where one is. d(0) is the static stiffness.
    """
    return stiffness(piece, piece.reaction(s))


def stiffness(piece: "Piece", kappa: Any) -> np.ndarray:
    """d of stiffness_and_slope."""
    return _found(piece, kappa, False)[0]


def stiffness_and_slope(piece: "Piece", kappa: Any) -> tuple[np.ndarray, np.ndarray]:
    """(d, ∂d/∂κ), each (…, m, m), as functions of κ = μ s² + c s + k alone.

    Undamped at ω with piece.undamped_reaction(ω), real; ∂d/∂(s²) is μ ∂d/∂κ, ∂d/∂s is (2 μ s + c) ∂d/∂κ. φᵀ ∂d/∂κ φ is
    ∫ u² dx of the deflection with end values φ. Rounding costs d a few roundings of its largest entry (lengths as
    units) and what a few roundings of κ and N change. Near a held frequency d has a pole: there |d|/|∂d/∂κ| is the
    distance of κ to it. An end without tension of what does not bend bears no force and its rows are 0: no coordinate
    belongs there.
    """
    d, slope = _found(piece, kappa, True)
    return d, slope


def _found(piece: "Piece", kappa: "complex | mpmath.mpc | np.ndarray", steep: bool) -> tuple[np.ndarray, ...]:
    """(d,) or (d, ∂d/∂κ)."""
    waves = np.asarray(kappa)
    plain = waves.dtype.kind == "c" and not waves.imag.any()        # real but for its type: half as dear
    flat = flattened(piece, waves.real if plain else kappa)

    def uniform(one: "Piece", kappa: np.ndarray) -> np.ndarray:
        if flat.order == 2:
            return second_order(one.length, one.tension, kappa, flat.numbers, steep)
        return fourth_order(one.length, one.bending, one.tension, kappa, flat.numbers, steep)

    def graded(one: "Piece", kappa: np.ndarray) -> np.ndarray:
        from vibcli.numerics.pieces.graded import graded_stiffness

        return np.stack(graded_stiffness(one, kappa, flat.numbers)[:1 + steep], axis=1)

    found = flat.filled((1 + steep, flat.order, flat.order), uniform, graded)
    found = found.astype(complex) if plain else found
    return tuple(found[..., which, :, :] for which in range(1 + steep))
