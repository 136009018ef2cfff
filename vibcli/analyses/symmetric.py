"""Eigenvalues of a symmetric matrix in fixed point, each with a rigorous bound.

Approximate eigenvectors Q (from floats) bring A to QᵀAQ, QᵀQ ≈ I. With α = diag(QᵀAQ)/diag(QᵀQ) and
H = QᵀAQ − QᵀQ diag(α), A is similar to diag(α) + E, E = (QᵀQ)⁻¹H. Gershgorin discs of a scaled E bound what is
left; if that is too much, Q takes a step of first order in E and the next E is of second order
(Ogita & Aishima 2018). Eigenvalues too close for that are separated by a small dense problem of their own.
"""

import numpy as np

from vibcli.analyses.fixed import fixed, floats, identity

STEPS = 16


class Spectrum:
    """values: fixed-point eigenvalues; radius: floats, |exact − value| <= radius; vectors: fixed point, QᵀQ = I."""

    __slots__ = ("bits", "radius", "values", "vectors")

    def __init__(self, values, radius, vectors, bits):
        self.values, self.radius, self.vectors, self.bits = values, radius, vectors, bits


def spectrum(a, bits, goal, zeros=0, error=0.0, start=None):
    """The eigenpairs of the symmetric fixed-point matrix a, known to `error` in norm.

    Each radius is at most 2^-goal |value| where bits and error allow it. `zeros`: how many eigenvalues are known to
    vanish. `start`: approximate eigenvectors as floats; those of the rounded matrix if absent.
    """
    n = len(a)
    if start is None:
        start = np.linalg.eigh(floats(a, bits))[1]
    q = fixed(start, bits)
    error = error + 4.0 * n * n * 2.0 ** -bits
    previous = np.inf
    for _ in range(STEPS):
        gram = q.T.dot(q) >> bits
        s = q.T.dot(a.dot(q) >> bits) >> bits
        alpha = (s.diagonal() << bits) // gram.diagonal()
        h = s - (gram * alpha >> bits)
        gaps = np.subtract.outer(alpha, alpha)
        off = Offset(floats(h, bits), floats(gram - identity(n, bits), bits), floats(alpha, bits),
                     floats(gaps, bits), zeros, error)
        radius = off.radius()
        worst = off.worst(radius)
        if worst <= 2.0 ** -goal or worst >= previous / 4 and previous < 2.0 ** -40:
            break
        previous = worst
        q = q.dot(step(h, gram, alpha, gaps, off.clusters(), bits)) >> bits
    x = _first_order(h, gram, gaps, off.clusters(), bits)
    return Spectrum(alpha, radius, (q.dot(x) >> bits) if worst > 0 else q, bits)


class Offset:
    """diag(α) + E in floats: how far α is from the eigenvalues."""

    __slots__ = ("alpha", "e", "gap", "near", "scaled", "zero")

    def __init__(self, h, excess, alpha, gap, zeros, error):
        size = np.abs(h)
        self.e = size + 1.1 * np.abs(excess) @ size + error
        self.alpha, self.gap = alpha, np.abs(gap)
        self.zero = np.zeros(len(alpha), bool)
        self.zero[np.argsort(np.abs(alpha), kind="stable")[:zeros]] = True
        least = np.min(np.abs(alpha[~self.zero]), initial=np.inf, where=alpha[~self.zero] != 0)
        root = np.sqrt(np.where(self.zero | (alpha == 0), least if np.isfinite(least) else 1.0, np.abs(alpha)))
        self.scaled = self.e * (root[:, None] / root[None, :])

    def clusters(self):
        """Lists of eigenvalues that first-order steps cannot tell apart."""
        close = self.scaled + self.scaled.T > 0.05 * self.gap
        np.fill_diagonal(close, False)
        return _components(close)

    def radius(self):
        """For each value a distance within which its eigenvalue lies (Gershgorin; Wilkinson 1965, ch. 2)."""
        disc = self.scaled.sum(axis=1)
        own = self.scaled.diagonal()
        with np.errstate(divide="ignore", invalid="ignore"):
            room = (self.gap / 2 - disc[None, :]) / self.scaled.T
        np.fill_diagonal(room, np.inf)
        stretch = room.min(axis=1)
        half = np.where(np.eye(len(disc), dtype=bool), np.inf, self.gap / 2).min(axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            alone = own + (disc - own) / stretch
        isolated = (stretch >= 1) & (alone <= half)
        return np.where(isolated, alone, _union(self.alpha, disc))

    def worst(self, radius):
        """The largest radius relative to its value, those known to be zero set aside."""
        size = np.abs(self.alpha)
        tiny = size + radius <= 1e3 * self.e.min()
        judged = ~self.zero & ~tiny
        if not judged.any():
            return float(self.scaled.max() > 1e-15)
        with np.errstate(divide="ignore"):
            return float((radius / size)[judged].max())


def _union(alpha, disc):
    """How far the union of overlapping discs about the sorted alpha reaches from each."""
    order = np.argsort(alpha, kind="stable")
    out, group, reach = np.empty(len(alpha)), [], -np.inf
    for i in [*order.tolist(), None]:
        if i is None or (group and alpha[i] - disc[i] > reach):
            low = min(alpha[j] - disc[j] for j in group)
            for j in group:
                out[j] = max(reach - alpha[j], alpha[j] - low, disc[j])
            group, reach = [], -np.inf
        if i is not None:
            group.append(i)
            reach = max(reach, alpha[i] + disc[i])
    return out


def _components(close):
    """Connected components of more than one index of a boolean relation."""
    left, out = set(np.flatnonzero(close.any(axis=1)).tolist()), []
    while left:
        stack, part = [left.pop()], []
        while stack:
            i = stack.pop()
            part.append(i)
            reached = left.intersection(np.flatnonzero(close[i]).tolist())
            left -= reached
            stack.extend(reached)
        out.append(sorted(part))
    return out


def _first_order(h, gram, gaps, clusters, bits):
    """I + X, X = E/(αⱼ − αᵢ) between separated eigenvalues, orthonormalising within clusters."""
    n = len(gram)
    one = 1 << bits
    together = np.zeros((n, n), bool)
    for part in clusters:
        together[np.ix_(part, part)] = True
    np.fill_diagonal(together, True)
    x = identity(n, bits)
    for i in range(n):
        for j in range(n):
            if not together[i, j]:
                x[i, j] = (h[i, j] << bits) // -gaps[i, j]
            else:
                x[i, j] -= (gram[i, j] - (one if i == j else 0)) >> 1
    return x


def step(h, gram, alpha, gaps, clusters, bits):
    """The matrix that takes Q to better eigenvectors."""
    x = _first_order(h, gram, gaps, clusters, bits)
    for part in clusters:
        at = np.ix_(part, part)
        block = (h[at] + h[at].T) >> 1
        middle = min(alpha[part].tolist(), key=abs)
        for place, i in enumerate(part):
            block[place, place] = alpha[i] - middle
        size = max(abs(v) for v in block.ravel().tolist()).bit_length()
        if size:
            x[:, part] = x[:, part].dot(fixed(np.linalg.eigh(floats(block, size))[1], bits)) >> bits
    return x
