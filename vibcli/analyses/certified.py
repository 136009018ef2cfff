"""The undamped eigenvalues of up to some forty coordinates, enclosed in fixed-point arithmetic.

M̂ = L Lᵀ, A = L⁻¹ K̂ L⁻ᵀ, massless coordinates eliminated exactly first: K_aa − K_az K_zz⁻¹ K_za.
"""

import math

import numpy as np

from vibcli.analyses import fixed as fx
from vibcli.analyses.scaled import exponent, mechanism, unmoved
from vibcli.analyses.symmetric import spectrum

GUARD = 160


class Enclosed:
    """Scaled eigenvalues with their radius, shapes in columns (floats) and data error, all of the pencil K̂, M̂."""

    __slots__ = ("bits", "data", "radius", "shapes", "values", "zero", "zeros")

    def __init__(self, spectrum, shapes, data, zeros):
        self.values, self.bits = spectrum.values, spectrum.bits
        self.radius, self.data, self.shapes, self.zeros = spectrum.radius, data, shapes, zeros
        size = np.abs(fx.floats(self.values, self.bits))
        if zeros is None:
            self.zero = size <= self.radius + self.data
        else:
            self.zero = np.zeros(len(size), bool)
            self.zero[np.argsort(size, kind="stable")[:zeros]] = True

    def errors(self):
        """Relative bound of √|λ̂|."""
        size = np.abs(fx.floats(self.values, self.bits))
        size[self.zero] = np.inf
        return 0.5 * (self.radius + self.data) / np.maximum(size - self.radius - self.data, 0.1 * size)

    def settled(self, goal):
        """Whether every value is known to `goal` and every zero follows from the structure."""
        return (self.zeros is not None or not self.zero.any()) and bool((self.errors() <= goal).all())

    def in_floats(self):
        """values, shapes, errors with those of the last rounding, and the flags of exact zeros."""
        return (fx.floats(self.values, self.bits), self.shapes, self.errors() + 2.0 ** -52, self.zero)


def enclosed(elements, scale, zeros, unit, goal=60, guard=GUARD):
    """Encloses the eigenvalues; `unit`: the relative rounding of the numbers in `elements`, 0 if they are exact."""
    bits = guard + goal + spread(elements, scale)
    a, reduced = standard(elements, scale, bits)
    found = spectrum(a, bits, goal, zeros or 0, reduced.error)
    shapes = fx.floats(reduced.full(found.vectors), bits)
    return Enclosed(found, shapes, data_error(elements, scale, shapes, found, unit), zeros)


def spread(elements, scale):
    """Bits between the largest and the smallest stiffness or inertia that a scaled coordinate feels."""
    p, sizes = scale.coordinates, [0]
    for terms, base in ((elements.springs, scale.stiffness), (elements.inertias, scale.mass)):
        for weight, row in terms:
            felt = [exponent(x) + p[i] for i, x in row.items() if x]
            if weight and felt:
                sizes.append(base - exponent(weight) - 2 * max(felt))
    return max(sizes)


class Reduced:
    """What takes the vectors of A back to the coordinates."""

    __slots__ = ("bits", "error", "follow", "lower", "massive", "massless", "n")

    def __init__(self, n, massive, massless, lower, follow, bits):
        self.n, self.massive, self.massless, self.bits = n, massive, massless, bits
        self.lower, self.follow = lower, follow
        self.error = 64.0 * n * n * 2.0 ** -bits

    def full(self, vectors):
        """Shapes of all coordinates, M̂-normalised."""
        if self.lower.ndim == 1:
            a = (vectors << self.bits) // self.lower[:, None]
        else:
            a = fx.backward(self.lower, vectors, self.bits)
        if not self.massless:
            return a
        out = fx.zeros((self.n, a.shape[1]))
        out[self.massive] = a
        out[self.massless] = -fx.product(self.follow, a, self.bits)
        return out


