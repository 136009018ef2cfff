"""The exact stiffness of uniform pieces, split into what moves evenly and oddly about their middle."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.numerics.pieces.parity import parity_functions
from vibcli.numerics.pieces.scaled_functions import even_functions

if TYPE_CHECKING:
    from vibcli.numerics.pieces.arithmetic import Arithmetic


def second_order(length: np.ndarray, tension: np.ndarray, kappa: np.ndarray, numbers: "Arithmetic",
                 steep: bool) -> np.ndarray:
    """d and, if it is `steep`, ∂d/∂κ of −N u″ + κ u = 0, (N, 1 or 2, 2, 2), over flat arrays of equal shape.

    With z = κ a²/N, a = l/2: evenly N/a z S/C, oddly N/a C/S.
    """
    half = length / 2
    z = kappa * half * half / tension
    f = even_functions(z, numbers)
    scale, ratio, fading = tension / half, f.s / f.c, numbers.exp(-2 * f.r)
    even, odd, coupling = scale * z * ratio, scale / ratio, -scale * fading / (f.s * f.c)
    own, coupling = (even + odd) / 2, coupling / 2
    if not steep:
        return _squares([[own, coupling], [coupling, own]])
    even_slope = half * (ratio + fading / f.c**2) / 2
    near = np.abs(z) <= 1
    safe = np.where(near, 1, z)
    odd_slope = half * np.where(near, (1 / 2 - f.c * f.slope / f.s**2), (1 / ratio - fading / f.s**2) / (2 * safe))
    own_slope, coupling_slope = (even_slope + odd_slope) / 2, (even_slope - odd_slope) / 2
    return _squares([[own, coupling], [coupling, own]],
                    [[own_slope, coupling_slope], [coupling_slope, own_slope]])


def fourth_order(length: np.ndarray, bending: np.ndarray, tension: np.ndarray, kappa: np.ndarray,
                 numbers: "Arithmetic", steep: bool) -> np.ndarray:
    """d and, if it is `steep`, ∂d/∂κ of B u⁗ − N u″ + κ u = 0, (N, 1 or 2, 4, 4), over flat arrays of equal shape.

    Right ends moving with (u, a θ), evenly (the left end: u, −θ) and oddly (−u, θ), are answered in B/a³ by

        even [[χ s, −χ σ], [−χ σ, c]] / d,      odd [[c, −d], [−d, s]] / σ.
    """
    half = length / 2
    square, scale = half * half, bending / half**3
    chi = kappa * (square * square) / bending
    f = parity_functions(tension * square / bending, chi, numbers, steep)
    sigma = 3 * f.sigma                                     # 1 without tension and reaction, where 1/3 is rounded
    even, odd = (chi * f.s / f.d, -chi * f.sigma / f.d, f.c / f.d), (3 * f.c / sigma, -3 * f.d / sigma, 3 * f.s / sigma)
    coupling = (-3 * f.uu / (f.d * sigma), -3 * f.ut / (f.d * sigma), 3 * f.tt / (f.d * sigma))
    found = _four(even, odd, coupling, half, scale)
    if not steep:
        return _squares(found)
    c_slope, s_slope, d_slope, sigma_slope = f.slopes
    lean, turn = d_slope / f.d, sigma_slope / f.sigma
    even_slope = (((f.d + f.s) / 2 - chi * f.s * lean) / f.d,
                  (chi * f.sigma * lean - f.sigma - chi * sigma_slope) / f.d, (c_slope - f.c * lean) / f.d)
    odd_slope = ((c_slope - f.c * turn) / f.sigma, (f.d * turn - d_slope) / f.sigma, (s_slope - f.s * turn) / f.sigma)
    coupling_slope = [e - o for e, o in zip(even_slope, odd_slope, strict=True)]
    return _squares(found, _four(even_slope, odd_slope, coupling_slope, half, half))


def _four(even: tuple[np.ndarray, np.ndarray, np.ndarray], odd: tuple[np.ndarray, np.ndarray, np.ndarray],
          coupling: Sequence[np.ndarray], half: np.ndarray,
          scale: np.ndarray) -> tuple[tuple[np.ndarray, ...], ...]:
    """(u₀, θ₀, u_l, θ_l) from the halves of even ± odd; mirrored, θ turns its sign."""
    uu, ut, tt = ((e + o) / 2 * scale for e, o in zip(even, odd, strict=True))
    ut, tt = ut * half, tt * half * half
    xuu, xut, xtt = (value / 2 * scale for value in coupling)
    xut, xtt = xut * half, xtt * half * half
    return ((uu, -ut, xuu, xut), (-ut, tt, -xut, -xtt), (xuu, -xut, uu, ut), (xut, -xtt, ut, tt))


def _squares(*matrices: Sequence[Sequence[np.ndarray]]) -> np.ndarray:
    """(N, number of matrices, m, m) of m rows of m flat arrays each."""
    m, kind = len(matrices[0]), np.result_type(*{values.dtype for rows in matrices for row in rows for values in row})
    found = np.empty((len(matrices), m, m, *matrices[0][0][0].shape), kind)     # each entry in one run
    for which, rows in enumerate(matrices):
        for i, row in enumerate(rows):
            for j, values in enumerate(row):
                found[which, i, j] = values
    return found.transpose(3, 0, 1, 2)
