"""Members cut into 1 … 128 elements a piece, cubic ones of beams, linear ones of others; `eigh` of K and M, or LU at a
frequency."""

from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np

from vibcli.analyses.continuous.finite_elements import finite_elements
from vibcli.evidence.methods.assembled_modes import rates_of
from vibcli.evidence.subject import Deadline, MethodAnswer, MethodRun, Subject

DIVISIONS = (1, 2, 4, 8, 16, 32, 64, 128)


def attempts(subject: Subject) -> Iterator[MethodRun]:
    """Of each number of elements that has enough modes; assembled beforehand."""
    import scipy.linalg  # noqa: F401

    if subject.kind == "member response":
        yield from _responses(subject)
        return
    elements, count = subject.data
    for divisions in DIVISIONS:
        K, M = finite_elements(elements, divisions)
        if len(K) >= count:
            yield MethodRun("finite elements", f"{divisions} a piece", partial(_rates, K, M, count))


def _responses(subject: Subject) -> Iterator[MethodRun]:
    exact, Omega, read = subject.data
    for divisions in DIVISIONS:
        matrices = finite_elements(exact.elements, divisions)
        yield MethodRun("finite elements", f"{divisions} a piece", partial(_response, exact, matrices, Omega, read))


def _response(exact: Any, matrices: tuple, Omega: float, read: Any, _: Deadline) -> MethodAnswer:
    """H by LU of the matrix at a frequency."""
    (K, M), n, s = matrices, exact.elements.n, 1j * Omega
    D = K + s * s * M
    _, C, G, _ = exact.elements.with_parts(pieces=()).arrays()
    D[:n, :n] += s * (C + G)
    right = np.zeros(len(K), complex)
    for power, entries in enumerate(exact.b):
        for i, x in entries.items():
            right[i] += s**power * x
    q = np.linalg.solve(D, right)
    return MethodAnswer([read(sum(s**power * (sum(x * q[i] for i, x in entries.items()) + d)
                                  for power, (entries, d) in enumerate(zip(exact.c, exact.d, strict=True))))])


def _rates(K: np.ndarray, M: np.ndarray, count: int, _: Deadline) -> MethodAnswer:
    import scipy.linalg

    squares = scipy.linalg.eigh(K, M, eigvals_only=True, subset_by_index=[0, count - 1])
    return rates_of(squares)
