"""Damped vibration with coordinates that no inertia moves but dampers do, or with a K that is not symmetric.

    M a'' + C_aa a' + C_az z' + K_aa a + K_az z = 0        C_za a' + C_zz z' + K_za a + K_zz z = 0

Massless directions without a damper follow statically and are condensed; then C_zz is regular and z' can be
eliminated: first order in (a', a, z), 2 n_a + n_z eigenvalues, none of them infinite.

Where K is not symmetric the massless directions do not follow from the left as they do from the right, so that the
equations are taken along other columns than the coordinates.
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.damped_in_modal_coordinates import Eigenvalue, known, turning, vanishing
from vibcli.analyses.modal.method import dragged
from vibcli.analyses.modal.undamped_certified import condensed, inverted, reduced_by_mass, spread
from vibcli.base.errors import PhysicsError
from vibcli.numerics import fixed_point as fx
from vibcli.numerics.general_eigenvalues import eigenvalues
from vibcli.numerics.symmetric_eigenvalues import spectrum

if TYPE_CHECKING:
    from vibcli.analyses.modal.scaling import Scaling
    from vibcli.numerics.general_eigenvalues import Root

LOOSE = 1e-13       # of the largest stiffness: what springs do not hold


def only_damped(elements: Any) -> bool:
    """Is there no system without the dampers: has nothing inertia, or do dampers alone hold what has none?"""
    if not dragged(elements):
        return False
    if len(elements.massless) == elements.n:
        return True
    bare = sorted(elements.massless)
    K = elements.stiffness_array()[np.ix_(bare, bare)]
    unit = 1 / np.sqrt(np.maximum(np.abs(K).max(axis=1), np.finfo(float).tiny))
    return bool(np.linalg.svd(unit[:, None] * K * unit)[1][-1] <= LOOSE)


class MassiveSystem:
    """Fixed-point C, K of the massive coordinates and the dragged directions in which C_zz is regular.

    basis: columns that give all coordinates from those; left: columns along which the equations are taken; massive:
    how many have inertia, scaled to M = I.
    """

    __slots__ = ("basis", "bits", "c", "coupled", "deep", "k", "left", "massive", "release", "symmetric", "zeros")

    def __init__(self, elements: Any, scale: "Scaling", zeros: int | None, goal: int, deep: int) -> None:
        n, p = elements.n, scale.coordinates
        self.bits = bits = 2 * goal + spread(elements, scale)
        self.coupled, self.deep, self.zeros = goal - 30, deep, zeros
        self.symmetric = not elements.circulatory
        m = fx.assembled(n, elements.inertias, elements.M, p, scale.mass, bits)
        c = fx.assembled(n, elements.dampers, turning(elements), p, scale.damping, bits)
        k = fx.assembled(n, elements.springs, elements.K, p, scale.stiffness, bits)
        bare, moved = sorted(elements.massless), dragged(elements)
        still = [i for i in bare if i not in moved]
        heavy = [i for i in range(n) if i not in bare]
        turn, loose = _loose(c[np.ix_(moved, moved)], bits)
        order = heavy + moved
        basis = np.zeros((n, len(order)), object)
        basis[order, range(len(order))] = 1 << bits
        z = range(len(heavy), len(order))
        basis[np.ix_(moved, z)] = turn
        kept = [j for j in range(len(order)) if j - len(heavy) not in loose]
        _check_undamped(fx.product(basis.T, fx.product(c, basis, bits), bits), kept, bits)
        left, basis, k = self._condense(basis, k, kept, still, bits)
        c = fx.product(left.T, fx.product(c, basis, bits), bits)
        self._scale(left, basis, m, c, k, heavy)

    def _condense(self, basis: np.ndarray, k: np.ndarray, kept: list[int], still: list[int],
                  bits: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Lets the undamped massless directions follow."""
        gone = [j for j in range(basis.shape[1]) if j not in kept]
        free = np.zeros((len(basis), len(still)), object)
        free[still, range(len(still))] = 1 << bits
        whole = np.concatenate([basis[:, kept], basis[:, gone], free], axis=1)
        k = fx.product(whole.T, fx.product(k, whole, bits), bits)
        if whole.shape[1] == len(kept):
            return whole, whole, k
        a, z = list(range(len(kept))), list(range(len(kept), whole.shape[1]))
        names = [int(np.flatnonzero(whole[:, j] != 0)[0]) for j in z]
        lead = None if self.symmetric else condensed(k.T, a, z, bits, names)[1]
        k, follow, _ = condensed(k, a, z, bits, names, self.symmetric)
        basis = whole[:, a] - fx.product(whole[:, z], follow, bits)
        left = basis if self.symmetric else whole[:, a] - fx.product(whole[:, z], lead, bits)
        return left, basis, k

    def _scale(self, left: np.ndarray, basis: np.ndarray, m: np.ndarray, c: np.ndarray, k: np.ndarray,
               heavy: list[int]) -> None:
        """Takes the massive coordinates to M = I."""
        bits, h = self.bits, len(heavy)
        if h:
            _, lower, _ = reduced_by_mass(m[np.ix_(heavy, heavy)], k[:h, :h], heavy, bits)
            back = fx.identity(h, bits)
            back = (back << bits) // lower[:, None] if lower.ndim == 1 else fx.backward(lower, back, bits)
            for columns in (basis,) if left is basis else (basis, left):
                columns[:, :h] = fx.product(columns[:, :h], back, bits)
            for matrix in (c, k):
                matrix[:, :h] = fx.product(matrix[:, :h], back, bits)
                matrix[:h, :] = fx.product(back.T, matrix[:h, :], bits)
        self.left, self.basis, self.c, self.k, self.massive = left, basis, c, k, h
        self.release, _ = inverted(c[h:, h:], list(range(len(c) - h)), bits)

    def eigenvalues(self, wanted: int) -> list[Eigenvalue]:
        """Every eigenvalue, to `wanted` bits of its real part unless that is negligible."""
        bits, h = self.bits, self.massive
        a = self._matrix()
        matrix = fx.floats(a, bits)
        if not matrix.any():
            return [Eigenvalue(0, 0, -math.inf, x, x) for x in np.eye(len(self.c), dtype=complex)]
        top = math.log2(np.abs(matrix).max())

        def enough(root: "Root") -> bool:
            return known(root, bits, wanted, self.deep, top - 2 * self.coupled + 60)

        found = eigenvalues(lambda y: fx.product(a, y, bits), matrix, bits, enough, top - 2 * self.coupled)
        marked = vanishing(found, self.zeros, bits, top)
        moving = [self._full(root, h) for root, zero in marked if not zero]
        return self._still(len(marked) - len(moving)) + moving

    def _still(self, zeros: int) -> list[Any]:
        """Zero eigenvalues, with the motions that no spring resists."""
        _, sigma, v = np.linalg.svd(fx.floats(self.k, self.bits))
        free = max(1, int((sigma <= 1e-12 * max(sigma[0], 1e-300)).sum()))
        motions = [v[-1 - j % free].astype(complex) for j in range(zeros)]
        return [Eigenvalue(0, 0, -math.inf, x, x) for x in motions]

    def _matrix(self) -> np.ndarray:
        """y' = A y for y = (a', a, z)."""
        bits, h, n = self.bits, self.massive, len(self.c)
        out = np.zeros((n + h, n + h), object)
        rates = np.concatenate([self.c[h:, :h], self.k[h:]], axis=1)
        out[2 * h:] = -fx.product(self.release, rates, bits)
        out[:h] = -np.concatenate([self.c[:h, :h], self.k[:h]], axis=1)
        out[:h] -= fx.product(self.c[:h, h:], out[2 * h:], bits)
        out[range(h, 2 * h), range(h)] = 1 << bits
        return out

    def _full(self, root: "Root", h: int) -> Eigenvalue:
        """An Eigenvalue in the columns of the basis."""
        bits = self.bits
        x = root.right[h:]
        size = np.linalg.norm(x[:h]) or np.linalg.norm(x)
        release, drag = fx.floats(self.release, bits), fx.floats(self.c[:h, h:], bits)
        pushed = (root.left[2 * h:] - root.left[:h] @ drag) @ release
        left = np.concatenate([root.left[:h], pushed]) * size
        return Eigenvalue(root.re, root.im, root.radius, x / size, left)


