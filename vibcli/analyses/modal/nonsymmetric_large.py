"""Modes of many coordinates with a K that is not symmetric, in floats, with a bound of the rounding.

Without C and G the eigenvalues μ of L⁻¹ K̂ L⁻ᵀ, M̂ = L Lᵀ, give λ = √−μ; else y = (q', q): q'' = −C q' − K q.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.modal.damped_in_modal_coordinates import turning
from vibcli.analyses.modal.damped_large import bounds, numbered
from vibcli.analyses.modal.undamped import prepared
from vibcli.analyses.modal.undamped_large import UNIT, back_from, dense, mass_triangle, stiffness
from vibcli.base.errors import PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.modal.damped_modes import DampedMode


def follower_floats(elements: Any) -> "list[DampedMode]":
    """DampedMode objects of many coordinates; without C and G the first of each ±λ."""
    scale, _ = prepared(elements)
    if elements.massless:
        raise PhysicsError("modes of so many coordinates under forces that follow them need an inertia at each",
                           hint="give every coordinate a mass, or ask for part of the system")
    back = back_from(mass_triangle(elements, scale, range(elements.n)), np.eye(elements.n))
    k, size = stiffness(elements, scale)
    k, size = back.T @ k @ back, np.abs(back.T) @ size @ np.abs(back)
    c = dense(elements.dampers, turning(elements), scale.coordinates, scale.damping, elements.n)
    c, c_size = back.T @ c @ back, np.abs(back.T) @ np.abs(c) @ np.abs(back)
    return numbered(_moving(c, c_size, k, size) if c.any() else _at_rest(k, size), back, scale)


def _at_rest(k: np.ndarray, size: np.ndarray) -> list[tuple[complex, np.ndarray, float]]:
    """(λ, vector, relative error) from q'' = −K q."""
    values, vectors = np.linalg.eig(k)
    radius, out = bounds(k, 2 * len(k) * UNIT * size, values, vectors), []
    for value, x, off in zip(values, vectors.T, radius, strict=True):
        if abs(value) <= 2 * off:
            out.append((0j, _unit(x), 1.0))
        elif abs(value.imag) <= off:
            real = abs(value.real) ** 0.5
            out.append((1j * real if value.real > 0 else real + 0j, _unit(x), off / abs(value)))
        elif value.imag > 0:
            rate = (-value.conjugate()) ** 0.5
            out.append((rate, _unit(x.conj()), off / abs(rate) / min(rate.real, rate.imag)))
    return out


def _moving(c: np.ndarray, c_size: np.ndarray, k: np.ndarray,
            k_size: np.ndarray) -> list[tuple[complex, np.ndarray, float]]:
    """(λ, vector, relative error) from q'' = −C q' − K q."""
    n = len(k)
    matrix, size = np.zeros((2 * n, 2 * n)), np.zeros((2 * n, 2 * n))
    matrix[:n], matrix[range(n, 2 * n), range(n)] = -np.hstack([c, k]), 1.0
    size[:n] = 2 * n * UNIT * np.hstack([c_size, k_size])
    values, vectors = np.linalg.eig(matrix)
    radius, out = bounds(matrix, size, values, vectors), []
    for value, y, off in zip(values, vectors.T, radius, strict=True):
        if abs(value) <= 2 * off:
            out.append((0j, _unit(y[n:]), 1.0))
        elif value.imag >= 0:
            out.append((complex(value), _unit(y[n:]), off / abs(value)))
    return out


def _unit(x: np.ndarray) -> np.ndarray:
    found: np.ndarray = x / np.linalg.norm(x)
    return found
