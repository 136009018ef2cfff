"""A part of a linear system that moves by itself: one eigenvalue, or several that lie close together."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from vibcli.base.named_tuple import NamedTuple

EPSILON, ROUNDINGS = 2.0**-52, 4


class ModalBlock(NamedTuple):
    """ċ = B c + W f with c(0) = P q₀ + R v₀, and its share Re(X c) of the coordinates.

    B: p × p, upper triangular, its diagonal the eigenvalues. X: n × p. P, R, W: p × n. half: of a pair of conjugate
    blocks this one stands for both (X is twice the modes). accuracy: of an undamped mode the relative error bound of
    its ω, None of what was found from the matrices.
    """

    X: np.ndarray
    B: np.ndarray
    P: np.ndarray
    R: np.ndarray
    W: np.ndarray
    half: bool = False
    accuracy: float | None = None

    @property
    def nodes(self) -> tuple[complex, ...]:
        """The eigenvalues."""
        return tuple(map(complex, self.B.diagonal()))

    def rows(self, output: Any, order: int) -> np.ndarray:
        """The order-th derivative of q·δ + v·δ̇ + a·δ̈ is Re(rows · c) and terms of f (markov.py).

        What is left by terms that cancel to their last digits is 0: the tension of a shaft that turns freely.
        """
        total, size = np.zeros(len(self.B), complex), np.zeros(len(self.B))
        for coefficients in (output.a, output.v, output.q):
            total, size = total @ self.B, size @ np.abs(self.B)
            for i, x in coefficients.items():
                total, size = total + x * self.X[i], size + np.abs(x * self.X[i])
        total[np.abs(total) <= ROUNDINGS * EPSILON * size] = 0.0
        found: np.ndarray = total @ np.linalg.matrix_power(self.B, order)
        return found


def paths(B: Any) -> list[tuple[int, int, complex, tuple[complex, ...]]]:
    """(i, j, product, nodes) of every way up the triangle: (e^{Bt})ᵢⱼ = Σ product · E[nodes](t)."""
    found, nodes = [], tuple(map(complex, np.diagonal(B)))
    for i in range(len(B)):
        ways: list[tuple[tuple[int, ...], Any]] = [((i,), 1.0)]
        while ways:
            stops, product = ways.pop()
            j = stops[-1]
            found.append((i, j, complex(product), tuple(nodes[k] for k in stops)))
            ways += [((*stops, k), product * B[j, k]) for k in range(j + 1, len(B)) if B[j, k]]
    return found


def apart(block: ModalBlock, places: Sequence[int], n: int) -> ModalBlock:
    """The block of some coordinates as one of n coordinates."""
    X, P, R, W = np.zeros((n, len(block.B)), complex), *(np.zeros((len(block.B), n), complex) for _ in range(3))
    X[places] = block.X
    for whole, part in ((P, block.P), (R, block.R), (W, block.W)):
        whole[:, places] = part
    return block._replace(X=X, P=P, R=R, W=W)
