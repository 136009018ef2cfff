"""What brings a state and forces into the blocks: the rows that invert [X; X B] of all of them.

    Re Σ X_a W = 0      M_a Re Σ X_a B W + C_z Re Σ X_z W = 1      R = W M      P = B W M + W C

with X twice the modes where a block stands for two, a the coordinates that have inertia and z the others. The first two
equations are met by Newton's method in fixed point, the inverse in floats being lost where slow modes stand beside fast
ones.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from vibcli.analyses.transient.modal_block import ModalBlock
from vibcli.analyses.transient.refined_subspaces import LARGEST, inverse_of_all
from vibcli.analyses.transient.static_condensation import leading
from vibcli.numerics import fixed_point as fx
from vibcli.numerics.fixed_point_complex import BITS, narrow, parts, times

ENOUGH, STEPS = 1e-9, 5
NOTHING = 1e-20


def blocks(M: np.ndarray, C: np.ndarray, bases: Sequence[tuple[np.ndarray, np.ndarray, bool]]) -> list[ModalBlock]:
    """The Blocks of bases (X, B, half) in fixed point."""
    n = len(M)
    rounded = [(narrow(X), narrow(B)) for X, B, _ in bases]
    twins = [(X.conj(), B.conj()) for (X, B), (_, _, half) in zip(rounded, bases, strict=True) if half]
    stops = np.cumsum([0] + [len(B) for _, B in rounded]).tolist()
    rows = inverse_of_all(rounded + twins, leading(M, C)[0])[:stops[-1]]
    places = [slice(*ends) for ends in pairwise(stops)]
    W = _inputs(M, C, bases, rows)
    sides = fx.product(W, fx.fixed(np.concatenate([M, C], axis=1), BITS), BITS)
    R, drag = beside(sides[:, :n]), beside(sides[:, n:])
    P = drag + np.concatenate([times(B, R[at]) for at, (_, B, _) in zip(places, bases, strict=True)])
    P, R, W, found = narrow(P), narrow(R), narrow(beside(W)), []
    for at, (X, _), (_, B, half) in zip(places, rounded, bases, strict=True):
        Q, T = triangle(B)
        turn = Q.conj().T
        found.append(ModalBlock(X @ Q * (2 if half else 1), T, turn @ P[at], turn @ R[at], turn @ W[at], half))
    return found


def _inputs(M: np.ndarray, C: np.ndarray, bases: Sequence[tuple[np.ndarray, np.ndarray, bool]],
            rows: np.ndarray) -> np.ndarray:
    """W of all blocks, Re W above Im W, by the first two equations."""
    n, (h, lead) = len(M), leading(M, C)
    inverse = np.linalg.inv(lead)
    start = rows[:, h:] @ inverse
    W, size = fx.fixed(np.concatenate([start.real, start.imag]), BITS), np.abs(start).max(axis=1)
    if n > LARGEST:
        found: np.ndarray = W
        return found
    left = _real_parts(lead, bases, h)
    goal = fx.fixed(np.concatenate([np.zeros((h, n)), np.eye(n)]), BITS)
    for _ in range(STEPS):
        missing = fx.floats(goal - fx.product(left, W, BITS), BITS)
        step = rows[:, :h] @ missing[:h] + rows[:, h:] @ (inverse @ missing[h:])
        W = W + fx.fixed(np.concatenate([step.real, step.imag]), BITS)
        if (np.abs(step).max(axis=1) < ENOUGH * size).all():
            break
    result: np.ndarray = W
    return result


def _real_parts(lead: np.ndarray, bases: Sequence[tuple[np.ndarray, np.ndarray, bool]], h: int) -> np.ndarray:
    """[X_a; C_z X_z + M_a X_a B] of all as a real matrix that acts on [Re W; Im W] and gives real parts."""
    both = [np.concatenate([X, times(X, B)]) * (2 if half else 1) for X, B, half in bases]
    re, im = (np.concatenate(sides, axis=1) for sides in zip(*map(parts, both), strict=True))
    whole, n = np.concatenate([re, -im], axis=1), len(lead)
    return np.concatenate([whole[:h], fx.product(fx.fixed(lead, BITS), whole[h:n + h], BITS)])


def beside(a: np.ndarray) -> np.ndarray:
    """[Re | Im] of a matrix given as Re above Im."""
    middle = len(a) // 2
    return np.concatenate([a[:middle], a[middle:]], axis=1)


def triangle(B: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(Q, Qᴴ B Q) with an upper triangle: a Schur form in the digits that Newton's method gave."""
    if len(B) == 1:
        return np.eye(1), _clean(narrow(B))
    from mpmath import mp, mpc, mpf

    with mp.workprec(BITS):
        exact = mp.matrix(len(B), len(B))
        for at in np.ndindex(len(B), len(B)):
            exact[at] = mpc(*(mp.ldexp(mpf(int(part[at])), -BITS) for part in parts(B)))
        Q, T = mp.schur(exact)
        Q, T = (np.array(matrix.tolist(), complex) for matrix in (Q, T))
    return Q, _clean(np.triu(T))


def _clean(B: np.ndarray) -> np.ndarray:
    """B without what is zero but for the rounding of many digits, in a system whose largest entries are near 1."""
    re, im = (np.where(np.abs(part) > NOTHING * np.abs(B), part, 0.0) for part in (B.real, B.imag))
    return np.where(np.abs(B) > NOTHING, re + 1j * im, 0.0)
