"""Damping in the modes without damping: λ² + λ C_m + diag(ω̂²) in fixed point, and its eigenvalues.

Modes that no damping couples are quadratic equations of their own; the others are solved together from the
first-order form v' = −C v − Ω u, u' = Ω v with u = Ω q. A rigid mode has no u: one zero each leaves exactly.
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.factored_system import summed
from vibcli.numerics import fixed_point as fx
from vibcli.numerics.components import clusters, components
from vibcli.numerics.general_eigenvalues import Root, eigenvalues
from vibcli.numerics.symmetric_eigenvalues import spectrum

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.analyses.modal.scaling import Scaling
    from vibcli.analyses.modal.undamped_certified import EnclosedEigenvalues


class Eigenvalue(NamedTuple):
    """λ = re + i im in fixed point, |exact − λ| <= 2^radius, of a conjugate pair that with im > 0.

    x: the vector in the columns of `basis`. left: row y with y (δM λ² + δC λ + δK) x the change of −λ.
    mode: the undamped mode that it belongs to alone, or None; excess: then c² − 4 ω̂² in fixed point.
    """

    re: int
    im: int
    radius: float
    x: np.ndarray
    left: np.ndarray
    mode: int | None = None
    excess: int | None = None


class ModalDamping:
    """Modes (columns of basis), values ω̂² (0 if rigid) and damping c in their coordinates, in fixed point.

    decided: whether the structure tells which rigid motions are damped. same, coupled: bits to which frequencies
    have to agree to count as repeated, couplings to vanish; deep: bits beyond which a real part is zero.
    """

    __slots__ = ("basis", "bits", "c", "coupled", "decided", "deep", "same", "values")

    def __init__(self, answer: "EnclosedEigenvalues", elements: Any, scale: "Scaling", untouched: int | None, goal: int,
                 deep: int) -> None:
        self.bits, self.values, self.basis = answer.bits, answer.values.copy(), answer.shapes
        self.values[answer.zero] = 0
        self.same, self.coupled, self.deep = goal - 60, goal - 30, deep
        n, p = elements.n, scale.coordinates
        c = fx.assembled(n, elements.dampers, turning(elements), p, scale.damping, self.bits)
        self.c = fx.product(self.basis.T, fx.product(c, self.basis, self.bits), self.bits)
        self._align()
        self.decided = untouched is not None
        self._clear(untouched or 0)

    def _align(self) -> None:
        """Turns the basis of each repeated frequency to the axes of the damping in it."""
        size = np.abs(fx.floats(self.values, self.bits))
        gap = np.abs(fx.floats(np.subtract.outer(self.values, self.values), self.bits))
        same = gap <= np.ldexp(np.maximum.outer(size, size), -self.same)
        np.fill_diagonal(same, False)
        small = max(abs(x) for x in self.c.ravel().tolist()) >> self.coupled
        for part in clusters(same):
            block = self.c[np.ix_(part, part)]
            block = (block + block.T) >> 1
            if (np.abs(block - np.diag(block.diagonal())) > small).any():
                turn = spectrum(block, self.bits, self.same, slack=small.bit_length()).vectors
                self.basis[:, part] = fx.product(self.basis[:, part], turn, self.bits)
                self.c[:, part] = fx.product(self.c[:, part], turn, self.bits)
                self.c[part, :] = fx.product(turn.T, self.c[part, :], self.bits)

    def _clear(self, untouched: int) -> None:
        """Couplings that vanish but for the working precision become zero, as do `untouched` rigid motions."""
        largest = max(abs(x) for x in self.c.ravel().tolist())
        self.c[np.abs(self.c) <= (largest >> self.coupled)] = 0
        rigid = np.flatnonzero(self.values == 0).tolist()
        rigid = sorted(rigid, key=abs(self.c.diagonal()).tolist().__getitem__)[:untouched]
        self.c[rigid, :] = 0
        self.c[:, rigid] = 0

    def groups(self) -> list[list[int]]:
        """The modes coupled by damping, as lists of indices; a mode on its own is a list of one."""
        linked = ((self.c != 0) | (self.c.T != 0)).astype(bool)
        np.fill_diagonal(linked, False)
        return sorted(components(linked), key=lambda part: len(part) == 1)

    def eigenvalues(self, wanted: int) -> list[Eigenvalue]:
        """Every eigenvalue, to `wanted` bits of its real part unless that is negligible."""
        out = []
        for part in self.groups():
            out += self._alone(part[0]) if len(part) == 1 else self._coupled(part, wanted)
        return out

    def _unit(self, i: int, value: complex = 1.0) -> np.ndarray:
        x = np.zeros(len(self.values), complex)
        x[i] = value
        return x

    def _alone(self, i: int) -> list[Eigenvalue]:
        """λ² + c λ + ω̂² = 0; the smaller real root as ω̂²/larger (Press et al. 2007, eq. 5.6.4)."""
        bits, c, k = self.bits, int(self.c[i, i]), int(self.values[i])
        excess = c * c - (k << (bits + 2))
        if abs(excess) <= (abs(k) << bits) >> (self.coupled - 10):
            excess = 0
        root = math.isqrt(abs(excess))
        if excess < 0:
            pairs = [(-c >> 1, root >> 1)]
        elif not k:
            pairs = [(0, 0), (-c, 0)]
        else:
            far = (-c - root if c >= 0 else -c + root) >> 1
            pairs = [((k << bits) // far, 0), (far, 0)]
        out = []
        for re, im in pairs:
            slope = complex(fx.to_float(2 * re + c, bits), fx.to_float(2 * im, bits))
            size = fx.to_float(math.isqrt(re * re + im * im), bits)
            radius = np.logaddexp2(math.log2(size) + 20 - self.coupled, 20 - bits) if size else -math.inf
            left = self._unit(i, 1 / slope if slope else np.inf)
            out.append(Eigenvalue(re, im, radius, self._unit(i), left, i, excess))
        return out

    def _coupled(self, part: list[int], wanted: int) -> list[Eigenvalue]:
        """The eigenvalues of modes that damping couples."""
        system = Coupled(self, part)
        top, bits = math.log2(np.abs(system.matrix).max()), self.bits

        def enough(root: Root) -> bool:
            return known(root, bits, wanted, self.deep, top - self.coupled + 50)

        found = eigenvalues(system.apply, system.matrix, bits, enough, top + 4 - self.coupled)
        marked = vanishing(found, 0 if self.decided else None, bits, top)
        zero = [self._unit(i) for i in part if not self.values[i]]
        rigid = [Eigenvalue(0, 0, -math.inf, x, x) for x in zero]
        return rigid + [self._full(part, system, root, zero) for root, zero in marked]

    def _full(self, part: list[int], system: "Coupled", root: Root, zero: bool) -> Eigenvalue:
        """An Eigenvalue of all modes from one of the first-order form; `zero`: it vanishes by structure."""
        k = len(part)
        value = complex(fx.to_float(root.re, self.bits), fx.to_float(root.im, self.bits))
        x, left = np.zeros(len(self.values), complex), np.zeros(len(self.values), complex)
        rate, top = root.right[:k], np.abs(root.right[:k]).max()
        if zero or not value:
            x[part] = rate / top
            return Eigenvalue(0, 0, -math.inf, x / np.linalg.norm(x), left)
        x[part] = rate / top * (abs(value) / value) if top else system.place(root.right[k:])
        left[part] = root.left[:k] * (top or abs(value))
        size = np.linalg.norm(x)
        return Eigenvalue(root.re, root.im, root.radius, x / size, left * size)


class Coupled:
    """v' = −C v − Ω u, u' = Ω v of some modes; for an unstable mode v' = −C v + Ω u."""

    __slots__ = ("bits", "c", "elastic", "matrix", "omega", "pull", "rigid")

    def __init__(self, modal: ModalDamping, part: Sequence[int]) -> None:
        self.bits, self.c, values = modal.bits, modal.c[np.ix_(part, part)], modal.values[part]
        self.elastic, self.rigid = np.flatnonzero(values != 0), np.flatnonzero(values == 0)
        roots = [math.isqrt(abs(int(values[i])) << self.bits) for i in self.elastic]
        self.omega = np.array(roots, object)
        signed = [w if values[i] > 0 else -w for w, i in zip(roots, self.elastic, strict=True)]
        self.pull = np.array(signed, object)
        k = len(part)
        self.matrix = np.zeros((k + len(roots), k + len(roots)))
        self.matrix[:k, :k] = -fx.floats(self.c, self.bits)
        if roots:
            at = k + np.arange(len(roots))
            self.matrix[at, self.elastic] = fx.floats(self.omega, self.bits)
            self.matrix[self.elastic, at] = -fx.floats(self.pull, self.bits)

    def apply(self, y: np.ndarray) -> np.ndarray:
        """The matrix times fixed-point columns."""
        k, bits = len(self.c), self.bits
        v, u = y[:k], y[k:]
        out = np.concatenate([-fx.product(self.c, v, bits), self.omega[:, None] * v[self.elastic] >> bits])
        out[self.elastic] -= self.pull[:, None] * u >> bits
        return out

    def place(self, u: np.ndarray) -> np.ndarray:
        """q from u = Ω q, for a motion too slow for its velocities to count."""
        q = np.zeros(len(self.c), complex)
        q[self.elastic] = u / fx.floats(self.omega, self.bits)
        return q


