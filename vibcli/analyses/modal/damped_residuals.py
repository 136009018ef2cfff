"""Damped modes of floats, certified and bettered by their residuals in twice the digits.

With the natural modes Φ, Ω and q = Φ a the state (ȧ, Ω a) of a damped mode (λ, x = Φ a) leaves
r = λ²Mx + λCx + Kx behind in its upper half alone. With all of them as columns of Z, Y ≈ (BZ)⁻¹, B = diag(ΦᵀMΦ, I), the
eigenvalues are those of Λ − (YBZ)⁻¹ Y [Φᵀr; 0], and Gershgorin's discs bound what stands beside its diagonal (Miyajima
2012). r alone needs more digits than floats have. Of rigid modes Ω is SLOW of the least other one; they rest at (0, Ωa)
and, where nothing damps them, slide at (a, 0), which leaves Ca and Ωa behind: both are zero by structure.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.damped_in_modal_coordinates import turning
from vibcli.analyses.modal.undamped_large import UNIT, Approximate
from vibcli.analyses.modal.undamped_residuals import SKEW, matrix_of, times
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics import double_double as dd
from vibcli.numerics.double_double import DoubleDouble
from vibcli.numerics.symmetric_eigenvalues import radii

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.analyses.modal.scaling import Scaling
    from vibcli.numerics.split_products import BoundedProduct

    Complex = tuple[DoubleDouble, DoubleDouble]     # (real part, imaginary part)
    Terms = Sequence[tuple[float, dict[int, float]]]
    Entries = Mapping[tuple[int, int], float | Fraction]

PASSES, LARGE = 4, 0.1          # LARGE: of a step between two modes
DATA = 2.0**-51                 # rounding of weights and components
SLOW = 2.0**-20                 # of the least frequency: what stands for that of rigid modes


class DampedApproximate(NamedTuple):
    """λ̂ of all modes, each of a conjugate pair too; their shapes in columns, with xᴴM̂x = 1; bounds of |error of λ̂|."""

    values: np.ndarray
    shapes: np.ndarray
    errors: np.ndarray


def bettered(elements: Any, scale: "Scaling", natural: Approximate, values: np.ndarray,
             shapes: np.ndarray) -> DampedApproximate | None:
    """The damped modes that floats found, with the errors that their residuals and the rounding of the data leave;
    values that are 0, velocities in `shapes`, and one more for each rigid mode, stay. None where a coordinate has no
    inertia, all modes are rigid, or floats are too far from modes."""
    rigid = natural.values == 0
    if elements.massless or rigid.all():
        return None
    sliding = np.concatenate([values == 0, np.zeros(rigid.sum(), bool)])
    values, shapes = np.append(values, np.zeros(rigid.sum())), np.hstack([shapes, natural.shapes[:, rigid]])
    system, best = _System(elements, scale, natural, sliding), None
    for _ in range(PASSES):
        step = system.looked_at(values, shapes)
        if step is None:
            break
        if best is not None and not step.errors.max() < best.errors.max() / 2:
            best = min(best, step, key=lambda one: one.errors.max())
            break
        best, values, shapes = step, step.values, step.shapes
    return None if best is None else system.with_data(best)


class _System:
    __slots__ = ("elements", "loose", "matrices", "omega", "phi", "scale", "sliding")

    def __init__(self, elements: Any, scale: "Scaling", natural: Approximate, sliding: np.ndarray) -> None:
        n, p, omega = elements.n, scale.coordinates, np.sqrt(abs(natural.values))
        self.elements, self.scale, self.phi, self.sliding = elements, scale, natural.shapes, sliding
        self.omega = np.where(omega > 0, omega, SLOW * omega[omega > 0].min())
        self.matrices = [matrix_of(n, terms, entries, p, unit) for terms, entries, unit in self._data()]
        m, _ = times(self.matrices[0], self.phi)
        skew = abs(self.phi.T @ m.hi - np.eye(n)) + n * UNIT * (abs(self.phi).T @ abs(m.hi))
        self.loose = float(skew.sum(axis=1).max())

    def _data(self) -> "tuple[tuple[Terms, Entries, int], ...]":
        """(terms, entries, unit) of M, C + G and K."""
        one, scale = self.elements, self.scale
        return ((one.inertias, one.M, scale.mass), (one.dampers, turning(one), scale.damping),
                (one.springs, one.K, scale.stiffness))

    def looked_at(self, values: np.ndarray, shapes: np.ndarray) -> DampedApproximate | None:
        """Better ones, to first order, and what their values may be off by."""
        residual, unsure, inertial = self._left(values, shapes)
        found = self._inverse(values, inertial)
        if found is None:
            return None
        inverse, loose, size, places = found
        left, pushed, n = inverse[:, :len(self.phi)], self.phi.T @ residual * size, len(self.phi)
        slid = np.where(self.sliding, places, 0.0) * size
        e = inverse[:, n:] @ slid - left @ pushed
        wide = abs(left) @ (abs(self.phi).T @ (unsure + 2 * n * UNIT * abs(residual)) * size) \
            + 4 * n * UNIT * (abs(left) @ abs(pushed) + abs(inverse[:, n:]) @ abs(slid))
        wide += abs(inverse[:, n:]) @ np.broadcast_to(abs(slid).max(axis=0) * self.loose * 2, slid.shape)
        wide += loose / (1 - loose) * (abs(e) + wide).max(axis=0)
        real, still = values.imag == 0, values == 0
        nearest = np.where(real, (values + e.diagonal()).real, values + e.diagonal())
        nearest[still] = 0.0
        off = abs(e) + wide
        np.fill_diagonal(off, wide.diagonal() + UNIT * abs(nearest) + np.where(
            still, abs(e.diagonal()), np.where(real, abs(e.diagonal().imag), 0.0)))
        errors = radii(nearest, abs(nearest[:, None] - nearest[None, :]), off)
        return DampedApproximate(nearest, self._turned(values, shapes, size, e), np.where(still, 0.0, errors))

    def _turned(self, values: np.ndarray, shapes: np.ndarray, size: np.ndarray, e: np.ndarray) -> np.ndarray:
        """Better shapes, to first order."""
        with np.errstate(divide="ignore", invalid="ignore"):
            turn = e / (values[None, :] - values[:, None])
        turn[~(abs(turn) < LARGE)] = 0.0
        turn[self.sliding] = 0.0
        turn[:, values == 0] = 0.0
        scaled, real = shapes * size, values.imag == 0
        better = scaled + scaled @ turn
        better[:, real] = better[:, real].real
        found: np.ndarray = better / np.sqrt(abs((better.conj() * (self.matrices[0].value.hi @ better)).sum(axis=0)))
        return found

    def _left(self, values: np.ndarray, shapes: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """(λ²Mx + λCx + Kx, of what slides Cx, what it may be off by, Mx), a column for each mode."""
        applied = [_complex_times(matrix, shapes) for matrix in self.matrices]
        total, unsure = applied[0]
        for more, off in applied[1:]:
            unsure = unsure * abs(values) + off + 32 * dd.UNIT * (_size(total) * abs(values) + _size(more))
            total = _plus(_by(total, values), more)
        damped, off = applied[1]
        real, imaginary = (DoubleDouble(*(np.where(self.sliding, *both) for both in zip(drag, left, strict=True)))
                           for drag, left in zip(damped, total, strict=True))
        unsure, inertial = np.where(self.sliding, off, unsure), applied[0][0]
        return real.hi + 1j * imaginary.hi, unsure, inertial[0].hi + 1j * inertial[1].hi

    def _inverse(self, values: np.ndarray,
                 inertial: np.ndarray) -> tuple[np.ndarray, float, np.ndarray, np.ndarray] | None:
        """(Y, ‖YBZ − I‖, by which each mode is scaled, Ω a), None where it is too large."""
        n = len(self.phi)
        a = self.phi.T @ inertial
        blurred = n * UNIT * (abs(self.phi).T @ abs(inertial))
        moved = self.loose / (1 - self.loose) * abs(a).max(axis=0) if self.loose < SKEW else np.inf
        rates, places = np.where(self.sliding, 1.0, values), self.omega[:, None] * a
        state = np.concatenate([a * rates, np.where(self.sliding, 0.0, places)])
        size = 1 / np.linalg.norm(state, axis=0)
        state = state * size
        unsure = np.concatenate([blurred * abs(rates) + np.where(self.sliding, moved, 0.0),
                                 np.where(self.sliding, 0.0, self.omega[:, None] * (blurred + moved))]) * size
        try:
            inverse = np.linalg.inv(state)
        except np.linalg.LinAlgError:
            return None
        off = abs(inverse @ state - np.eye(2 * n)) + abs(inverse) @ (unsure + 2 * (n + 2) * UNIT * abs(state))
        loose = float(off.sum(axis=1).max())
        return (inverse, loose, size, places) if loose < SKEW else None

    def with_data(self, found: DampedApproximate) -> DampedApproximate:
        """With the rounding of all data, to first order, in the errors."""
        inertial = _complex_times(self.matrices[0], found.shapes)[0]
        known = self._inverse(found.values, inertial[0].hi + 1j * inertial[1].hi)
        if known is None:
            return found._replace(errors=np.full(len(found.values), np.inf))
        sides = known[0][:, :len(self.phi)] @ self.phi.T, found.shapes * known[2]
        rates, change = abs(found.values), np.zeros(len(found.values))
        for power, (terms, entries, unit) in zip((2, 1, 0), self._data(), strict=True):
            change = change + rates**power * self._felt(terms, entries, unit, *sides)
        return found._replace(errors=np.where(found.values == 0, 0.0, found.errors + DATA * change))

    def _felt(self, terms: "Terms", entries: "Entries", unit: int, left: np.ndarray, right: np.ndarray) -> np.ndarray:
        """Σ |w| |s y| |s x|, each s rounded too, of rows y of `left` and columns x of `right`."""
        n, p = self.elements.n, self.scale.coordinates
        rows, weights = np.zeros((len(terms), n)), np.zeros(len(terms))
        for place, (weight, row) in enumerate(terms):
            weights[place] = np.ldexp(abs(float(weight)), -unit)
            for i, x in row.items():
                rows[place, i] = np.ldexp(float(x), p[i])
        (one, whole), (other, all_of_it) = ((abs(rows @ side), abs(rows) @ abs(side)) for side in (left.T, right))
        found: np.ndarray = (weights[:, None] * (one * other + one * all_of_it + whole * other)).sum(axis=0)
        sums: dict[tuple[int, int], Any] = {at: abs(x) for at, x in entries.items()}
        if unit == self.scale.stiffness:
            sums |= self.elements.K_size or {}
        for (i, j), x in sums.items():
            found = found + np.ldexp(float(x), p[i] + p[j] - unit) * abs(left[:, i]) * abs(right[j])
        return found


def _complex_times(matrix: "BoundedProduct", x: np.ndarray) -> "tuple[Complex, np.ndarray]":
    """((real part, imaginary part) of a matrix times complex columns, what each entry may be off by)."""
    value, error = times(matrix, np.hstack([x.real, x.imag]))
    real, imaginary = (DoubleDouble(hi, lo) for hi, lo in zip(*(np.hsplit(half, 2) for half in value), strict=True))
    return (real, imaginary), np.add(*np.hsplit(error, 2))


def _by(number: "Complex", factor: np.ndarray) -> "Complex":
    """Complex pairs times complex floats."""
    (re, im), (a, b) = number, (factor.real, factor.imag)
    return (dd.added(dd.scaled(re, a), dd.scaled(im, -b)), dd.added(dd.scaled(re, b), dd.scaled(im, a)))


def _plus(number: "Complex", other: "Complex") -> "Complex":
    return dd.added(number[0], other[0]), dd.added(number[1], other[1])


def _size(number: "Complex") -> np.ndarray:
    return abs(number[0].hi) + abs(number[1].hi)