def _check_undamped(c: np.ndarray, kept: Sequence[int], bits: int) -> None:
    """Directions without inertia and damper may only follow: velocities must not drive them, nor they anything."""
    gone = [j for j in range(len(c)) if j not in kept]
    coupling = [abs(x) for j in gone for x in (*c[j].tolist(), *c[:, j].tolist())]
    if coupling and max(coupling) > max(abs(x) for x in c.ravel().tolist()) >> (bits // 3):
        raise PhysicsError("a coordinate without inertia is driven by velocities, and no damper of its own resists it",
                           hint="give it an inertia, or a damper")


def _loose(c: np.ndarray, bits: int) -> tuple[np.ndarray, list[Any]]:
    """Orthonormal directions of the dragged coordinates, and which of them no damper resists after all."""
    if not len(c):
        return c, []
    symmetric = (c + c.T) >> 1
    if (symmetric != c).any():
        raise PhysicsError("the damping of coordinates without inertia is not symmetric",
                           hint="a coordinate that no inertia moves cannot turn or be driven by velocities")
    found = spectrum(symmetric, bits, bits // 4)
    limit = max(abs(x) for x in found.values.tolist()) >> (bits // 3)
    loose = [i for i, x in enumerate(found.values.tolist()) if abs(x) <= limit]
    if not loose:
        return fx.identity(len(c), bits), []
    return found.vectors, loose
