"""Rates λ of K φ = −λ² M φ by SciPy and NumPy, on the assembled matrices: λ = iω where −λ² is positive."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from vibcli.evidence.subject import MethodAnswer, MethodRun, Subject


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """`eigh` where M is positive definite and K symmetric, `eig` wherever."""
    import scipy.linalg

    M, _, K = subject.data
    if _is_definite(M) and (K == K.T).all():
        yield MethodRun("scipy eigh", "", lambda _: rates_of(scipy.linalg.eigh(K, M, eigvals_only=True)))
        yield MethodRun("numpy eigh", "", lambda _: rates_of(_by_cholesky(M, K)))
    if np.linalg.matrix_rank(M) == len(M):
        yield MethodRun("numpy eig", "", lambda _: rates_of(np.linalg.eigvals(np.linalg.solve(M, K))))
    yield MethodRun("scipy eig", "", lambda _: rates_of(scipy.linalg.eigvals(K, M)))


def _by_cholesky(M: np.ndarray, K: np.ndarray) -> np.ndarray:
    """eigh of L⁻¹ K L⁻ᵀ."""
    L = np.linalg.cholesky(M)
    A = np.linalg.solve(L, np.linalg.solve(L, K).T)
    return np.linalg.eigvalsh((A + A.T) / 2)


def rates_of(squares: np.ndarray) -> MethodAnswer:
    """√−ω² of those that are finite, with Im λ ≥ 0."""
    rates = np.sqrt(-squares[np.isfinite(squares)].astype(complex))
    return MethodAnswer(np.where(rates.imag < 0, -rates, rates).tolist())


def _is_definite(M: Any) -> bool:
    try:
        np.linalg.cholesky(M)
    except np.linalg.LinAlgError:
        return False
    return True
