"""Eigenvalues of a real matrix in fixed point through a block diagonal form, each with a bound.

A V = V (T + E) with T of small blocks: one for each real eigenvalue, each conjugate pair, and each group whose
eigenvectors nearly coincide, as at critical damping (Bavely & Stewart 1979). V, T and the residual are in fixed
point, V⁻¹ in floats; each step removes some fifty bits of E. The eigenvalues of a 2 × 2 block are then
those of a quadratic equation, and a double root is an ordinary case.
"""

import math

import numpy as np

from vibcli.analyses.fixed import fixed, floats

STEPS = 40
PARALLEL = 1e4


class Root:
    """An eigenvalue re + i im in fixed point, |exact − value| <= radius, with right and left vectors in floats."""

    __slots__ = ("im", "left", "radius", "re", "vector")

    def __init__(self, re, im, radius, vector, left):
        self.re, self.im, self.radius, self.vector, self.left = re, im, radius, vector, left


class BlockForm:
    """V, T in fixed point, the blocks as arrays of indices, V⁻¹ and E in floats, the norm of E by rows of blocks."""

    __slots__ = ("bits", "blocks", "e", "inverse", "t", "v", "vf")

    def __init__(self, v, t, blocks, bits):
        self.v, self.t, self.blocks, self.bits = v, t, blocks, bits

    def measure(self, apply, noise):
        """Fills in E = V⁻¹(A V − V T), with all that is not known of it added."""
        residual = apply(self.v)
        for part in self.blocks:
            residual[:, part] -= self.v[:, part].dot(self.t[np.ix_(part, part)]) >> self.bits
        self.vf = floats(self.v, self.bits)
        self.inverse = np.linalg.inv(self.vf)
        n = len(self.vf)
        e = self.inverse @ floats(residual, self.bits)
        wide = np.abs(self.inverse) @ np.abs(self.vf)
        wrong = np.abs(self.inverse @ self.vf - np.eye(n)) + (n + 2) * 2.0 ** -53 * wide
        self.e = e
        return wrong, np.abs(self.inverse).sum(axis=1) * noise

    def off_norms(self, wrong, noise):
        """For each block a bound of the norm of its rows of E, or inf where V⁻¹ is not known well enough."""
        size = np.abs(self.e)
        if np.abs(wrong).sum(axis=1).max() >= 0.5:
            return [math.inf] * len(self.blocks)
        size = size + 2 * wrong @ size + wrong @ (wrong @ size) * 2 + noise[:, None]
        return [float(size[part].sum(axis=1).max()) * math.sqrt(len(part)) for part in self.blocks]


def roots(apply, matrix, bits, enough, noise):
    """All eigenvalues of A as a list of Root; of a conjugate pair that with im > 0.

    apply(V): A V in fixed point; matrix: A in floats; enough(re, im, radius): whether an eigenvalue is known
    well enough; noise: a bound of the norm of what is not known of A.
    """
    rotation, blocks = split(matrix)
    t = np.linalg.inv(rotation) @ matrix @ rotation
    form = BlockForm(fixed(rotation, bits), _only_blocks(fixed(t, bits), blocks), blocks, bits)
    best, stalled = math.inf, 0
    for _ in range(STEPS):
        wrong, unknown = form.measure(apply, noise)
        norms = form.off_norms(wrong, unknown)
        found = [root for part, off in zip(form.blocks, norms, strict=True) for root in _of_block(form, part, off)]
        if all(enough(root.re, root.im, root.radius) for root in found):
            break
        total = max(norms)
        stalled = stalled + 1 if total > best / 2 else 0
        best = min(best, total)
        if stalled > 4:
            break
        _improve(form)
    return found


