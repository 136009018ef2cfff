"""Eigenvalues of a symmetric matrix in fixed point, each with a rigorous bound.

Approximate eigenvectors Q (from floats) bring A to QᵀAQ, QᵀQ ≈ I. With α = diag(QᵀAQ)/diag(QᵀQ) and
H = QᵀAQ − QᵀQ diag(α), A is similar to diag(α) + E, E = (QᵀQ)⁻¹H. Gershgorin discs of a scaled E bound what
is left; if that is too much, Q takes a step of first order in E and the next E is of second order
(Ogita & Aishima 2018). Eigenvalues too close for that are separated by a small dense problem of their own.
"""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from vibcli.numerics.components import clusters
from vibcli.numerics.fixed_point import fixed, floats, identity, product

STEPS = 24
LEAST = 1e-300
SMALL = 2.0 ** -16


class Spectrum:
    """Eigenpairs in fixed point, QᵀQ = I.

    |exact − value| <= radius · 2^-shift: a float and a power, so that hundreds of digits fit.
    """

    __slots__ = ("bits", "radius", "shift", "values", "vectors")

    def __init__(self, values: np.ndarray, radius: np.ndarray, shift: int, vectors: np.ndarray, bits: int) -> None:
        self.values, self.radius, self.shift = values, radius, shift
        self.vectors, self.bits = vectors, bits


def spectrum(a: np.ndarray, bits: int, goal: int, zeros: int | None = None, slack: float = 0,
             start: np.ndarray | None = None) -> Spectrum:
    """The eigenpairs of the symmetric fixed-point matrix a, known to 2^(slack − bits) in norm.

    Each radius is at most 2^-goal |value| where bits and slack allow it. `zeros`: how many eigenvalues are
    known to vanish, None where that is not known. `start`: approximate eigenvectors as floats.
    """
    n = len(a)
    if n == 1 and start is None:
        return _of_one(a, bits, max(slack, 0) + 2)
    if start is None:
        start = np.linalg.eigh(floats(a, bits))[1]
    q, one = fixed(start, bits), identity(n, bits)
    slack = max(slack, 0) + 2 + 2 * math.log2(n)
    previous = math.inf
    for _ in range(STEPS):
        gram = product(q.T, q, bits)
        s = product(q.T, product(a, q, bits), bits)
        alpha = (s.diagonal() << bits) // gram.diagonal()
        h = s - (gram * alpha >> bits)
        gaps = np.subtract.outer(alpha, alpha)
        off = Offset(h, gram - one, alpha, gaps, zeros, slack, bits)
        radius = off.radius()
        worst = off.worst(radius)
        rough = off.rough()
        stalled = worst > previous - 4 and rough < -30 and previous < -30
        if (worst <= -goal and rough <= -goal / 2) or stalled:
            break
        previous = worst
        q = product(q, step(h, gram, alpha, gaps, off, bits), bits)
    if rough > -2 * goal:
        q = product(q, _first_order(h, gram, gaps, off, off.clusters(), bits), bits)
    return Spectrum(alpha, radius, off.shift, q, bits)


def _of_one(a: np.ndarray, bits: int, slack: float) -> Spectrum:
    """The Spectrum of a matrix with one entry, which is its eigenvalue but for the slack."""
    shift = bits - max(math.ceil(slack), 1)
    radius = np.array([max(2.0 ** (slack + shift - bits), LEAST)])
    return Spectrum(a.diagonal().copy(), radius, shift, identity(1, bits), bits)


class Offset:
    """diag(α) + 2^-shift E in floats: how far α is from the eigenvalues.

    zero: flags of those known to vanish; still: also of those that may for all that the working precision tells,
    whose vectors are only kept orthonormal.
    """

    __slots__ = ("alpha", "e", "gap", "known", "scaled", "shift", "skew", "still", "zero")

    def __init__(self, h: np.ndarray, excess: np.ndarray, alpha: np.ndarray, gap: np.ndarray, zeros: int | None,
                 slack: float, bits: int) -> None:
        top = max(abs(x) for x in h.ravel().tolist()).bit_length()
        self.shift = bits - max(top, math.ceil(slack), 1)
        size = np.abs(floats(h, bits - self.shift))
        spoiled = np.abs(floats(excess, bits))
        self.skew = max(abs(x) for x in excess.ravel().tolist()).bit_length() - bits
        self.e = size + 1.1 * spoiled @ size + max(2.0 ** (slack + self.shift - bits), LEAST)
        self.alpha, self.gap = floats(alpha, bits), np.abs(floats(gap, bits))
        self.zero, self.known = np.zeros(len(alpha), bool), zeros is not None
        self.zero[np.argsort(np.abs(self.alpha), kind="stable")[:zeros or 0]] = True
        noise = 0.0 if self.known else 2.0 ** (slack + 10 - bits)
        self.still = self.zero | (np.abs(self.alpha) <= noise)
        size = np.maximum(np.abs(self.alpha), max(math.ldexp(self.e.max(), -self.shift), LEAST))
        judged = size[~self.zero]
        root = np.sqrt(np.where(self.zero, judged.min() if len(judged) else 1.0, size))
        self.scaled = self.e * (root[:, None] / root[None, :])

    def clusters(self) -> list[list[int]]:
        """Lists of eigenvalues that first-order steps cannot tell apart, or not without large steps.

        A large step would carry what an eigenvector still holds of much stiffer ones into its neighbours.
        """
        close = np.ldexp(self.scaled + self.scaled.T, -self.shift) > 0.05 * self.gap
        close |= np.ldexp(self.e + self.e.T, -self.shift) > SMALL * self.gap
        close |= self.gap == 0
        close &= ~(self.still[:, None] & self.still[None, :])
        np.fill_diagonal(close, False)
        return clusters(close)

    def radius(self) -> np.ndarray:
        """For each value a distance, over 2^-shift, within which its eigenvalue lies."""
        return radii(self.alpha, self.gap, self.scaled, self.shift)

    def worst(self, radius: np.ndarray) -> float:
        """log2 of the largest radius relative to its value, those known or bound to be zero set aside."""
        size = np.abs(self.alpha)
        if self.known and not self.zero.all():
            with np.errstate(divide="ignore"):
                relative = np.maximum(radius[~self.zero], LEAST) / size[~self.zero]
            found: float = float(np.log2(relative).max()) - self.shift
            return found
        judged = ~self.zero & (size > np.ldexp(1e3 * (self.e.min() + radius), -self.shift))
        undecided = ~self.zero & ~judged & (radius > 1e3 * self.e.min())
        if undecided.any():
            return math.inf
        if not judged.any():
            return -math.inf if self.e.max() < 1e6 * self.e.min() or len(size) == 1 else math.inf
        result: float = float(np.log2(np.maximum(radius[judged] / size[judged], LEAST)).max()) - self.shift
        return result

    def rough(self) -> float:
        """log2 of how far the vectors are from orthonormal eigenvectors."""
        with np.errstate(divide="ignore", invalid="ignore"):
            tilt = self.e / self.gap
        apart = np.ldexp(self.scaled + self.scaled.T, -self.shift) <= 0.05 * self.gap
        apart &= ~(self.still[:, None] & self.still[None, :]) & (self.gap > 0)
        found: float = max(float(self.skew), math.log2(tilt[apart].max(initial=LEAST)) - self.shift)
        return found


