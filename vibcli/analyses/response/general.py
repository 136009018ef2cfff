"""Blocks of a system whose coordinates no real modes part: by the eigenvalues of λ² M + λ C + K.

Eigenvalues that stand alone are blocks of one. Those whose vectors nearly coincide (critical damping in one of several
modes, rigid motion, flutter about to begin) share a block, its basis orthonormal, so that no large terms cancel (Bavely
& Stewart 1979). All are then sharpened by residuals in fixed point (sharpened.py).
"""

import numpy as np

from vibcli.analyses.response.block import Block
from vibcli.analyses.response.clusters import groups, joined, starting
from vibcli.analyses.response.sharpened import sharpened
from vibcli.errors import PhysicsError


def general(M, C, K):
    """The Blocks of M q̈ + C q̇ + K q = f."""
    powers, rate = scaling(M, C, K)
    unit = np.ldexp(1.0, powers)
    M, C, K = (np.ldexp(unit[:, None] * matrix * unit, -lower * rate) for lower, matrix in enumerate((M, C, K)))
    check_inertia(M)
    return [_in_units(block, unit, rate) for block in blocks(M, exact_bases(M, C, K))]


def exact_bases(M, C, K):
    """The bases of all blocks, (X, B, half); eigenvalues that cannot be told apart are put together."""
    found = groups(M, C, K)
    while True:
        bases, mixed = sharpened(M, C, K, [starting(M, C, K, group) for group in found])
        if mixed is None:
            return bases
        found = joined(found, *mixed)


def scaling(M, C, K):
    """Powers of two p, r: with q = 2ᵖ q̂ and λ = 2ʳ λ̂ the diagonal of M and the largest entry of K or C are near 1."""
    diagonal = np.diagonal(M)
    if not (diagonal > 0).all():
        raise unmoved(int(np.argmin(diagonal)))
    powers = -(np.frexp(diagonal)[1] // 2)
    unit = np.ldexp(1.0, powers)
    stiffest, strongest = (np.abs(unit[:, None] * matrix * unit).max() for matrix in (K, C))
    rate = int(np.frexp(stiffest)[1]) // 2 if stiffest else int(np.frexp(strongest)[1])
    return powers, rate


def check_inertia(M):
    """Refuses a scaled M that is not positive definite."""
    try:
        np.linalg.cholesky(M)
    except np.linalg.LinAlgError:
        raise unmoved(int(np.argmin(np.abs(np.linalg.eigh(M)[1][:, 0]) < 0.5))) from None


def unmoved(i):
    """The refusal of a coordinate that no inertia moves."""
    return PhysicsError(f"no positive inertia moves with coordinate {i + 1}: its motion in time is not determined by "
                        "q̈", hint="give what it moves a mass or inertia")


def blocks(M, bases):
    """Blocks of bases (X, B, half): the rows that give c of a state are those of the inverse of all [X; X B]."""
    V = np.concatenate([_columns(basis) for basis in bases], axis=1)
    N, at, found = np.linalg.inv(V), 0, []
    inverse = np.linalg.inv(M)
    for X, B, half in bases:
        R = N[at:at + len(B), len(M):]
        W = R @ inverse
        found.append(Block(2 * X if half else X, B, N[at:at + len(B), :len(M)], R, W, half))
        at += len(B) * (1 + half)
    return found


def _columns(basis):
    X, B, half = basis
    Z = np.concatenate([X, X @ B])
    return np.concatenate([Z, Z.conj()], axis=1) if half else Z


def _in_units(block, unit, rate):
    """A block of the scaled system in the units of the given one."""
    return Block(block.X * unit[:, None], np.ldexp(block.B.real, rate) + 1j * np.ldexp(block.B.imag, rate),
                 block.P / unit, np.ldexp(1.0, -rate) * block.R / unit, np.ldexp(1.0, -rate) * block.W * unit,
                 block.half)
