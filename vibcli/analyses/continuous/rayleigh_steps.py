"""Steps towards a natural frequency by the Rayleigh quotient of D: z ← z + xᵀD x / xᵀD′x, x ← D⁻¹ D′ x."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.numerics.sparse_elimination import product, quadratic

if TYPE_CHECKING:
    from vibcli.analyses.continuous.system import ContinuousSystem
    from vibcli.numerics.sparse_elimination import Elimination

TAKEN_OUT, AT_MOST = 2, 8       # times; each leaves of another shape a millionth over the relative distance of its z
NOTHING_LEFT = 64   # roundings
GOLDEN = (5**0.5 - 1) / 2       # between the wave numbers of vectors to begin with, which then never repeat


def start(system: "ContinuousSystem", count_: int) -> np.ndarray:
    """Vectors that are orthogonal to nothing in particular, and independent up to n of them, (n, count)."""
    parts = np.sin(np.arange(1, system.n + 1)[:, None] * (1.7 + GOLDEN * np.arange(count_))) + 1.3
    return np.array([system.numbers(row) for row in parts]).reshape(system.n, count_)


def rayleigh_step(system: "ContinuousSystem", here: np.ndarray, x: np.ndarray
                  ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """z and x of one Rayleigh quotient of each column, with xᵀD′x = 1, and how many eigenvalues of D are negative here,
    where it has an inverse: beside a frequency z ends within aside² of it; a column that has no such x is no number."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        entries, sizes, slope = system.dynamic_stiffness(here)
        factors = system.eliminated(entries, sizes)
        x = factors.solved(product(system.pattern, slope, x))
        x = x / np.sqrt(quadratic(system.pattern, slope, x))
        return here + quadratic(system.pattern, entries, x), x, factors.negative()


def nearer(system: "ContinuousSystem", z: np.ndarray, loads: np.ndarray) -> np.ndarray:
    """x of D x = load close to z: at z itself D can have no inverse."""
    return _factors(system, z).solved(loads)


def settled(system: "ContinuousSystem", z: np.ndarray, entries: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Shapes near those of D(z) x = 0 with what is not of them taken out: x ← x − D⁻¹ D(z) x, D⁻¹ taken beside z."""
    factors = _factors(system, z)
    before = 0
    for times in range(AT_MOST):
        other = factors.solved(product(system.pattern, entries, x))
        size = abs(other).max(axis=0, initial=0)
        left = ~(size <= NOTHING_LEFT * system.unit * abs(x).max(axis=0, initial=0))
        if times >= TAKEN_OUT:      # shapes whose z are closer than a millionth are not told apart here
            left &= size < before / 2
        if not left.any():
            break
        x, before = np.where(left, x - other, x), size
    return x


def beside(system: "ContinuousSystem", z: np.ndarray) -> Any:
    """A z that is close, but none of those where D has no inverse."""
    return z + (abs(z) + system.aside * system.scale) * system.aside


def _factors(system: "ContinuousSystem", z: np.ndarray) -> "Elimination":
    entries, sizes, _ = system.dynamic_stiffness(beside(system, z))
    return system.eliminated(entries, sizes)
