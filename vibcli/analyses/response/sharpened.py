"""Invariant subspaces sharpened far beyond floats: M X B² + C X B + K X = 0 by Newton's method in fixed point.

With V = [X; X B] of all blocks and S = −V⁻¹ [0; M⁻¹ r], r the residual, V⁻¹ A V = B + S. The parts of S outside the
blocks are removed by V ← V (I + E), Bᵢ Eᵢⱼ − Eᵢⱼ Bⱼ = −Sᵢⱼ, those inside are added to B. Only the residual is
computed in many digits; every step squares the error.
"""

from itertools import pairwise

import numpy as np

from vibcli.analyses import fixed as fx

BITS = 320
ALONE, JOINED = 1e-13, 1e-24
STEPS = 8
LARGEST = 60
MIXED = 0.3
NOTHING = 1e-20


def sharpened(M, C, K, bases):
    """The bases (X, B, half) made exact to floats, B upper triangular; None and two places of `bases` where those two
    cannot be told apart."""
    data, inverse = fx.fixed(np.concatenate([M, C, K], axis=1), BITS), np.linalg.inv(M)
    Xs, Bs = [_fixed(X) for X, _, _ in bases], [_fixed(B) for _, B, _ in bases]
    halves = [half for _, _, half in bases]
    twins = [i for i, half in enumerate(halves) if half]
    goal = ALONE if all(len(B) == 1 for B in Bs) else JOINED
    for _ in range(STEPS if len(M) <= LARGEST else 0):
        residual = np.concatenate([_floats(_residual(data, X, B)) for X, B in zip(Xs, Bs, strict=True)], axis=1)
        blocks = [(_floats(X), _floats(B)) for X, B in zip(Xs, Bs, strict=True)]
        blocks += [(X.conj(), B.conj()) for X, B in (blocks[i] for i in twins)]
        full = np.concatenate([X for X, _ in blocks], axis=1)
        rates = np.concatenate([X @ B for X, B in blocks], axis=1)
        S = -np.linalg.inv(np.concatenate([full, rates]))[:, len(M):] @ (inverse @ residual)
        E, D = _corrections(S, [B for _, B in blocks], len(bases))
        largest = np.unravel_index(np.argmax(np.abs(E)), E.shape)
        if not abs(E[largest]) < MIXED:
            owner = np.repeat([*range(len(bases)), *twins], [len(B) for _, B in blocks])
            return None, owner[list(largest)].tolist()
        moved = full @ E
        Xs = [X + _fixed(moved[:, at]) for X, (at, _) in zip(Xs, D, strict=True)]
        Bs = [B + _fixed(step) for B, (_, step) in zip(Bs, D, strict=True)]
        if abs(E[largest]) <= goal:
            break
    return [_triangular(_floats(X), B, half) for X, B, half in zip(Xs, Bs, halves, strict=True)], None


def _fixed(a):
    """A complex matrix in fixed point, its real and imaginary parts side by side."""
    return fx.fixed(np.concatenate([a.real, a.imag], axis=1), BITS)


def _halves(a):
    return np.split(a, 2, axis=1)


def _floats(a):
    re, im = _halves(fx.floats(a, BITS))
    return re + 1j * im


def _residual(data, X, B):
    """M X B² + C X B + K X."""
    re, im = _halves(B)
    turned = np.concatenate([-im, re], axis=1)
    Y = _by(X, B, turned)
    return fx.product(data, np.concatenate([_by(Y, B, turned), Y, X]), BITS)


def _by(X, B, turned):
    """X B; turned: i B."""
    left, right = _halves(X)
    return fx.product(left, B, BITS) + fx.product(right, turned, BITS)


def _corrections(S, blocks, count):
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


def sylvester(A, B, C):
    """X with A X − X B = C, for small blocks."""
    p, q = len(A), len(B)
    system = np.kron(A, np.eye(q)) - np.kron(np.eye(p), B.T)
    return np.linalg.solve(system, C.ravel()).reshape(p, q)


def _triangular(X, B, half):
    """(X Q, Qᴴ B Q, half) with an upper triangle, by a Schur form in the digits that Newton's method gave."""
    if len(B) == 1:
        return X, _clean(_floats(B)), half
    from mpmath import mp, mpc, mpf

    with mp.workprec(BITS):
        exact = mp.matrix(len(B), len(B))
        for at in np.ndindex(len(B), len(B)):
            exact[at] = mpc(*(mp.ldexp(mpf(int(part[at])), -BITS) for part in _halves(B)))
        Q, T = mp.schur(exact)
        Q, T = (np.array(matrix.tolist(), complex) for matrix in (Q, T))
    return X @ Q, _clean(np.triu(T)), half


def _clean(B):
    """B without what is zero but for the rounding of many digits, in a system whose largest entries are near 1."""
    re, im = (np.where(np.abs(part) > NOTHING * np.abs(B), part, 0.0) for part in (B.real, B.imag))
    return np.where(np.abs(B) > NOTHING, re + 1j * im, 0.0)
