"""Eigenvalues of a real matrix in fixed point through a block diagonal form, each with a bound.

A V = V (T + E) with T of small blocks: one for each real eigenvalue, each conjugate pair, and each group
whose eigenvectors nearly coincide, as at critical damping (Bavely & Stewart 1979). V, T and the residual are
in fixed point, V⁻¹ in floats; each step removes some fifty bits of E.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import combinations
from typing import Any

import numpy as np

from vibcli.numerics.components import clusters
from vibcli.numerics.fixed_point import count_floats, fixed, floats, product
from vibcli.numerics.small_block_eigenvalues import roots_of_block

PARALLEL = 1e4
STALLED = 3
LARGE, ALIKE = 2.0 ** -16, 2.0 ** 10


class Root:
    """An eigenvalue re + i im in fixed point, |exact − value| <= 2^radius; its vectors in floats.

    Of a conjugate pair the one with im > 0; left · right = 1.
    """

    __slots__ = ("im", "left", "radius", "re", "right")

    def __init__(self, re: Any, im: Any, radius: Any, right: np.ndarray, left: np.ndarray) -> None:
        self.re, self.im, self.radius, self.right, self.left = re, im, radius, right, left


def eigenvalues(apply: Callable[[np.ndarray], np.ndarray], matrix: np.ndarray, bits: int,
                enough: Callable[[Root], bool], noise: float) -> list[Root]:
    """All eigenvalues of A as a list of Root.

    apply(V): A V in fixed point; matrix: A in floats; enough(root): whether it is known well enough; noise:
    log2 of a bound of what is not known of A.
    """
    form, norms = block_diagonal(apply, matrix, bits, enough, noise)
    return form.all_roots(norms)


def block_diagonal(apply: Callable[[np.ndarray], np.ndarray], matrix: np.ndarray, bits: int,
                   enough: Callable[[Root], bool], noise: float) -> "tuple[BlockForm, list[float]]":
    """The BlockForm of A, and for each of its blocks log2 of what bounds its rows of E."""
    form = BlockForm(matrix, bits)
    best, stalled = math.inf, 0
    for _ in range(20 + bits // 30):
        form.measure(apply)
        norms = form.unknown(noise)
        stalled = stalled + 1 if max(norms) > best - 1 else 0
        best = min(best, max(norms))
        glance = all(len(part) <= 2 for part in form.blocks)
        if stalled > STALLED or (glance and all(map(enough, form.all_roots(norms)))):
            break
        form.improve()
    return form, norms


class BlockForm:
    """V, T in fixed point, the blocks as arrays of indices; V⁻¹ and 2^shift E in floats."""

    __slots__ = ("bits", "blocks", "e", "inverse", "shift", "t", "v", "vf")

    def __init__(self, matrix: np.ndarray, bits: int) -> None:
        rotation, self.blocks = split(matrix)
        self.bits, self.v = bits, fixed(rotation, bits)
        self.t = fixed(np.linalg.inv(rotation) @ matrix @ rotation, bits)
        self._keep_blocks()

    def _keep_blocks(self) -> None:
        t, self.t = self.t, self.t - self.t
        for part in self.blocks:
            at = np.ix_(part, part)
            self.t[at] = t[at]

    def measure(self, apply: Callable[[np.ndarray], np.ndarray]) -> None:
        """E = V⁻¹(A V − V T)."""
        residual = apply(self.v)
        for part in self.blocks:
            residual[:, part] -= product(self.v[:, part], self.t[np.ix_(part, part)], self.bits)
        top = max(abs(x) for x in residual.ravel().tolist()).bit_length()
        self.shift = self.bits - max(top, 1)
        self.vf = floats(self.v, self.bits)
        self.inverse = np.linalg.inv(self.vf)
        self.e = self.inverse @ floats(residual, self.bits - self.shift)

    def unknown(self, noise: float) -> list[float]:
        """For each block log2 of a bound of its rows of E, with the errors of V⁻¹ and the noise in them."""
        n, inverse, v = len(self.e), np.abs(self.inverse), np.abs(self.vf)
        wrong = np.abs(self.inverse @ self.vf - np.eye(n)) + (n + 2) * 2.0 ** -53 * (inverse @ v)
        if wrong.sum(axis=1).max() >= 0.5:
            return [math.inf] * len(self.blocks)
        size = np.abs(self.e)
        more = wrong @ size
        rows = (size + 2 * more + 2 * wrong @ more).sum(axis=1)
        spread = 2 * math.log2(n) + max(noise, 8 - self.bits)
        with np.errstate(divide="ignore"):
            rows = np.logaddexp2(np.log2(rows) - self.shift, np.log2(inverse.sum(axis=1)) + spread)
        return [float(rows[part].max()) + math.log2(len(part)) / 2 for part in self.blocks]

    def all_roots(self, norms: Sequence[float]) -> list[Root]:
        """The eigenvalues of all blocks, moved by no more than 2^norms."""
        return [root for part, off in zip(self.blocks, norms, strict=True) for root in self.roots(part, off)]

    def roots(self, part: np.ndarray, off: float) -> list[Root]:
        """The eigenvalues of one block of T; 2^off, the norm of E in its rows, bounds what can move them."""
        block = self.t[np.ix_(part, part)]
        return [Root(re, im, radius, self.vf[:, part] @ right, left @ self.inverse[part])
                for re, im, radius, right, left in roots_of_block(block, self.bits, off)]

    def improve(self) -> None:
        """A step of first order: V(I + X), T + diag E; blocks it cannot separate are joined and split anew."""
        blocks, bits = self.blocks, self.bits
        t = floats(self.t, bits)
        x, close = separation(t, blocks, self.e, self.shift, largest_steps(t, blocks))
        joined = clusters(close)
        for group in joined:
            part = np.concatenate([blocks[i] for i in group])
            x[np.ix_(part, part)] = 0.0
        taken = {i for group in joined for i in group}
        kept = [part for i, part in enumerate(blocks) if i not in taken]
        merged = [np.concatenate([blocks[i] for i in group]) for group in joined]
        for part in kept + merged:
            at = np.ix_(part, part)
            self.t[at] += fixed(self.e[at], bits - self.shift)
        self.v = self.v + fixed(self.vf @ x, bits - self.shift)
        self.blocks = kept + [piece for part in merged for piece in self._split_again(part)]
        self._keep_blocks()

    def _split_again(self, part: np.ndarray) -> list[np.ndarray]:
        """Splits a joined block, now that its own entries are known to their own precision."""
        bits, at, k = self.bits, np.ix_(part, part), range(len(part))
        block = self.t[at]
        middle = sum(block.diagonal().tolist()) // len(part)
        block[k, k] -= middle
        size = max(abs(v) for v in block.ravel().tolist()).bit_length()
        if not size:
            return [part]
        own = floats(block, size)
        turn, pieces = split(own)
        own = np.linalg.inv(turn) @ own @ turn
        rounding = np.full_like(own, 2.0 ** -48 * np.abs(own).max())
        largest = np.full((len(pieces), len(pieces)), 0.05)
        if len(pieces) == 1 or separation(own, pieces, rounding, 0, largest)[1].any():
            return [part]
        self.v[:, part] = product(self.v[:, part], fixed(turn, bits), bits)
        new = fixed(own, size)
        new[k, k] += middle
        self.t[at] = new
        return [part[piece] for piece in pieces]


def split(matrix: np.ndarray) -> tuple[np.ndarray, list[np.ndarray]]:
    """A real basis R of invariant subspaces of a float matrix, and their index sets."""
    count_floats(len(matrix))
    values, vectors = np.linalg.eig(matrix)
    units = []
    for i, value in enumerate(values):
        if value.imag >= 0:
            v = vectors[:, i]
            columns = np.stack([v.real, v.imag], axis=1) if value.imag > 0 else v.real[:, None]
            units.append(([complex(value)], np.linalg.qr(columns)[0]))
    while True:
        r = np.concatenate([basis for _, basis in units], axis=1)
        edges = np.cumsum([basis.shape[1] for _, basis in units])
        blocks = np.split(np.arange(len(r)), edges[:-1])
        try:
            steep = np.abs(np.linalg.inv(r)).max(axis=1)
        except np.linalg.LinAlgError:
            steep = np.full(len(r), np.inf)
        pair = _closest(units, [i for i, part in enumerate(blocks) if not steep[part].max() < PARALLEL])
        if pair is None:
            return r, blocks
        i, j = pair
        basis = np.linalg.qr(np.concatenate([units[i][1], units[j][1]], axis=1))[0]
        units[i] = (units[i][0] + units[j][0], basis)
        del units[j]


def _closest(units: Sequence[tuple[list[complex], np.ndarray]], steep: Iterable[int]) -> tuple[int, int] | None:
    """Those two of the nearly parallel units whose eigenvalues are closest, or None."""
    def gap(pair: "tuple[int, int]") -> float:
        some, others = (units[i][0] for i in pair)
        return min(min(abs(a - b), abs(a - b.conjugate())) for a in some for b in others)

    return min(combinations(steep, 2), key=gap, default=None)


def largest_steps(t: np.ndarray, blocks: Sequence[np.ndarray]) -> np.ndarray:
    """For each pair of blocks the largest step to be taken between them.

    Small between eigenvalues of one size: a step would carry what their vectors still hold of much stiffer ones
    from one to the other.
    """
    size = np.array([np.abs(t[np.ix_(part, part)]).max() for part in blocks])
    alike = np.maximum.outer(size, size) <= ALIKE * np.minimum.outer(size, size)
    return np.where(alike, LARGE, 0.05)


def separation(t: np.ndarray, blocks: Sequence[np.ndarray], e: np.ndarray, shift: int,
               limit: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """X with T X − X T = −E between blocks, and which pairs of blocks have one larger than `limit`, an array."""
    x, close = np.zeros_like(e), np.zeros((len(blocks), len(blocks)), bool)
    sizes = {}
    for i, part in enumerate(blocks):
        sizes.setdefault(len(part), []).append(i)
    for first in sizes.values():
        for second in sizes.values():
            a, b = np.array([blocks[i] for i in first]), np.array([blocks[j] for j in second])
            rows, columns = a[:, None, :, None], b[None, :, None, :]
            own, other = t[a[:, :, None], a[:, None, :]], t[b[:, :, None], b[:, None, :]]
            part = _sylvester(own, other, e[rows, columns])
            far = np.ldexp(np.abs(part).max(axis=(2, 3)), -shift) > limit[np.ix_(first, second)]
            far |= ~np.isfinite(part).all(axis=(2, 3))
            far &= np.array(first)[:, None] != np.array(second)[None, :]
            close[np.ix_(first, second)] |= far
            part = np.where(np.isfinite(part), part, 0.0)
            x[np.broadcast_to(rows, part.shape), np.broadcast_to(columns, part.shape)] = part
    for i, part in enumerate(blocks):
        x[np.ix_(part, part)] = 0.0
        close[i, i] = False
    return x, close | close.T


def _sylvester(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """X with a X − X b = −c, for stacks a (r, p, p), b (s, q, q), c (r, s, p, q); NaN where singular."""
    p, q = a.shape[1], b.shape[1]
    if p == q == 1:
        with np.errstate(divide="ignore", invalid="ignore"):
            found: np.ndarray = c / (b[None, :] - a[:, None])
            return found
    left = np.einsum("rij,kl->rikjl", a, np.eye(q)).reshape(len(a), 1, p * q, p * q)
    right = np.einsum("ij,slk->sikjl", np.eye(p), b).reshape(1, len(b), p * q, p * q)
    system = left - right
    scale = np.abs(system).max(axis=(2, 3), keepdims=True)
    system = system / np.where(scale > 0, scale, 1.0)
    bad = np.abs(np.linalg.det(system)) < 1e-250
    system[bad] = np.eye(p * q)
    out = np.linalg.solve(system, -(c / np.where(scale > 0, scale, 1.0)).reshape(*c.shape[:2], p * q, 1))
    out[bad] = np.nan
    return out.reshape(c.shape)
