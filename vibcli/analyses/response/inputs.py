"""What brings a state and forces into the blocks: the rows that invert [X; X B] of all of them.

    Re Σ X W = 0      M Re Σ X B W = 1      R = W M      P = B W M + W C

with X twice the modes where a block stands for two. The first two equations are met by Newton's method in fixed point,
the inverse in floats being lost where slow modes stand beside fast ones.
"""

from itertools import pairwise

import numpy as np

from vibcli.analyses import fixed as fx
from vibcli.analyses.response.block import Block
from vibcli.analyses.response.sharpened import LARGEST, inverse_of_all
from vibcli.analyses.response.wide import BITS, narrow, parts, real_times, times, wide

ENOUGH, STEPS = 1e-9, 5
NOTHING = 1e-20


def blocks(M, C, bases):
    """The Blocks of bases (X, B, half) in fixed point."""
    n, inverse = len(M), np.linalg.inv(M)
    rounded = [(narrow(X), narrow(B)) for X, B, _ in bases]
    twins = [(X.conj(), B.conj()) for (X, B), (_, _, half) in zip(rounded, bases, strict=True) if half]
    N = inverse_of_all(rounded + twins)
    stops = np.cumsum([0] + [len(B) for _, B in rounded]).tolist()
    rows = [N[slice(*ends)] for ends in pairwise(stops)]
    Ws = [wide(row[:, n:] @ inverse) for row in rows]
    if n <= LARGEST:
        Ws = _exact(M, bases, rows, inverse, Ws)
    both = fx.fixed(np.concatenate([M, C]), BITS)
    return [_block(X, B, W, half, both) for (X, _), (_, B, half), W in zip(rounded, bases, Ws, strict=True)]


def _exact(M, bases, rows, inverse, Ws):
    """Ws so that Re Σ X W = 0 and M Re Σ X B W = 1."""
    n = len(M)
    mass, goal = fx.fixed(M, BITS), fx.fixed(np.concatenate([np.zeros((n, n)), np.eye(n)]), BITS)
    left = np.concatenate([_real_parts(X, B, half, mass) for X, B, half in bases], axis=1)
    sizes = [np.abs(narrow(W)).max() for W in Ws]
    for _ in range(STEPS):
        right = np.concatenate([np.concatenate(parts(W)) for W in Ws])
        missing = fx.floats(goal - real_times(left, right), BITS)
        steps = [row[:, :n] @ missing[:n] + row[:, n:] @ (inverse @ missing[n:]) for row in rows]
        Ws = [W + wide(step) for W, step in zip(Ws, steps, strict=True)]
        if max(np.abs(step).max() / size for step, size in zip(steps, sizes, strict=True)) < ENOUGH:
            break
    return Ws


def _real_parts(X, B, half, mass):
    """[X; M X B] as a real matrix that acts on [Re W; Im W] and gives real parts."""
    Y, sides = times(X, B), []
    for a in (X, real_times(mass, Y)):
        re, im = parts(a * 2 if half else a)
        sides.append(np.concatenate([re, -im], axis=1))
    return np.concatenate(sides)


def _block(X, B, W, half, both):
    """One Block, its B brought to an upper triangle."""
    re, im = parts(W)
    n = re.shape[1]
    momenta = [real_times(side, both[:n]) for side in (re, im)]
    drag = [real_times(side, both[n:]) for side in (re, im)]
    P = narrow(times(B, np.concatenate(momenta, axis=1)) + np.concatenate(drag, axis=1))
    R, Q, T = narrow(np.concatenate(momenta, axis=1)), *triangle(B)
    turn = Q.conj().T
    return Block(X @ Q * (2 if half else 1), T, turn @ P, turn @ R, turn @ narrow(W), half)


def triangle(B):
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


def _clean(B):
    """B without what is zero but for the rounding of many digits, in a system whose largest entries are near 1."""
    re, im = (np.where(np.abs(part) > NOTHING * np.abs(B), part, 0.0) for part in (B.real, B.imag))
    return np.where(np.abs(B) > NOTHING, re + 1j * im, 0.0)
