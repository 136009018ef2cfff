"""Members cut into 1 … 128 elements a piece, cubic ones of beams, linear ones of others; `eigh` of K and M."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from vibcli.analyses.continuous.finite_elements import finite_elements
from vibcli.evidence.methods.assembled_modes import rates_of
from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject

DIVISIONS = (1, 2, 4, 8, 16, 32, 64, 128)


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """Of each number of elements that has enough modes; assembled beforehand."""
    import scipy.linalg  # noqa: F401

    elements, count = subject.data
    for divisions in DIVISIONS:
        K, M = finite_elements(elements, divisions)
        if len(K) >= count:
            yield MethodRun("finite elements", f"{divisions} a piece", partial(_rates, K, M, count))


def _rates(K: np.ndarray, M: np.ndarray, count: int, _: Deadline) -> MethodAnswer:
    import scipy.linalg

    squares = scipy.linalg.eigh(K, M, eigvals_only=True, subset_by_index=[0, count - 1])
    return rates_of(squares)
