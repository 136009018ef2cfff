"""Invariant subspaces sharpened far beyond floats: M X B² + C X B + K X = 0 by Newton's method in fixed point.

With V = [X; X B] of all blocks (of X B the rows that have inertia) and S = −V⁻¹ [0; L⁻¹ r], r the residual and L of
condensed.leading, V⁻¹ A V = B + S. The parts of S outside the blocks are removed by V ← V (I + E),
Bᵢ Eᵢⱼ − Eᵢⱼ Bⱼ = −Sᵢⱼ, those inside are added to B. Only the residual is computed in many digits; every step squares
the error.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from vibcli.analyses.transient.static_condensation import leading
from vibcli.numerics import fixed_point as fx
from vibcli.numerics.fixed_point_complex import BITS, narrow, parts, times, wide

ALONE, JOINED = 1e-13, 1e-32
STEPS = 8
LARGEST = 60
MIXED = 0.3


def sharpened(
        M: np.ndarray,
        C: np.ndarray,
        K: np.ndarray,
        bases: Sequence[tuple[np.ndarray, np.ndarray, bool]]) -> tuple[list[tuple[np.ndarray, np.ndarray, bool]], Any]:
    """The bases (X, B, half) in fixed point; None and two places of `bases` where those two cannot be told apart."""
    h, lead = leading(M, C)
    data, inverse = fx.fixed(np.concatenate([M, C, K], axis=1), BITS), np.linalg.inv(lead)
    Xs, Bs = [wide(X) for X, _, _ in bases], [wide(B) for _, B, _ in bases]
    halves = [half for _, _, half in bases]
    twins = [i for i, half in enumerate(halves) if half]
    goal = ALONE if all(len(B) == 1 for B in Bs) else JOINED
    blocks = [(X.astype(complex), B.astype(complex)) for X, B, _ in bases]
    for _ in range(STEPS if len(M) <= LARGEST else 0):
        residual = _residual(data, Xs, Bs)
        blocks += [(X.conj(), B.conj()) for X, B in (blocks[i] for i in twins)]
        S = -inverse_of_all(blocks, h)[:, h:] @ (inverse @ residual)
        E, D = _corrections(S, [B for _, B in blocks], len(bases))
        largest = np.unravel_index(np.argmax(np.abs(E)), E.shape)
        if not abs(E[largest]) < MIXED:
            owner = np.repeat([*range(len(bases)), *twins], [len(B) for _, B in blocks])
            return None, owner[list(largest)].tolist()
        moved = np.concatenate([X for X, _ in blocks], axis=1) @ E
        re, im = parts(wide(moved))
        Xs = [X + np.concatenate([re[:, at], im[:, at]], axis=1) for X, (at, _) in zip(Xs, D, strict=True)]
        Bs = [B + wide(step) for B, (_, step) in zip(Bs, D, strict=True)]
        if abs(E[largest]) <= goal:
            break
        blocks = [(narrow(X), narrow(B)) for X, B in zip(Xs, Bs, strict=True)]
    return list(zip(Xs, Bs, halves, strict=True)), None


def inverse_of_all(blocks: Sequence[tuple[np.ndarray, np.ndarray]], h: int) -> np.ndarray:
    """The inverse of [X; X B], the columns of all blocks, of X B the first h rows."""
    full = np.concatenate([X for X, _ in blocks], axis=1)
    rates = np.concatenate([X[:h] @ B for X, B in blocks], axis=1)
    return np.linalg.inv(np.concatenate([full, rates]))


def _residual(data: np.ndarray, Xs: Sequence[np.ndarray], Bs: Sequence[np.ndarray]) -> np.ndarray:
    """M X B² + C X B + K X of all blocks, in floats."""
    Ys = [times(X, B) for X, B in zip(Xs, Bs, strict=True)]
    columns = [np.concatenate([times(Y, B), Y, X]) for X, Y, B in zip(Xs, Ys, Bs, strict=True)]
    sides = [np.concatenate(side, axis=1) for side in zip(*map(parts, columns), strict=True)]
    return narrow(fx.product(data, np.concatenate(sides, axis=1), BITS))


def _corrections(S: np.ndarray, blocks: Sequence[np.ndarray],
                 count: int) -> tuple[np.ndarray, list[tuple[slice, np.ndarray]]]:
    """E, and for each of the first `count` blocks (its columns, what is added to it): Bᵢ Eᵢⱼ − Eᵢⱼ Bⱼ = −Sᵢⱼ between
    different blocks."""
    stops = np.cumsum([0] + [len(B) for B in blocks]).tolist()
    places = [slice(*ends) for ends in pairwise(stops)]
    values = np.concatenate([B.diagonal() for B in blocks])
    gaps = values[:S.shape[1]] - values[:, None]
    E, D = np.divide(S, gaps, out=np.where(S, np.inf, S), where=gaps != 0), []
    for column, (at, own) in enumerate(zip(places[:count], blocks, strict=False)):
        D.append((at, S[at, at]))
        E[at, at] = 0.0
        for row, (place, other) in enumerate(zip(places, blocks, strict=True)):
            if row != column and len(own) + len(other) > 2:
                E[place, at] = sylvester(other, own, -S[place, at])
    return E, D


def sylvester(A: np.ndarray, B: np.ndarray, C: np.ndarray) -> np.ndarray:
    """X with A X − X B = C, for small blocks; without bound where A and B share an eigenvalue."""
    p, q = len(A), len(B)
    system = np.kron(A, np.eye(q)) - np.kron(np.eye(p), B.T)
    try:
        return np.linalg.solve(system, C.ravel()).reshape(p, q)
    except np.linalg.LinAlgError:
        return np.where(C.any(), np.inf, C)
