"""Sums over the modes that are left out, bounded from above:

    S(p) = Σ cₙ²/ωₙ²ᵖ      from      R(σ) = Σ cₙ²/(ωₙ² + σ²)²

both over n > N. With a = 4 − 2p, ∫ σᵃ⁻¹/(ω² + σ²)² dσ = ω^(a−4) Γ(a/2) Γ(2 − a/2)/2 over σ > 0, and R falls: on a grid
of σ its value at the left end of a cell is the largest. Below the grid R is at most (1 + σ₀²/Ω²)² R(σ₀), where no ω is
below Ω; above, R falls at least like σ^(2pₒ−4), pₒ being the power at which S begins to be finite.
"""

from math import gamma
from typing import cast

import numpy as np

LOW, HIGH, CELLS = -2.0, 20.0, 89       # octaves of the highest frequency that is counted, and how many σ
SAFE = 2.0          # of what lies above the grid, where nothing but the waves at the place should be felt
CLOSE = 1e-6        # of a power: as good as the one from which on S is finite
ROUNDING = 1e-11    # of a sum over all modes, and of those that are counted


def grid(highest: float) -> np.ndarray:
    """The σ for modes up to a frequency."""
    return highest * np.exp2(np.linspace(LOW, HIGH, CELLS))


def without_first(total: np.ndarray, sigma: np.ndarray, squares: np.ndarray, first: np.ndarray) -> np.ndarray:
    """R of columns, (σ, columns, columns), from the sum over all modes and the c of the first, (modes, columns)."""
    weight = squares + sigma[:, None] ** 2      # (σ, modes), as large as all else together
    np.divide(1, np.square(weight, out=weight), out=weight)
    known = np.einsum("sn,ni,nj->sij", weight, first, first, optimize=True)
    found: np.ndarray = total * (1 + ROUNDING) - known
    own = range(total.shape[-1])
    found[:, own, own] = np.maximum(found[:, own, own], ROUNDING * total[:, own, own])
    return found


def tail_sum(R: np.ndarray, sigma: np.ndarray, highest: float, power: float, begins: float) -> np.ndarray:
    """S(power), of matrices R (σ, …) those of cₙ cₙᵀ; infinite up to the power at which it `begins` to be finite."""
    below = (1 + (sigma[0] / highest) ** 2) ** 2
    if power <= begins + CLOSE:
        return np.full(R.shape[1:], np.inf)
    if power >= 2:
        return cast("np.ndarray", below * R[0] * highest ** (4 - 2 * power))
    a = 4 - 2 * power
    edges = sigma**a / a
    weights = np.append(np.diff(edges), SAFE * sigma[-1] ** a / (2 * (power - begins)))
    weights[0] += below * edges[0]
    return np.tensordot(weights, R, axes=1) * 2 / (gamma(a / 2) * gamma(2 - a / 2))
