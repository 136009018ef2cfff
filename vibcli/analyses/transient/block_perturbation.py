"""What the errors of M, C and K do to the blocks of a linear motion, to first order.

In the basis of the blocks ċ = B c + W f becomes ċ = (B + δA) c + W f with

    δA = −W (δK X + δC X B + δM X B²)

A diagonal entry moves an eigenvalue; another lets one block drive the next, Σ δA ∫ e^{B(t − s)} c(s) ds, which stays
small where their eigenvalues lie apart and grows with the time where they do not: E[λᵢ, λⱼ](t).
"""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.transient.modal_block import paths
from vibcli.analyses.transient.refined_subspaces import LARGEST

if TYPE_CHECKING:
    from vibcli.analyses.transient.data_errors import DataErrors
    from vibcli.analyses.transient.modal_block import ModalBlock

EPSILON = 2.0**-52
MARGIN = 2          # of what is not certified: blocks from the matrices are rounded once more
EXPONENT = 1.5      # roundings of an exponent, and of its product with the time


class BlockPerturbation:
    """dA: (P, P), bounds of the entries of δA, P the number of eigenvalues in all blocks; its diagonal with what the
    rounding of e^{λt} amounts to; decays: bounds of the errors of Re λ. X, W: (n, P), (P, n), of all blocks. ways: (i,
    j, |product|, nodes) of all paths within blocks."""

    def __init__(self, blocks: "Sequence[ModalBlock]", matrices: Sequence[np.ndarray], data: "DataErrors") -> None:
        self.blocks = blocks
        self.stops = np.cumsum([0] + [len(block.B) for block in blocks]).tolist()
        self.places = [slice(*ends) for ends in zip(self.stops, self.stops[1:], strict=False)]
        self.count = self.stops[-1]
        self.B = np.zeros((self.count, self.count), complex)
        for at, block in zip(self.places, blocks, strict=True):
            self.B[at, at] = block.B
        self.X = np.concatenate([block.X for block in blocks], axis=1)
        self.W = np.concatenate([block.W for block in blocks])
        self.signed, self.sizes = [self.X], [np.abs(self.X)]
        self.ways = [(i + at.start, j + at.start, abs(product), nodes) for at, block in zip(
            self.places, blocks, strict=True) for i, j, product, nodes in paths(block.B)]
        self.decays = 4 * EPSILON * np.abs(self.B.diagonal().real)
        self.dA = self._of(matrices, data)

    def of_eigenvalue(self, node: complex) -> tuple[float, float]:
        """Bounds of the errors of (Re λ, |λ|) of the eigenvalue next to a number."""
        at = int(np.argmin(np.abs(self.B.diagonal() - node)))
        place = next(place for place in self.places if place.start <= at < place.stop)
        off = self.dA[at, at]
        if place.stop - place.start == 1:
            return float(self.decays[at]), float(off)
        own = self.B.diagonal()[place]
        gaps = np.sort(np.abs(own - self.B[at, at]))[1:]
        turned = float(np.abs(self.B[place, place]).max() * self.dA[place, place].max())
        near = math.sqrt(turned)
        off = off + (min(near, turned / gaps[0]) if gaps[0] else near)
        return float(off), float(off)

    def power(self, k: int) -> tuple[np.ndarray, np.ndarray]:
        """X Bᵏ, and that of magnitudes."""
        while len(self.signed) <= k:
            self.signed.append(self.signed[-1] @ self.B)
            self.sizes.append(self.sizes[-1] @ np.abs(self.B))
        return self.signed[k], self.sizes[k]

    def _of(self, matrices: Sequence[np.ndarray], data: "DataErrors") -> np.ndarray:
        modal = all(block.accuracy is not None for block in self.blocks)
        found = np.zeros((self.count, self.count))
        for k, ((weights, rows), entries) in enumerate(zip(data.weights, data.entries, strict=True)):
            X = self.power(k)[0]
            if len(weights):
                self.decays += np.abs(((self.W @ rows.T) * (rows @ X).T).real) @ weights
                found += (np.abs(self.W @ rows.T) * weights) @ np.abs(rows @ X)
            if entries.any() and (not modal or k == 1):
                self.decays += np.einsum("pi,ij,jp->p", np.abs(self.W), entries, np.abs(X))
                found += np.abs(self.W) @ (entries @ np.abs(X))
        if modal:
            self._certify(found, matrices, data)
        elif len(matrices[0]) > LARGEST:
            found += self._unrefined(matrices)
        if not modal:
            found *= MARGIN
        for at, block in zip(self.places, self.blocks, strict=True):
            found[at, at] *= 0.5 if block.half else 1.0     # the other half turns the other way and is never near
        return found + EXPONENT * EPSILON * np.abs(self.B)

    def _certify(self, found: np.ndarray, matrices: Sequence[np.ndarray],
                 data: "DataErrors") -> None:
        """Of undamped modes the known error of ω takes the place of that of K and M; what damping couples is left
        out of the blocks."""
        M, C, _ = matrices
        coupling = np.abs(self.W @ C @ self.power(1)[0]) if C.any() else np.zeros_like(found)
        weights, rows = data.weights[1]
        damping = (np.abs(self.W @ rows.T) * weights) @ np.abs(rows @ self.power(1)[0]) + np.abs(self.W) @ (
            data.entries[1] @ np.abs(self.power(1)[0])) + 4 * EPSILON * np.abs(self.W) @ (
                np.abs(C) @ np.abs(self.power(1)[0]))
        share = self.W @ M @ self.X
        for at, block in zip(self.places, self.blocks, strict=True):
            square = abs(np.prod(block.nodes)) if len(block.B) > 1 else abs(block.B[0, 0])**2
            coupling[at, at] = 0.0
            self.decays[at] = np.diagonal(damping[at, at]) + 4 * EPSILON * np.abs(np.diagonal(block.B).real)
            found[at, at] = 2 * block.accuracy * square * np.abs(share[at, at]) + damping[at, at]
        found += coupling

    def _unrefined(self, matrices: Sequence[np.ndarray]) -> np.ndarray:
        """What blocks of larger systems, which are not refined, miss the equations by."""
        M, C, K = matrices
        X = [self.power(k)[0] for k in range(3)]
        found: np.ndarray = 2 * np.abs(self.W) @ np.abs(M @ X[2] + C @ X[1] + K @ X[0])
        return found
