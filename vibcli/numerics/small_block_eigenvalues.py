"""Eigenvalues of a small real block in fixed point: two rows by the quadratic formula, more by mpmath."""

import math
from collections.abc import Sequence

import numpy as np

from vibcli.numerics.fixed_point import floats


def roots_of_block(block: np.ndarray, bits: int, off: float) -> list[tuple[float | np.ndarray, ...]]:
    """(re, im, radius, right, left) for each eigenvalue; of a conjugate pair for that with im > 0.

    re, im are in fixed point; 2^radius bounds what a perturbation of norm 2^off changes; left · right = 1.
    """
    k = len(block)
    if k == 1:
        return [(int(block[0, 0]), 0, off, np.ones(1), np.ones(1))]
    triples = _of_two(block, bits) if k == 2 else _of_many(block, bits)
    own = floats(block, bits)
    values = [complex(*floats(np.array([re, im], object), bits)) for re, im, _ in triples]
    every = values + [value.conjugate() for value in values if value.imag]
    return [(int(re), int(im), _radius(own, value, every, off), right, _left(own, value, right))
            for (re, im, right), value in zip(triples, values, strict=True)]


def _radius(block: np.ndarray, value: complex, every: Sequence[complex], off: float) -> float:
    """log2 of how far a perturbation of norm 2^off can move an eigenvalue of a block.

    An eigenvalue μ of T + E has Π|μ − λᵢ| = |det(μ − T)| <= off |μ − T|^(k−1).
    """
    k = len(block)
    if not math.isfinite(off):
        return off
    size = np.linalg.norm(block - value.real * np.eye(k)) + abs(value.imag)
    size = np.logaddexp2(np.log2(size) if size else -np.inf, off)
    power = off + (k - 1) * (size + 1)
    others = sorted(abs(value - other) for other in every)[1:]
    if all(others):
        near = power - sum(math.log2(x) for x in others) + k - 1
        if near < math.log2(others[0]) - 1:
            found: float = min(power / k, near)
            return found
    result: float = power / k
    return result


def _left(block: np.ndarray, value: complex, right: np.ndarray) -> np.ndarray:
    """The left vector of a block for one eigenvalue, with left · right = 1; NaN at a double root."""
    _, _, vh = np.linalg.svd((block - value * np.eye(len(block))).T)
    left = vh[-1].conj()
    product = left @ right
    return left / product if product else np.full(len(block), np.nan)


def _of_two(block: np.ndarray, bits: int) -> list[tuple[int, int, np.ndarray]]:
    """Roots of λ² − (a + d) λ + ad − bc with their vectors."""
    (a, b), (c, d) = block.tolist()
    middle, half = (a + d) >> 1, (a - d) >> 1
    square = half * half + b * c
    root = math.isqrt(abs(square))
    if square < 0:
        return [(middle, root, _direction(a, b, c, d, middle, root, bits))]
    ends = middle + root, middle - root
    return [(end, 0, _direction(a, b, c, d, end, 0, bits)) for end in ends]


def _direction(a: int, b: int, c: int, d: int, re: int, im: int, bits: int) -> np.ndarray:
    """A null vector of [[a − λ, b], [c, d − λ]]: the better determined of two."""
    upper = floats(np.array([b, re - a, im], object), bits)
    lower = floats(np.array([re - d, im, c], object), bits)
    choices = np.array([[upper[0], upper[1] + 1j * upper[2]], [lower[0] + 1j * lower[1], lower[2]]])
    best = choices[int(np.argmax(np.abs(choices).sum(axis=1)))]
    if not best.any():
        return np.array([1.0, 0.0])
    best = best / np.abs(best).max()
    found: np.ndarray = best if im else best.real
    return found


def _of_many(block: np.ndarray, bits: int) -> list[tuple[int, int, np.ndarray]]:
    """Eigenvalues and vectors of more than two rows at the precision of the block."""
    import mpmath

    k, out = len(block), []
    with mpmath.workprec(bits + 64):
        rows = [[mpmath.ldexp(mpmath.mpf(x), -bits) for x in row] for row in block.tolist()]
        matrix = mpmath.matrix(rows)
        values, vectors = mpmath.eig(matrix)
        for place, value in enumerate(map(mpmath.mpc, values)):
            real = abs(value.imag) <= mpmath.ldexp(abs(value), -(bits // (2 * k)))
            if real or value.imag > 0:
                right = np.array([complex(vectors[i, place]) for i in range(k)])
                right = right / right[int(np.argmax(np.abs(right)))]
                re, im = (int(mpmath.nint(mpmath.ldexp(part, bits))) for part in (value.real, value.imag))
                out.append((re, 0 if real else im, right.real if real else right))
    return out
