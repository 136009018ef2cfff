"""How large a motion is: what its errors are relative to.

The error of q is relative to how far each coordinate has moved, that of q̈ to its largest; those of little motion are
held to LEAST of the one that moves most, √Mᵢᵢ qᵢ being compared, so that units do not matter.
"""

from collections.abc import Callable, Sequence
from math import sqrt
from typing import TYPE_CHECKING

import numpy as np

from vibcli.numerics.state_space import first_order

if TYPE_CHECKING:
    from vibcli.mechanics.numeric_equations import NumericEquations

LEAST = 1e-3
EPSILON = 2.0**-52
STEP = 1e-6
FEW = 20                # coordinates for which eigenvalues are found


class Sizes:
    """moved: the farthest that each coordinate has been from its start; largest: of |q̈|; radian: 1/|λ| of the fastest
    eigenvalue of the equations linearised [s]; noise: the rounding error of q̈; slopes: |∂q̈/∂q|; weight: √Mᵢᵢ."""

    __slots__ = ("largest", "moved", "noise", "origin", "radian", "slopes", "weight")

    def __init__(self, q: np.ndarray) -> None:
        self.origin, self.moved, self.largest = q.copy(), np.zeros(len(q)), np.zeros(len(q))

    def measure(self, system: "NumericEquations", accelerations: Callable[..., np.ndarray], t: float, q: np.ndarray,
                v: np.ndarray, g: Sequence[float]) -> np.ndarray:
        """Take weight, radian and noise from the system as it is at t; q̈ there."""
        self.weight = np.sqrt(np.maximum(system.inertia.rows(np.array([t]), q[:, None], v[:, None], g)[:, 0], 1e-300))
        a, J = jacobian(accelerations, t, q, v)
        n = len(q)
        self.radian, self.noise = np.inf, 4 * EPSILON * system.sizes(t, q, v, g) / self.weight**2
        self.slopes = np.zeros((n, n))
        if np.isfinite(J).all():
            fastest = _fastest(J[:, :n], J[:, n:], self.weight)
            self.radian = 1.0 / fastest if fastest > 0 else np.inf
            self.slopes = np.abs(J[:, :n])
            self.noise += EPSILON * (np.abs(J) @ np.abs(np.concatenate([q, v])))
        self.meet(a[:, None])
        return a

    def roughen(self, factor: float) -> None:
        """Take the rounding error of q̈ to be so many times as large, if that is more."""
        self.noise = self.noise * max(factor, 1.0)

    def meet(self, a: np.ndarray) -> None:
        """Note accelerations of shape (n, instants)."""
        self.largest = np.maximum(self.largest, self.lifted(np.abs(a).max(axis=1)))

    def move(self, q: np.ndarray) -> None:
        self.moved = np.maximum(self.moved, np.abs(q - self.origin))

    def scale(self, H: float, v: np.ndarray, a: np.ndarray) -> np.ndarray:
        """The size of each coordinate to which its error is compared; that of a motion that begins is taken from what
        it does within a radian."""
        T = min(H, self.radian)
        size = self.lifted(np.maximum(self.moved, np.maximum(T * np.abs(v), T * T * np.abs(a))))
        size = np.maximum(size, LEAST * np.abs(self.origin))
        return np.where(size > 0, size, 1.0)

    def lifted(self, size: np.ndarray) -> np.ndarray:
        """Sizes of those that move little, lifted to LEAST of the largest."""
        weighted = size * self.weight
        found: np.ndarray = np.maximum(weighted, LEAST * weighted.max(initial=0.0)) / self.weight
        return found


def _fastest(K: np.ndarray, C: np.ndarray, weight: np.ndarray) -> float:
    """The largest |λ| of δ̈ = K δ + C δ̇; of many coordinates a bound, √‖K‖ + ‖C‖ with the coordinates weighted."""
    n = len(K)
    if n == 1:
        k, half = float(K[0, 0]), abs(float(C[0, 0])) / 2
        return half + sqrt(half * half + k) if half * half + k >= 0 else sqrt(-k)
    if n <= FEW:
        found: float = np.abs(np.linalg.eigvals(first_order(-K, -C))).max()
        return found
    rows = [np.abs(weight[:, None] * matrix / weight).sum(axis=1).max() for matrix in (K, C)]
    result: float = np.sqrt(rows[0]) + rows[1]
    return result


def jacobian(accelerations: Callable[..., np.ndarray], t: float, q: np.ndarray,
             v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(q̈, [∂q̈/∂q, ∂q̈/∂q̇]) by differences."""
    n = len(q)
    size = np.abs([q, v])
    largest = size.max(axis=1, keepdims=True, initial=0.0)
    step = STEP * np.where(size > 0, size, np.where(largest > 0, largest, 1e-3)).ravel()
    moved = np.repeat(np.concatenate([q, v])[:, None], 2 * n + 1, 1)
    moved[range(2 * n), range(1, 2 * n + 1)] += step
    found = accelerations(np.full(2 * n + 1, t), moved[:n], moved[n:])
    return found[:, 0], (found[:, 1:] - found[:, :1]) / step