def standard(elements, scale, bits):
    """A = L⁻¹ K̂ L⁻ᵀ with the massless coordinates condensed, and the way back."""
    n, p = elements.n, scale.coordinates
    m = fx.assembled(n, elements.inertias, elements.M, p, scale.mass, bits)
    k = fx.assembled(n, elements.springs, elements.K, p, scale.stiffness, bits)
    massless = sorted(elements.massless)
    massive = [i for i in range(n) if i not in set(massless)]
    growth, follow = 1.0, None
    if massless:
        k, follow, growth = condensed(k, massive, massless, bits)
        m = m[np.ix_(massive, massive)]
    a, lower, more = reduced_by_mass(m, k, massive, bits)
    back = Reduced(n, massive, massless, lower, follow, bits)
    back.error *= growth * more
    return a, back


def reduced_by_mass(m, k, massive, bits):
    """A = L⁻¹ k L⁻ᵀ, L (its diagonal alone where m is diagonal) and how much the rounding of m and k grew."""
    n = len(m)
    if fx.is_diagonal(m):
        lower = np.array([math.isqrt(x << bits) if x > 0 else 0 for x in m.diagonal().tolist()], object)
        if not all(lower):
            raise unmoved(massive[int(np.flatnonzero(lower == 0)[0])])
        a = (((k << bits) // lower[:, None]) << bits) // lower
        return a, lower, (1.0 + 2.0 ** (bits - min(lower).bit_length())) ** 4
    lower, stopped = fx.cholesky(m, bits)
    if lower is None:
        raise unmoved(massive[stopped])
    half = fx.forward(lower, k, bits)
    a = fx.forward(lower, half.T.copy(), bits)
    inverse = fx.floats(fx.forward(lower, fx.identity(n, bits), bits), bits)
    return (a + a.T) >> 1, lower, (1.0 + np.linalg.norm(inverse) ** 2) ** 2


def condensed(k, massive, massless, bits):
    """The stiffness left to the massive coordinates when the massless ones follow: z = −follow a."""
    free, tied = np.ix_(massive, massive), np.ix_(massless, massless)
    inverse, growth = inverted(k[tied], massless, bits)
    follow = fx.product(inverse, k[np.ix_(massless, massive)], bits)
    left = k[free] - fx.product(k[np.ix_(massive, massless)], follow, bits)
    return (left + left.T) >> 1, follow, growth


def inverted(a, names, bits):
    """The inverse of a symmetric fixed-point matrix by Gauss–Jordan elimination with pivots on the diagonal first."""
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
    return out, (1.0 + np.abs(fx.floats(out, bits)).sum()) ** 4


def data_error(elements, scale, shapes, found, unit):
    """First-order effect on each λ̂ of the rounding in the data.

    Every weight and row component carries `unit`; K carries K_size × max(unit, 2⁻⁵³), the rounding of its sums.
    """
    n, p = elements.n, scale.coordinates
    out = np.zeros(shapes.shape[1])
    alpha = np.abs(fx.floats(found.values, found.bits))
    for terms, base, factor in ((elements.springs, scale.stiffness, 1.0), (elements.inertias, scale.mass, alpha)):
        if unit:
            for weight, row in terms:
                m, e = fx.mantissa(weight)
                value = np.zeros(shapes.shape[1])
                size = np.zeros(shapes.shape[1])
                for i, x in row.items():
                    mx, ex = fx.mantissa(x)
                    part = fx.to_float(mx, -(ex + p[i])) * shapes[i]
                    value += part
                    size += np.abs(part)
                out += unit * factor * fx.to_float(abs(m), base - e) * np.abs(value) * (3 * size)
    if elements.K_size:
        rounding = unit if unit else 2.0 ** -53
        for (i, j), x in elements.K_size.items():
            mx, ex = fx.mantissa(x)
            size = fx.to_float(abs(mx), scale.stiffness - ex - p[i] - p[j])
            out += rounding * size * np.abs(shapes[i] * shapes[j])
    del n
    return out