def known(root: Root, bits: int, wanted: int, deep: int, floor: float) -> bool:
    """Whether Re λ is known to `wanted` bits, or λ to `deep` bits, or both are below 2^floor."""
    size = fx.log2(root.re * root.re + root.im * root.im, 2 * bits) / 2
    radius = root.radius
    found: bool = radius <= max(fx.log2(root.re, bits) - wanted, size - deep) or max(size, radius) <= floor
    return found


def vanishing(found: Sequence[Root], zeros: int | None, bits: int, top: float) -> list[tuple[Root, bool]]:
    """(root, whether it is zero), twice for a zero found as a conjugate pair.

    zeros: how many vanish by structure; where that is None, those which nothing but the working precision keeps
    from zero, 2^top being the size of the matrix.
    """
    out = []
    for root in sorted(found, key=lambda root: root.re * root.re + root.im * root.im):
        if zeros is None:
            size = fx.log2(root.re * root.re + root.im * root.im, 2 * bits) / 2
            zero = size <= max(root.radius + 1, top - 0.4 * bits) and root.radius <= top - max(60, bits / 12)
        else:
            zero = zeros > 0
            zeros -= 2 if root.im else 1
        out += [(root, zero)] * (2 if zero and root.im else 1)
    return out


def turning(elements: Any) -> "dict[tuple[int, int], float | Fraction]":
    """C + G as one dict."""
    return summed(elements.C, elements.G)
