"""λ of λ² M + λ C + K by SciPy and NumPy: of the state matrix, where M is not singular, and of a pencil wherever."""

from collections.abc import Iterator

import numpy as np

from vibcli.evidence.subject import Attempt, Found, Subject


def attempts(subject: Subject) -> Iterator[Attempt]:
    """`eig` of [0 I; −M⁻¹K −M⁻¹C] and of its pencil."""
    import scipy.linalg

    M, C, K = subject.data
    zero, one = np.zeros_like(M), np.eye(len(M))
    if np.linalg.matrix_rank(M) == len(M):
        yield Attempt("numpy eig", "", lambda _: _upper(np.linalg.eigvals(_state(M, C, K))))
        yield Attempt("scipy eig", "", lambda _: _upper(scipy.linalg.eigvals(_state(M, C, K))))
    yield Attempt("scipy eig of the pencil", "", lambda _: _upper(
        scipy.linalg.eigvals(np.block([[zero, one], [-K, -C]]), np.block([[one, zero], [zero, M]]))))


def _state(M, C, K):
    """The matrix of (q, q̇)' = A (q, q̇)."""
    return np.block([[np.zeros_like(M), np.eye(len(M))], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])


def _upper(values: np.ndarray) -> Found:
    """One of each conjugate pair, of those that are finite."""
    return Found([x for x in values.tolist() if x.imag >= 0 and abs(x) < np.inf])