def split(matrix):
    """A real basis R of invariant subspaces of a float matrix and their index sets; R⁻¹ A R ≈ block diagonal."""
    values, vectors = np.linalg.eig(matrix)
    units = []
    for i, value in enumerate(values):
        if value.imag >= 0:
            v = vectors[:, i]
            columns = np.stack([v.real, v.imag], axis=1) if value.imag > 0 else v.real[:, None]
            units.append([[complex(value)], columns])
    while True:
        basis = [np.linalg.qr(columns)[0] for _, columns in units]
        r = np.concatenate(basis, axis=1)
        edges = np.cumsum([0] + [b.shape[1] for b in basis])
        blocks = [np.arange(a, b) for a, b in zip(edges[:-1], edges[1:], strict=True)]
        try:
            steep = np.linalg.norm(np.linalg.inv(r), axis=1)
        except np.linalg.LinAlgError:
            steep = np.full(len(r), np.inf)
        worst = [float(steep[part].max()) for part in blocks]
        pair = _closest(units, worst)
        if pair is None:
            return r, blocks
        i, j = pair
        units[i] = [units[i][0] + units[j][0], np.concatenate([basis[i], basis[j]], axis=1)]
        del units[j]


def _closest(units, worst):
    """The two nearly parallel units whose eigenvalues are closest, or None."""
    bad = [i for i, w in enumerate(worst) if not w < PARALLEL]
    best, pair = math.inf, None
    for place, i in enumerate(bad):
        for j in bad[place + 1:]:
            gap = min(min(abs(a - b), abs(a - b.conjugate())) for a in units[i][0] for b in units[j][0])
            if gap < best:
                best, pair = gap, (i, j)
    return pair


def _only_blocks(t, blocks):
    out = t - t
    for part in blocks:
        out[np.ix_(part, part)] = t[np.ix_(part, part)]
    return out


def _improve(form):
    """One step of first order: V(I + X), T + diag E; blocks that it cannot separate are joined and split anew."""
    e, blocks, bits = form.e, form.blocks, form.bits
    tf = floats(form.t, bits)
    x, close = np.zeros_like(e), np.zeros((len(blocks), len(blocks)), bool)
    for i, p in enumerate(blocks):
        for j, q in enumerate(blocks):
            if i != j:
                part = _sylvester(tf[np.ix_(p, p)], tf[np.ix_(q, q)], e[np.ix_(p, q)])
                if part is None or np.abs(part).max() > 0.05:
                    close[i, j] = close[j, i] = True
                else:
                    x[np.ix_(p, q)] = part
    from vibcli.analyses.symmetric import components

    joined = components(close)
    for group in joined:
        for i in group:
            for j in group:
                x[np.ix_(blocks[i], blocks[j])] = 0.0
    taken = {i for group in joined for i in group}
    kept = [part for i, part in enumerate(blocks) if i not in taken]
    merged = [np.concatenate([blocks[i] for i in group]) for group in joined]
    for part in kept + merged:
        at = np.ix_(part, part)
        form.t[at] += fixed(e[at], bits)
    form.v = form.v + fixed(form.vf @ x, bits)
    form.blocks = kept
    for part in merged:
        form.blocks = form.blocks + _separated(form, part)
    form.t = _only_blocks(form.t, form.blocks)


def _separated(form, part):
    """Splits a joined block again, now that its own entries are known to their own precision."""
    bits, at = form.bits, np.ix_(part, part)
    if len(part) <= 2 and False:
        return [part]
    block = form.t[at]
    middle = sum(block.diagonal().tolist()) // len(part)
    rest = block.copy()
    rest[range(len(part)), range(len(part))] -= middle
    size = max(abs(v) for v in rest.ravel().tolist()).bit_length()
    if not size:
        return [part]
    f = floats(rest, size)
    r, pieces = split(f)
    if len(pieces) == 1:
        return [part]
    t = np.linalg.inv(r) @ f @ r
    form.v[:, part] = form.v[:, part].dot(fixed(r, bits)) >> bits
    new = fixed(t, size)
    new[range(len(part)), range(len(part))] += middle
    form.t[at] = new
    return [part[piece] for piece in pieces]


def _sylvester(a, b, c):
    """X with a X − X b = −c for blocks of a few rows; None where a and b share an eigenvalue."""
    p, q = c.shape
    if p == q == 1:
        gap = b[0, 0] - a[0, 0]
        return c / gap if gap else None
    system = np.kron(a, np.eye(q)) - np.kron(np.eye(p), b.T)
    try:
        return np.linalg.solve(system, -c.ravel()).reshape(p, q)
    except np.linalg.LinAlgError:
        return None


