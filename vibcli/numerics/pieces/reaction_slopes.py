"""Derivatives by κ of what has none in closed form: the mean over a small circle (Cauchy), to some ten digits."""

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    from vibcli.numerics.pieces.piece import Piece

RADIUS, TURNS = 1e-3, 4     # of the circle, over the stiffness of a wave, and its points


def reaction_slope(piece: "Piece", kappa: Any, function: "Callable[..., np.ndarray]") -> np.ndarray:
    """∂f/∂κ, (…, values), of a function of κ (…) that is analytic and real where κ is."""
    kappa = np.asarray(kappa)
    size = np.abs(kappa).astype(float)
    length, bending, force = (abs(float(value)) for value in (piece.length, piece.bending, piece.tension))
    wave = (12 * bending / length**3 + bending**0.25 * size**0.75 + force / length + np.sqrt(force * size)) / length
    radius, found = RADIUS * wave, 0.0
    real = kappa.dtype.kind != "c"          # then the lower half of the circle mirrors the upper one
    turns = np.exp(2j * np.pi * (np.arange(TURNS) + 0.5) / TURNS)
    for turn in turns[:TURNS // 2] if real else turns:
        found = found + function(kappa + radius * turn) / turn
    slope = found / (TURNS * radius[..., None])
    result: np.ndarray = 2 * slope.real if real else slope
    return result
