"""Blocks of a system whose coordinates no real modes part: by the eigenvalues of λ² M + λ C + K.

Eigenvalues that stand alone are blocks of one. Those whose vectors nearly coincide (critical damping in one of several
modes, rigid motion, flutter about to begin) share a block, its basis orthonormal, so that no large terms cancel (Bavely
& Stewart 1979). All are then sharpened by residuals in fixed point (sharpened.py).
"""

import numpy as np

from vibcli.analyses.transient.eigenvalue_clusters import groups, joined, starting
from vibcli.analyses.transient.modal_block import ModalBlock
from vibcli.analyses.transient.modal_input import blocks
from vibcli.analyses.transient.refined_subspaces import sharpened


def general(M: np.ndarray, C: np.ndarray, K: np.ndarray, rigid: np.ndarray | None = None) -> list[ModalBlock]:
    """The Blocks of M q̈ + C q̇ + K q = f. rigid: columns of what moves freely, K being symmetric."""
    powers, rate = scaling(M, C, K)
    unit = np.ldexp(1.0, powers)
    M, C, K = (np.ldexp(unit[:, None] * matrix * unit, -lower * rate) for lower, matrix in enumerate((M, C, K)))
    found = blocks(M, C, exact_bases(M, C, K))
    if rigid is not None and rigid.size:
        found = _freely(found, M, C, K, rigid / unit[:, None])
    return [_in_units(block, unit, rate) for block in found]


def _freely(found: list[ModalBlock], M: np.ndarray, C: np.ndarray, K: np.ndarray,
            rigid: np.ndarray) -> list[ModalBlock]:
    """Blocks that hold as many eigenvalues 0 as what moves freely has."""
    from vibcli.analyses.transient.rigid_motions import exact, freed

    apart = freed(M, C, K, rigid)
    if apart is None or exact(found) >= apart.zeros:
        return found
    return [apart.back(block) for block in blocks(apart.M, apart.C, exact_bases(apart.M, apart.C, apart.K))]


def exact_bases(M: np.ndarray, C: np.ndarray, K: np.ndarray) -> list[tuple[np.ndarray, np.ndarray, bool]]:
    """The bases of all blocks, (X, B, half) in fixed point; eigenvalues that cannot be told apart are put together."""
    found = groups(M, C, K)
    while True:
        bases, mixed = sharpened(M, C, K, [starting(M, C, K, group) for group in found])
        if mixed is None:
            return bases
        found = joined(found, *mixed)


def scaling(M: np.ndarray, C: np.ndarray, K: np.ndarray) -> tuple[np.ndarray, int]:
    """Powers of two p, r: with q = 2ᵖ q̂ and λ = 2ʳ λ̂ the diagonal of M and the largest entry of K or C are near 1;
    coordinates without inertia come last."""
    h = int(np.count_nonzero(M.diagonal()))
    powers = -(np.frexp(np.diagonal(M))[1] // 2)
    unit = np.ldexp(1.0, powers)[:h]
    stiffest, strongest = (np.abs(unit[:, None] * matrix[:h, :h] * unit).max(initial=0.0) for matrix in (K, C))
    rate = int(np.frexp(stiffest)[1]) // 2 if stiffest else int(np.frexp(strongest)[1])
    if h < len(M):                      # of first order, λ = k/c: there C is brought to 1
        dragged, held = C.diagonal()[h:], np.abs(K.diagonal()[h:])
        relaxing = int(np.frexp((held / dragged).max())[1])
        rate = max(rate, relaxing) if h else relaxing
        powers[h:] = -((np.frexp(dragged)[1] - rate) // 2)
    return powers, rate


def _in_units(block: ModalBlock, unit: np.ndarray, rate: int) -> ModalBlock:
    """A block of the scaled system in the units of the given one."""
    return ModalBlock(block.X * unit[:, None], np.ldexp(block.B.real, rate) + 1j * np.ldexp(block.B.imag, rate),
                 block.P / unit, np.ldexp(1.0, -rate) * block.R / unit, np.ldexp(1.0, -rate) * block.W * unit,
                 block.half)