def _of_block(form, part, off):
    """The eigenvalues of one block of T with the effect of `off`, the norm of E in its rows."""
    bits = form.bits
    block = form.t[np.ix_(part, part)]
    if len(part) == 1:
        pairs = [(block[0, 0], 0, np.ones(1))]
    elif len(part) == 2:
        pairs = _of_two(block, bits)
    else:
        pairs = _of_many(block, bits)
    values = [complex(*floats(np.array([re, im], object), bits)) for re, im, _ in pairs]
    values += [value.conjugate() for value in values if value.imag]
    tf = floats(block, bits)
    out = []
    for re, im, p in pairs:
        value = complex(*floats(np.array([re, im], object), bits))
        radius = _radius(tf, value, values, off)
        right = form.vf[:, part] @ p
        left = _left(tf, value, p) @ form.inverse[part]
        out.append(Root(int(re), int(im), radius, right, left))
    return out


def _radius(block, value, values, off):
    """How far a perturbation of norm `off` can move an eigenvalue of a small block.

    From det(λ − T) <= off · |λ − T|^(k−1) for an eigenvalue λ of T + E.
    """
    k = len(block)
    if k == 1 or not math.isfinite(off):
        return off
    size = np.linalg.norm(block - value.real * np.eye(k)) + abs(value.imag) + off
    others = sorted(abs(value - other) for other in values)[1:]
    power = off * size ** (k - 1) * 2 ** (k - 1)
    far = power ** (1 / k)
    apart = math.prod(others)
    if apart and power / apart * 2 ** (k - 1) < 0.5 * others[0]:
        return min(far, power / apart * 2 ** (k - 1))
    return far


def _left(block, value, p):
    """The left vector of a block belonging to `value`, with left · p = 1, where there is one."""
    k = len(block)
    if k == 1:
        return np.ones(1)
    _, _, vh = np.linalg.svd((block - value * np.eye(k)).T)
    y = vh[-1].conj()
    scale = y @ p
    return y / scale if abs(scale) > 1e-300 else y * np.inf


def _of_two(block, bits):
    """Roots of λ² − (a + d) λ + ad − bc, with their vectors in the block; of a pair the upper one."""
    (a, b), (c, d) = block.tolist()
    middle, half = (a + d) >> 1, (a - d) >> 1
    square = half * half + b * c
    root = math.isqrt(abs(square))
    if square < 0:
        return [(middle, root, _direction(a, b, c, d, middle, root, bits))]
    return [(middle + sign * root, 0, _direction(a, b, c, d, middle + sign * root, 0, bits)) for sign in (1, -1)]


def _direction(a, b, c, d, re, im, bits):
    """A null vector of [[a − λ, b], [c, d − λ]]: the better determined of two."""
    first = floats(np.array([b, re - a, im], object), bits)
    second = floats(np.array([re - d, im, c], object), bits)
    first = np.array([first[0], first[1] + 1j * first[2]])
    second = np.array([second[0] + 1j * second[1], second[2]])
    best = first if np.linalg.norm(first) >= np.linalg.norm(second) else second
    size = np.linalg.norm(best)
    if not size:
        return np.array([1.0, 0.0])
    return best / size if im else (best / size).real


def _of_many(block, bits):
    """Eigenvalues and vectors of a block of more than two rows, by mpmath at the precision of the block."""
    import mpmath

    k = len(block)
    with mpmath.workprec(bits + 64):
        matrix = mpmath.matrix(k, k)
        for i in range(k):
            for j in range(k):
                matrix[i, j] = mpmath.ldexp(mpmath.mpf(int(block[i, j])), -bits)
        values, vectors = mpmath.eig(matrix)
        limit = mpmath.ldexp(1, -bits // (2 * k))
        out = []
        for place, value in enumerate(values):
            value = mpmath.mpc(value)
            real = abs(value.imag) <= limit * abs(value) * mpmath.ldexp(1, -40)
            if real or value.imag > 0:
                p = np.array([complex(vectors[i, place]) for i in range(k)])
                re = int(mpmath.nint(mpmath.ldexp(value.real, bits)))
                im = 0 if real else int(mpmath.nint(mpmath.ldexp(value.imag, bits)))
                out.append((re, im, p.real if real and np.abs(p.real).max() > 0 else p))
    return out
