"""Eigenvalues and eigenvectors A v = λ v of graded matrices, small entries beside large ones, polished by one step of
Newton's method, and how far rounding leaves them off: of S = V⁻¹ (A V − V Λ), λₖ + Sₖₖ and V (1 + Sᵢₖ/(λₖ − λᵢ))."""

import numpy as np

from vibcli.base.named_tuple import NamedTuple

APART = 1e-8        # of |λ|: what is told apart
ROUNDED = 2.0**-50  # of each term of a residue


class Eigenvectors(NamedTuple):
    """rates λ, vectors V (n, n), inverse V⁻¹; phase: relative bounds of the errors of λ, size: of what vectors show,
    of which others show the more the slower they are, (n,)."""

    rates: np.ndarray
    vectors: np.ndarray
    inverse: np.ndarray
    phase: np.ndarray
    size: np.ndarray


def eigenvectors(A: np.ndarray) -> Eigenvectors:
    """Of a real matrix."""
    rates, V = np.linalg.eig(A)
    inverse = np.linalg.inv(V)
    gap = rates - rates[:, None]
    near = np.abs(gap) <= APART * np.abs(rates)
    share = np.where(near, 0.0, 1 / np.where(near, 1.0, gap))
    S = inverse @ (A @ V - V * rates)
    real, more, turned = rates.imag == 0, np.diagonal(S), V + V @ (S * share)
    rates, V = rates + np.where(real, more.real, more), np.where(real, turned.real, turned)
    inverse = inverse - (inverse @ V - np.eye(len(A))) @ inverse
    pace = np.maximum(np.abs(rates), 1e-300)
    off = ROUNDED * (np.abs(inverse) @ (np.abs(A) @ np.abs(V)))
    size = (off * np.abs(share) * np.maximum(pace / pace[:, None], 1.0)).sum(axis=0)
    return Eigenvectors(rates, V, inverse, np.diagonal(off) / pace, size)
