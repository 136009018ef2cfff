"""The undamped eigenvalues of up to some forty coordinates, enclosed in fixed-point arithmetic.

M̂ = L Lᵀ, A = L⁻¹ K̂ L⁻ᵀ, massless coordinates eliminated first: K_aa − K_az K_zz⁻¹ K_za.
"""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from vibcli.analyses.modal.scaling import Scaling, exponent, mechanism, unmoved
from vibcli.numerics import fixed_point as fx
from vibcli.numerics.symmetric_eigenvalues import Spectrum, spectrum

GUARDS = (160, 640, 2560)
STEEP = 24
ZERO = 60


class EnclosedEigenvalues:
    """Scaled eigenvalues λ̂ = ω̂² in fixed point with what bounds them, and M̂-normalised shapes in columns.

    zeros: how many vanish by structure, None where that is not known; zero: flags of those that are zero.
    off: log2 of a bound of the error of each λ̂.
    """

    __slots__ = ("bits", "off", "shapes", "values", "zero", "zeros")

    def __init__(self, found: Spectrum, reduced: "StandardForm", zeros: int | None) -> None:
        self.values, self.bits, self.zeros = found.values, found.bits, zeros
        self.off = np.log2(np.maximum(found.radius, 1e-300)) - found.shift
        self.shapes = reduced.full(found.vectors)
        self._find_zeros()

    def _find_zeros(self) -> None:
        if self.zeros is None:
            self.zero = self.sizes() <= self.off + 1
        else:
            self.zero = np.zeros(len(self.off), bool)
            self.zero[np.argsort(self.sizes(), kind="stable")[:self.zeros]] = True

    def sizes(self) -> np.ndarray:
        """log2 |λ̂|."""
        with np.errstate(divide="ignore"):
            found: np.ndarray = np.log2(np.abs(fx.floats(self.values, self.bits)))
            return found

    def add_data_error(self, elements: Any, scale: Scaling, unit: float) -> None:
        """Takes a relative rounding 2^unit of every weight and component into the bounds."""
        sizes = self.sizes()
        rows, sums = sensitivity(elements, scale, fx.floats(self.shapes, self.bits), 2.0 ** sizes)
        with np.errstate(divide="ignore"):
            self.off = np.logaddexp2(self.off, np.log2(rows) + unit)
            self.off = np.logaddexp2(self.off, np.log2(sums) + (unit if unit > -np.inf else -53.0))
        self._find_zeros()

    def errors(self) -> np.ndarray:
        """log2 of the relative bounds of √|λ̂|, their last rounding not counted; −inf for zeros."""
        relative = self.off - self.sizes()
        relative[self.zero] = -np.inf
        found: np.ndarray = np.where(relative < -2, relative - 1 + 2.0 ** np.minimum(relative + 1, 0), relative + 1)
        return found

    def settled(self, goal: float) -> bool:
        """Whether every value is known to `goal` and every zero follows from the structure."""
        decided = self.zeros is not None or not self.zero.any()
        return decided and bool((self.errors() <= math.log2(goal)).all())


def enclosed(elements: Any, scale: Scaling, zeros: int | None, goal: int = 60) -> EnclosedEigenvalues:
    """Encloses the eigenvalues of the numbers in `elements`, taken as exact, to 2^-goal."""
    for guard in GUARDS:
        bits = guard + goal + spread(elements, scale)
        a, reduced = standard(elements, scale, bits)
        start = from_factor(elements, scale, reduced) if zeros is not None and bits - guard - goal > STEEP else None
        found = spectrum(a, bits, goal, zeros, reduced.slack, start)
        answer = EnclosedEigenvalues(found, reduced, zeros)
        decided = zeros is not None or (answer.off[answer.zero] <= -goal - ZERO).all()
        if decided and (answer.errors() <= -goal).all():
            break
    return answer


def from_factor(elements: Any, scale: Scaling, reduced: "StandardForm") -> np.ndarray | None:
    """Approximate eigenvectors of A = XᵀX from X = √k̂ ∇s L⁻ᵀ, which holds twice the digits of A; or None."""
    from vibcli.analyses.modal.undamped_large import scaled_rows

    if reduced.massless:
        return None
    rows = scaled_rows(elements.springs, scale.coordinates, scale.stiffness, elements.n)
    lower = fx.floats(reduced.lower, reduced.bits)
    x = rows / lower if lower.ndim == 1 else np.linalg.solve(lower, rows.T).T
    return np.linalg.svd(x)[2].T


def spread(elements: Any, scale: Scaling) -> int:
    """Bits between the largest and the smallest stiffness or inertia that a scaled coordinate feels."""
    p, sizes = scale.coordinates, [0]
    for terms, base in ((elements.springs, scale.stiffness), (elements.inertias, scale.mass)):
        for weight, row in terms:
            felt = [exponent(x) + p[i] for i, x in row.items() if x]
            if weight and felt:
                sizes.append(base - exponent(weight) - 2 * max(felt))
    return max(sizes)


class StandardForm:
    """What takes the vectors of A back to the coordinates; `slack`: A is known to 2^(slack − bits)."""

    __slots__ = ("bits", "follow", "lower", "massive", "massless", "n", "slack")

    def __init__(self, n: int, massive: Sequence[int], massless: Sequence[int], lower: np.ndarray,
                 follow: np.ndarray | None, bits: int, growth: float) -> None:
        self.n, self.massive, self.massless, self.bits = n, massive, massless, bits
        self.lower, self.follow = lower, follow
        self.slack = 4 + 2 * math.log2(n) + growth

    def full(self, vectors: np.ndarray) -> np.ndarray:
        """Shapes of all coordinates, M̂-normalised."""
        if self.lower.ndim == 1:
            a: np.ndarray = (vectors << self.bits) // self.lower[:, None]
        else:
            a = fx.backward(self.lower, vectors, self.bits)
        if not self.massless:
            return a
        out = np.zeros((self.n, a.shape[1]), object)
        out[self.massive] = a
        out[self.massless] = -fx.product(self.follow, a, self.bits)
        return out


