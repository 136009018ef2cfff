"""Free vibration under forces that follow the motion: M q̈ + K q = 0 with a K that is not symmetric.

With M = I an eigenvalue μ of K gives λ = ±√−μ. A real one is ω², or below zero the square of a growth rate
(divergence); of a pair μ, μ̄ come the four λ = ±a ± i b of flutter (Bolotin 1963, ch. 2). What lies alone next to the
real axis lies on it, for μ̄ is an eigenvalue too: the real part of its λ is zero exactly.
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.damped_in_modal_coordinates import Eigenvalue
from vibcli.analyses.modal.massless_coordinates import MassiveSystem
from vibcli.analyses.modal.rounding import last_bit, magnitudes
from vibcli.numerics import fixed_point as fx
from vibcli.numerics.general_eigenvalues import block_diagonal

if TYPE_CHECKING:
    from vibcli.analyses.modal.scaling import Scaling
    from vibcli.numerics.general_eigenvalues import Root

NEARLY_ONE = 0.9        # log2 |√a + √b|/|√a| for b next to a
COARSE, ALIKE = 20, 1e-6


class Follower(MassiveSystem):
    """The first of ±λ, that with Re λ >= 0 and Im λ >= 0, for each eigenvalue μ of K, or each pair of them."""

    __slots__ = ("form", "norms", "top")

    def eigenvalues(self, wanted: int) -> list[Eigenvalue]:
        """Every eigenvalue, the rate of a growth to `wanted` bits unless that is negligible."""
        bits, a = self.bits, self.k
        matrix = fx.floats(a, bits)
        if not matrix.any():
            self.form = None
            return [_resting(x) for x in np.eye(len(a), dtype=complex)]
        self.top = math.log2(np.abs(matrix).max())
        noise = self.top - 2 * self.coupled

        def enough(root: "Root") -> bool:
            size = fx.magnitude(math.isqrt(root.re * root.re + root.im * root.im), bits)
            rate = fx.magnitude(root.im, bits) - wanted if root.im else -math.inf
            found: bool = root.radius <= max(size - self.deep, rate, noise + 60)
            return found

        self.form, self.norms = block_diagonal(lambda y: fx.product(a, y, bits), matrix, bits, enough, noise)
        return self._all(self.norms)

    def rounded(self, data: Any, scale: "Scaling", unit: float) -> list[Eigenvalue]:
        """The eigenvalues with bounds that hold for every rounding of the data, which adds to V⁻¹ K V."""
        if self.form is None:
            return self.eigenvalues(0)
        form, norms = self.form, []
        m, _, k = magnitudes(self, data, scale, unit)
        t, v, inverse = np.abs(fx.floats(form.t, self.bits)), np.abs(form.vf), np.abs(form.inverse)
        for part, norm in zip(form.blocks, self.norms, strict=True):
            own = inverse[part] @ (k @ v[:, part] + m @ v[:, part] @ t[np.ix_(part, part)])
            size = 2 * np.linalg.norm(own)
            norms.append(float(np.logaddexp2(norm, math.log2(size) + last_bit(unit))) if size else norm)
        return self._all(norms)

    def _all(self, norms: list[float]) -> list[Eigenvalue]:
        found = [value for root in self.form.all_roots(norms) for value in self._of(root)]
        resting = [i for i, d in enumerate(found) if not d.re and not d.im]
        shapes = _chained(fx.floats(self.k, self.bits), [found[i].x for i in resting])
        for i, x in zip(resting, shapes, strict=True):
            found[i] = found[i]._replace(x=x)
        return found

    def _of(self, root: "Root") -> list[Eigenvalue]:
        """The λ of one μ: two for a pair that nothing tells from two real ones."""
        bits, re, im = self.bits, root.re, root.im
        square = math.isqrt(re * re + im * im)
        size, x = fx.magnitude(square, bits), root.right.conj() / np.linalg.norm(root.right)
        if _vanishes(size, root.radius, self.top):
            return [_resting(part) for part in _parts(x, im)]
        if im and fx.magnitude(im, bits) > root.radius:
            large = math.isqrt((square + abs(re)) << (bits - 1))
            small = (im << bits) // (2 * large)
            found = [(small, large, x) if re > 0 else (large, small, x)]
            unsure = root.radius
        else:
            rate = math.isqrt(abs(re) << bits)
            found = [(0, rate, part) if re > 0 else (rate, 0, part) for part in _parts(x, im)]
            unsure = root.radius + bool(im)
        radius = unsure - size / 2 - (NEARLY_ONE if unsure <= size - 4 else 0)
        radius = float(np.logaddexp2(radius, 2 - bits))
        return [Eigenvalue(growth, swing, radius, shape, root.left) for growth, swing, shape in found]


def _parts(x: np.ndarray, im: int) -> list[np.ndarray]:
    """A real vector; of a pair two real ones, which are eigenvectors where its eigenvalues coincide."""
    if not im:
        return [x.real.astype(complex)]
    turned = x * np.exp(-0.5j * np.angle(x @ x))
    parts = turned.real, turned.imag
    sizes = [np.linalg.norm(part) for part in parts]
    return [(part / size if size > 1e-6 else parts[0] / sizes[0]).astype(complex)
            for part, size in zip(parts, sizes, strict=True)]


def _chained(matrix: np.ndarray, shapes: list[Any]) -> list[Any]:
    """The shapes of motions at rest; of those that coincide those of a chain, K x₁ = 0, K x₂ ~ x₁, …"""
    if not shapes or np.linalg.svd(np.array(shapes), compute_uv=False)[-1] >= ALIKE:
        return shapes
    inner = np.linalg.svd(np.linalg.matrix_power(matrix, len(shapes)))[2][-len(shapes):].T
    chain = np.linalg.svd(inner.T @ matrix @ inner)[2][::-1]
    return list((inner @ chain.T).T.astype(complex))


def rested(found: Sequence[Eigenvalue], bits: int) -> list[Eigenvalue]:
    """The eigenvalues, with those at zero that the rounding of the data alone keeps from it."""
    sizes = [fx.magnitude(math.isqrt(d.re * d.re + d.im * d.im), bits) for d in found]
    top, out = max(sizes), []
    for d, size in zip(found, sizes, strict=True):
        zero = (d.re or d.im) and _vanishes(size, d.radius, top)
        out += [_resting(d.x)] * (2 if d.im else 1) if zero else [d]
    return out


def _vanishes(size: float, radius: float, top: float) -> bool:
    """Whether nothing tells |μ| = 2^size from zero, and 2^radius is little beside the largest, 2^top."""
    return size - 1 <= radius <= top - COARSE


def _resting(x: "np.ndarray | None") -> Eigenvalue:
    return Eigenvalue(0, 0, -math.inf, x, x)
