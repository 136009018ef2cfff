"""λ of λ² M + λ C + K by SciPy and NumPy: of the state matrix, where M is not singular, and of a pencil wherever."""

from collections.abc import Iterator

import numpy as np

from vibcli.evidence.reference.frequency_response import state_matrix
from vibcli.evidence.subject import MethodAnswer, MethodRun, Subject


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """`eig` of [0 I; −M⁻¹K −M⁻¹C] and of its pencil."""
    import scipy.linalg

    M, C, K = subject.data
    zero, one = np.zeros_like(M), np.eye(len(M))
    if np.linalg.matrix_rank(M) == len(M):
        yield MethodRun("numpy eig", "", lambda _: _upper(np.linalg.eigvals(state_matrix(M, C, K))))
        yield MethodRun("scipy eig", "", lambda _: _upper(scipy.linalg.eigvals(state_matrix(M, C, K))))
    yield MethodRun("scipy eig of the pencil", "", lambda _: _upper(
        scipy.linalg.eigvals(np.block([[zero, one], [-K, -C]]), np.block([[one, zero], [zero, M]]))))


def _upper(values: np.ndarray) -> MethodAnswer:
    """One of each conjugate pair, of those that are finite."""
    return MethodAnswer([x for x in values.tolist() if x.imag >= 0 and abs(x) < np.inf])