def standard(elements: Any, scale: Scaling, bits: int) -> tuple[np.ndarray, StandardForm]:
    """A = L⁻¹ K̂ L⁻ᵀ with the massless coordinates condensed, and the way back."""
    n, p = elements.n, scale.coordinates
    m = fx.assembled(n, elements.inertias, elements.M, p, scale.mass, bits)
    k = fx.assembled(n, elements.springs, elements.K, p, scale.stiffness, bits)
    massless = sorted(elements.massless)
    massive = [i for i in range(n) if i not in set(massless)]
    growth, follow = 0.0, None
    if massless:
        k, follow, growth = condensed(k, massive, massless, bits)
        m = m[np.ix_(massive, massive)]
    a, lower, more = reduced_by_mass(m, k, massive, bits)
    return a, StandardForm(n, massive, massless, lower, follow, bits, growth + more)


def reduced_by_mass(m: np.ndarray, k: np.ndarray, massive: Sequence[int],
                    bits: int) -> tuple[np.ndarray, np.ndarray, float]:
    """A = L⁻¹ k L⁻ᵀ; L, or its diagonal alone where m is diagonal; by how many bits rounding grew."""
    n = len(m)
    if fx.is_diagonal(m):
        lower = np.array([math.isqrt(x << bits) if x > 0 else 0 for x in m.diagonal().tolist()], object)
        if not all(lower):
            raise unmoved(massive[int(np.flatnonzero(lower == 0)[0])])
        a = (((k << bits) // lower[:, None]) << bits) // lower
        return a, lower, 4.0 * max(1, 1 + bits - min(lower).bit_length())
    lower, stopped = fx.cholesky(m, bits)
    if lower is None:
        raise unmoved(massive[stopped])
    half = fx.forward(lower, k, bits)
    a = fx.forward(lower, half.T.copy(), bits)
    return (a + a.T) >> 1, lower, growth_bits(fx.forward(lower, fx.identity(n, bits), bits), bits)


def condensed(k: np.ndarray, massive: Sequence[int], massless: Sequence[int], bits: int,
              names: Sequence[int] | None = None, symmetric: bool = True) -> tuple[np.ndarray, np.ndarray, float]:
    """The stiffness left to the massive coordinates when the massless ones follow: z = −follow a."""
    inverse, growth = inverted(k[np.ix_(massless, massless)], names or massless, bits)
    follow = fx.product(inverse, k[np.ix_(massless, massive)], bits)
    left = k[np.ix_(massive, massive)] - fx.product(k[np.ix_(massive, massless)], follow, bits)
    return (left + left.T) >> 1 if symmetric else left, follow, growth


def inverted(a: np.ndarray, names: Sequence[int], bits: int) -> tuple[np.ndarray, float]:
    """The inverse of a fixed-point matrix by Gauss–Jordan elimination, and by how many bits rounding may grow."""
    n = len(a)
    work = np.concatenate([a, fx.identity(n, bits)], axis=1)
    left, order = list(range(n)), []
    for j in range(n):
        i = max(left, key=lambda r: abs(work[r, j]))
        if abs(work[i, j]) <= 1 << (bits // 3):
            raise mechanism(names[j])
        left.remove(i)
        order.append(i)
        pivot = (work[i] << bits) // work[i, j]
        for r in range(n):
            if r != i and work[r, j]:
                work[r] = work[r] - (work[r, j] * pivot >> bits)
        work[i] = pivot
    out = work[order, n:]
    return out, growth_bits(out, bits)


def growth_bits(inverse: np.ndarray, bits: int) -> float:
    """log2 of (1 + n² max|inverse|)⁴, by which rounding may grow in a product with the inverse on both sides."""
    if not len(inverse):
        return 4.0
    largest = max(abs(x) for x in inverse.ravel().tolist())
    return float(4.0 * max(1.0, 1 + largest.bit_length() - bits + 2 * math.log2(len(inverse))))


def sensitivity(elements: Any, scale: Scaling, shapes: np.ndarray, sizes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """First-order change of each λ̂ per relative rounding of every weight and component; of the sums in K."""
    p, rows, sums = scale.coordinates, np.zeros(shapes.shape[1]), np.zeros(shapes.shape[1])
    kinds = (elements.springs, scale.stiffness, 1.0), (elements.inertias, scale.mass, sizes)
    for terms, base, factor in kinds:
        for weight, row in terms:
            value, size = 0.0, 0.0
            for i, x in row.items():
                part = fx.times_power(x, p[i]) * shapes[i]
                value, size = value + part, size + np.abs(part)
            rows += factor * abs(fx.times_power(weight, -base)) * np.abs(value) * (3 * size)
    for (i, j), x in (elements.K_size or {at: abs(x) for at, x in elements.K.items()}).items():
        felt = np.abs(fx.times_power(x, p[i] + p[j] - scale.stiffness) * shapes[i] * shapes[j])
        rows += felt
        if elements.K_size:
            sums += felt
    for (i, j), x in elements.M.items():
        rows += sizes * np.abs(fx.times_power(x, p[i] + p[j] - scale.mass) * shapes[i] * shapes[j])
    return rows, sums
