"""Damped modes of many coordinates in floats, with a bound of the rounding.

In the modes without damping, y = (v, Ω q): v' = −C v − Ω u, u' = Ω v. Without C and with K positive that
matrix is skew and i times it Hermitian: every Re λ is exactly zero. Otherwise `eig`; small eigenvalues of
heavily damped systems from the inverse, known entry by entry (Tisseur & Meerbergen 2001, sect. 5). Where the bound is
too wide, they are bettered by their residuals (damped_residuals.py).
"""

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.damped_in_modal_coordinates import turning
from vibcli.analyses.modal.damped_modes import DampedMode
from vibcli.analyses.modal.damped_residuals import bettered
from vibcli.analyses.modal.method import damped_at_all
from vibcli.analyses.modal.mode_numbers import in_units
from vibcli.analyses.modal.rigid_body_modes import undamped_rigid
from vibcli.analyses.modal.undamped import BETTERED, ENOUGH, prepared
from vibcli.analyses.modal.undamped_large import Approximate, approximate, dense
from vibcli.base.errors import PhysicsError
from vibcli.numerics.fixed_point import count_floats

if TYPE_CHECKING:
    from vibcli.analyses.modal.scaling import Scaling

UNIT = 2.0 ** -53


def damped_floats(elements: Any) -> list[DampedMode]:
    """DampedMode objects of many coordinates."""
    scale, zeros = prepared(elements)
    if elements.massless:
        raise PhysicsError("damped modes of so many coordinates need an inertia at each of them",
                           hint="give every coordinate a mass, or ask for part of the system")
    modal = approximate(elements, scale, zeros)
    c = dense(elements.dampers, turning(elements), scale.coordinates, scale.damping, elements.n)
    size = np.abs(modal.shapes.T) @ np.abs(c) @ np.abs(modal.shapes)
    c = modal.shapes.T @ c @ modal.shapes
    form = FirstOrder(modal, c, size)
    damps = damped_at_all(elements)
    values, vectors, radius = form.general() if damps or (modal.values < 0).any() else form.conservative()
    if not damps:
        values.real[np.abs(values.real) <= radius] = 0.0        # the spectrum mirrors itself in the imaginary axis
    still = np.argsort(np.abs(values), kind="stable")[:form.still(elements, zeros)]
    values[still], radius[still] = 0.0, 0.0
    places = form.places(values, vectors)
    if damps and elements.n <= BETTERED and (radius > ENOUGH * np.abs(values)).any():
        better = bettered(elements, scale, modal, values, modal.shapes @ places)
        if better is not None and _worst(better.values, better.errors) < _worst(values, radius):
            return numbered(_entries(better.values, better.shapes, better.errors, damps), np.eye(elements.n), scale)
    return _modes(form, values, places, radius, scale, damps)


