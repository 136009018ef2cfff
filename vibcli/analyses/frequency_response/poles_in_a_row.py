"""Poles of coordinates in a row, all together by the method of Ehrlich and Aberth on det D(s) = ∏ δᵢ, D = K + sC + s²M
tridiagonal (Bini, Gemignani & Tisseur 2005, SIAM J. Matrix Anal. Appl. 27, 153):

    δᵢ = Dᵢᵢ − qᵢ₋₁/δᵢ₋₁,   qᵢ = Dᵢ,ᵢ₊₁ Dᵢ₊₁,ᵢ,      s ← s − 1/(Σ δᵢ′/δᵢ − Σ 1/(s − other poles)).

They start from the modes without dampers, with what these do to each alone.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from vibcli.analyses.frequency_response.modes_of_matrices import reduced_to_unit_mass
from vibcli.base.work import counted
from vibcli.numerics.fixed_point import MILLION

ROUNDS = 12
LAST, APART = 1e-9, 1e-7        # relative: a step after which nothing is left to do, and the least distance of poles
ASIDE = 1e-8                    # relative: a step from where a pivot is zero
PRODUCTS = 40                   # for a pole and a coordinate


def poles_in_a_row(system: Any) -> np.ndarray | None:
    """The poles with Im s > 0, complex; None where some have none beside them below the axis, where they are not told
    apart, and of coordinates in no row."""
    parts = [system.K, system.C, system.M]
    if any(np.triu(part, 2).any() or np.tril(part, -2).any() for part in parts):
        return None
    s, rows = _first(system), [_along(parts, k) for k in (0, 1, -1)]
    if s is None:
        return None
    left, rounds = np.arange(len(s)), 0
    with np.errstate(all="ignore"):
        while len(left) and rounds < ROUNDS:
            counted(len(left) * len(s) * PRODUCTS / MILLION)
            apart = s[left, None] - np.concatenate([s, s.conj()])
            apart[np.arange(len(left)), left] = np.inf
            slopes, pivot, slope = _slopes(*rows, s[left])
            step = pivot / ((slopes - (1 / apart).sum(axis=1)) * pivot + slope)
            step = np.where(np.isfinite(step), step, ASIDE * s[left])
            s[left] -= step
            left, rounds = left[~(np.abs(step) <= LAST * np.abs(s[left]))], rounds + 1
    s = s[np.argsort(s.imag)]
    close = np.abs(np.diff(s)) <= APART * np.abs(s[1:])
    found: np.ndarray | None = None if len(left) or close.any() or not (s.imag > APART * np.abs(s)).all() else s
    return found


def _first(system: Any) -> np.ndarray | None:
    """Where the search starts; None where M is not positive definite, and where a mode by itself does not oscillate."""
    reduced = reduced_to_unit_mass(system)
    if reduced is None:
        return None
    squares, turn = np.linalg.eigh((reduced.K + reduced.K.T) / 2)
    rates = ((reduced.C @ turn) * turn).sum(axis=0) / 2
    found: np.ndarray | None = np.sqrt(squares - rates**2) * 1j - rates if (squares > rates**2).all() else None
    return found


def _along(parts: Sequence[np.ndarray], k: int) -> np.ndarray:
    """The diagonals beside the main one of K, C and M: (3, n − |k|, 1)."""
    return np.stack([np.diagonal(part, k) for part in parts])[:, :, None]


def _slopes(diagonal: np.ndarray, above: np.ndarray, below: np.ndarray,
            s: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(Σ δᵢ′/δᵢ of all pivots but the last, this, its slope)."""
    D, steep = _polynomial(diagonal, s)
    (one, one_steep), (other, other_steep) = _polynomial(above, s), _polynomial(below, s)
    products, products_steep = one * other, one * other_steep + other * one_steep
    pivot, slope, total = D[0], steep[0], np.zeros(len(s), complex)
    for i, (q, q_steep) in enumerate(zip(products, products_steep, strict=True), 1):
        inverse = 1 / pivot
        moved = slope * inverse
        total += moved
        pivot, slope = D[i] - q * inverse, steep[i] - (q_steep - q * moved) * inverse
    return total, pivot, slope


def _polynomial(parts: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(K + sC + s²M, its derivative) of so many entries, (m, N)."""
    K, C, M = parts
    return K + s * (C + s * M), C + 2 * s * M