def radii(alpha: np.ndarray, gap: np.ndarray, scaled: np.ndarray, shift: int = 0) -> np.ndarray:
    """For each of the values α a distance, over 2^-shift, within which its eigenvalue of diag(α) + 2^-shift E lies.

    Gershgorin's discs of |E|, `scaled` by √|α|; a disc that stays alone while its row is scaled down further
    (Wilkinson 1965, ch. 2) shrinks to second order. gap: |αᵢ − αⱼ|; of complex α without shift.
    """
    disc, own = scaled.sum(axis=1), scaled.diagonal()
    half = gap / 2
    with np.errstate(divide="ignore", over="ignore"):
        room = np.ldexp((half - np.ldexp(disc, -shift)[None, :]) / scaled.T, shift)
    np.fill_diagonal(room, np.inf)
    np.fill_diagonal(half, np.inf)
    stretch = room.min(axis=1)
    alone: np.ndarray = own + (disc - own) / np.maximum(stretch, 1.0)
    isolated = (stretch >= 1) & (np.ldexp(alone, -shift) < half.min(axis=1))
    if isolated.all():
        return alone
    return np.where(isolated, alone, _together(gap, disc) if np.iscomplexobj(alpha) else _union(alpha, disc, shift))


def _together(gap: np.ndarray, disc: np.ndarray) -> np.ndarray:
    """How far overlapping discs in the plane reach from the middle of each."""
    out = disc.copy()
    for part in clusters(gap <= disc[:, None] + disc[None, :]):
        out[part] = 2 * disc[part].sum() - disc[part]
    return out


def _union(alpha: np.ndarray, disc: np.ndarray, shift: int) -> np.ndarray:
    """How far the union of overlapping discs about the sorted values reaches from each."""
    disc = np.ldexp(disc, -shift)
    out, group, reach = np.empty(len(disc)), [], -np.inf
    for i in [*np.argsort(alpha, kind="stable").tolist(), None]:
        if group and (i is None or alpha[i] - disc[i] > reach):
            low = min(alpha[j] - disc[j] for j in group)
            for j in group:
                out[j] = max(reach - alpha[j], alpha[j] - low, disc[j])
            group, reach = [], -np.inf
        if i is not None:
            group.append(i)
            reach = max(reach, alpha[i] + disc[i])
    with np.errstate(over="ignore"):
        return np.ldexp(out, shift)


def _first_order(h: np.ndarray, gram: np.ndarray, gaps: np.ndarray, off: Offset, clusters: Sequence[Any],
                 bits: int) -> np.ndarray:
    """I + X, X = E/(αⱼ − αᵢ) between separated eigenvalues, orthonormalising within clusters."""
    n, one = len(gram), 1 << bits
    together = np.eye(n, dtype=bool) | (off.still[:, None] & off.still[None, :])
    for part in clusters:
        together[np.ix_(part, part)] = True
    safe = np.where(together, one, -gaps)
    x = np.where(together, -(gram >> 1), (h << bits) // safe)
    x[range(n), range(n)] = (3 * one - gram.diagonal()) >> 1
    return x


def step(h: np.ndarray, gram: np.ndarray, alpha: np.ndarray, gaps: np.ndarray, off: Offset, bits: int) -> np.ndarray:
    """The matrix that takes Q to better eigenvectors."""
    clusters = off.clusters()
    x = _first_order(h, gram, gaps, off, clusters, bits)
    for part in clusters:
        at = np.ix_(part, part)
        block = (h[at] + h[at].T) >> 1
        middle = min(alpha[part].tolist(), key=abs)
        for place, i in enumerate(part):
            block[place, place] = alpha[i] - middle
        size = max(abs(v) for v in block.ravel().tolist()).bit_length()
        if size:
            x[:, part] = product(x[:, part], fixed(np.linalg.eigh(floats(block, size))[1], bits), bits)
    return x