class FirstOrder:
    """y' = A y of all modes; `size`: entry by entry what the rounding of A is proportional to."""

    __slots__ = ("elastic", "k", "matrix", "omega", "rigid", "shapes", "size")

    def __init__(self, modal: Approximate, c: np.ndarray, size: np.ndarray) -> None:
        self.k, self.shapes = len(modal.values), modal.shapes
        self.elastic, self.rigid = np.flatnonzero(modal.values), np.flatnonzero(modal.values == 0)
        self.omega = np.sqrt(np.abs(modal.values[self.elastic]))
        n, at = self.k + len(self.elastic), self.k + np.arange(len(self.elastic))
        self.matrix, self.size = np.zeros((n, n)), np.zeros((n, n))
        self.matrix[:self.k, :self.k], self.size[:self.k, :self.k] = -c, 2 * self.k * UNIT * size
        self.matrix[at, self.elastic] = self.omega
        self.matrix[self.elastic, at] = -np.sign(modal.values[self.elastic]) * self.omega
        for i, j in ((at, self.elastic), (self.elastic, at)):
            self.size[i, j] = self.omega * (modal.errors[self.elastic] + UNIT)

    def still(self, elements: Any, zeros: int | None) -> int:
        """How many eigenvalues vanish besides one for each rigid mode."""
        known = undamped_rigid(elements, zeros, elements)
        if known is not None or not len(self.rigid):
            return known or 0
        sigma = np.linalg.svd(self.matrix[np.ix_(self.rigid, self.rigid)], compute_uv=False)
        return int((sigma <= 1e-13 * np.abs(self.matrix[:self.k, :self.k]).max()).sum())

    def conservative(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Eigenvalues i times real numbers, from a Hermitian matrix."""
        skew = (self.matrix - self.matrix.T) / 2
        values, vectors = np.linalg.eigh(1j * skew)
        error = 4 * len(skew) * UNIT * np.linalg.norm(skew, 2) + np.linalg.norm(self.size)
        return -1j * values, vectors, np.full(len(values), error)

    def places(self, values: np.ndarray, vectors: np.ndarray) -> np.ndarray:
        """a of q = Φ a in columns: from velocities, or from places where these are larger."""
        velocities, out = vectors[:self.k], vectors[:self.k] / np.where(values == 0, 1.0, values)
        if not len(self.rigid):
            slow = np.linalg.norm(velocities, axis=0) < np.linalg.norm(vectors[self.k:], axis=0)
            out[:, slow] = vectors[self.k:, slow] / self.omega[:, None]
        return out

    def general(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Eigenvalues of the matrix, the small ones of its inverse where that is better."""
        count_floats(len(self.matrix))
        values, vectors = np.linalg.eig(self.matrix)
        middle = math.sqrt(np.abs(values).max() * max(np.abs(values).min(), 1e-300))
        if not len(self.rigid) and np.abs(values).max() > 1e3 * np.abs(self.omega).max():
            slow, slow_vectors = np.linalg.eig(self._inverse())
            slow = 1 / slow
            small, large = np.abs(slow) < middle, np.abs(values) >= middle
            if small.sum() + large.sum() == len(values):
                values = np.concatenate([slow[small], values[large]])
                vectors = np.hstack([slow_vectors[:, small], vectors[:, large]])
        return values, vectors, bounds(self.matrix, self.size, values, vectors)

    def _inverse(self) -> np.ndarray:
        """A⁻¹ = [[0, Ω⁻¹], [−sΩ⁻¹, −sΩ⁻¹ C Ω⁻¹]] in the order (v, u)."""
        k, out = self.k, np.zeros_like(self.matrix)
        sign = -np.sign(self.matrix[range(k), range(k, 2 * k)])
        out[range(k), range(k, 2 * k)] = 1 / self.omega
        out[range(k, 2 * k), range(k)] = -sign / self.omega
        out[k:, k:] = sign[:, None] * self.matrix[:k, :k] / self.omega[:, None] / self.omega
        return out


def bounds(matrix: np.ndarray, rounding: np.ndarray, values: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Radii from the residual seen by the left vectors, with the rounding of both."""
    try:
        left = np.linalg.inv(vectors)
    except np.linalg.LinAlgError:
        return np.full(len(values), math.sqrt(UNIT) * np.abs(values).max())
    e = left @ (matrix @ vectors - vectors * values)
    wide, size = np.abs(left), np.abs(vectors)
    unsure = (rounding + 4 * math.sqrt(len(size)) * UNIT * np.abs(matrix)) @ size
    unsure += 4 * UNIT * size * np.abs(values)
    found: np.ndarray = (np.abs(e) + wide @ unsure).sum(axis=1)
    return found


def _modes(form: FirstOrder, values: np.ndarray, places: np.ndarray, radius: np.ndarray, scale: "Scaling",
           damps: bool) -> list[DampedMode]:
    """One mode for each rigid zero, real eigenvalue and conjugate pair."""
    found = []
    for i in form.rigid:
        x = np.zeros(form.k, complex)
        x[i] = 1.0
        found.append((0j, x, 0.0))
    places = places / np.linalg.norm(places, axis=0)
    return numbered(found + _entries(values, places, radius, damps), form.shapes, scale)


def _worst(values: np.ndarray, radius: np.ndarray) -> float:
    """The largest relative bound of what moves."""
    moving = values != 0
    found: float = (radius[moving] / np.abs(values[moving])).max(initial=0.0)
    return found


def _entries(values: np.ndarray, shapes: np.ndarray, radius: np.ndarray,
             damps: bool) -> list[tuple[complex, np.ndarray, float]]:
    """(λ, shape, relative error) of each real eigenvalue and of the first of each conjugate pair."""
    found = []
    for value, x, off in zip(values, shapes.T, radius, strict=True):
        if value.imag >= 0:
            least = abs(value) if damps else min(abs(part) or abs(value) for part in (value.real, value.imag))
            found.append((complex(value), x, float(off / least) if value else 0.0))
    return found


def numbered(found: list[tuple[complex, np.ndarray, float]], shapes: np.ndarray, scale: "Scaling") -> list[DampedMode]:
    """DampedMode objects of (λ̂, vector in the columns of `shapes`, relative error) in any order."""
    found.sort(key=lambda entry: abs(entry[0]))
    basis, out = in_units(shapes, scale)[1], []
    for place, (value, x, error) in enumerate(found, 1):
        value = complex(math.ldexp(value.real, scale.time), math.ldexp(value.imag, scale.time))
        size, shape = abs(value), basis @ x
        lead = shape[int(np.argmax(np.abs(shape)))]
        zeta = -value.real / size if value.imag else None
        note = None if size else "rigid motion: λ = 0"
        out.append(DampedMode(place, value, size, zeta, shape * (abs(lead) / lead), min(error, 1.0), note))
    return out
