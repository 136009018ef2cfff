"""H(iΩ) by LU of every matrix, rows and columns scaled by powers of two.

A frequency at which the matrix is singular but for rounding is a pole, unless the input does not excite that mode or
the output does not see it: then that mode is left out. With x = D⁻¹b and y = D⁻ᵀc the slope is
dH/ds = c′ᵀx + yᵀ(b′ − D′x) + d′.
"""

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.frequency_response.quadratics import polynomial, slope
from vibcli.numerics.fixed_point import count_floats

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.transfer_function import TransferFunction

SINGULAR = 2.0**-46     # 1/condition of the scaled matrix below which a frequency counts as one of a pole
UNSEEN = 1e-9           # share of b or c along a mode, below which the mode takes no part
BLOCK = 2.0**22         # entries of the matrices that are factored at once


class Direct:
    """By LU of every matrix, in blocks of frequencies."""

    __slots__ = ()

    def __call__(self, system: Any, s: np.ndarray,
                 steep: bool = False) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
        """(H, dH/ds or None, whether there is a pole)."""
        parts = [_block(system, part, steep) for part in _parts(system, s)]
        values, slopes, resonant = zip(*parts, strict=True)
        return np.concatenate(values), np.concatenate(slopes) if steep else None, np.concatenate(resonant)

    def fields(self, system: Any, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(D⁻¹b, D⁻ᵀc), of least squares where D is singular: (N, n) each."""
        parts = [_fields(system, part) for part in _parts(system, s)]
        return np.concatenate([x for x, _ in parts]), np.concatenate([y for _, y in parts])


direct = Direct()


def _parts(system: "TransferFunction", s: np.ndarray) -> list[np.ndarray]:
    size = max(1, int(BLOCK / max(system.n, 1) ** 2))
    return [s[k:k + size] for k in range(0, max(len(s), 1), size)]


def scales(system: Any, s: np.ndarray) -> np.ndarray:
    """Powers of two that bring rows and columns to the size 1: (N, n)."""
    Omega, (diagonals, rows) = np.abs(s)[:, None], system.magnitudes
    size = _summed(diagonals, Omega)
    if not (size > 0).all():
        across = _summed(rows, Omega)
        size = np.where(size > 0, size, np.where(across > 0, across, 1.0))
    found: np.ndarray = np.exp2(-np.round(np.log2(size) / 2))
    return found


def _summed(parts: Sequence[np.ndarray], Omega: np.ndarray) -> np.ndarray:
    found: np.ndarray = parts[0] + Omega * parts[1] + Omega * Omega * parts[2]
    return found


@lru_cache
def probe(n: int) -> np.ndarray:
    """A vector with a part along every mode."""
    found: np.ndarray = 1.0 + 0.5 * np.sin(np.arange(1, n + 1) * 2.399963)
    return found


def _block(system: "TransferFunction", s: np.ndarray, steep: bool) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
    count_floats(system.n, len(s) / 10)
    scale, at = scales(system, s), s[:, None, None]
    D = (system.K + at * system.C + at * at * system.M) * scale[:, :, None] * scale[:, None, :]
    b, c = polynomial(system.b, s) * scale, polynomial(system.c, s) * scale
    right = np.empty((*b.shape, 2), complex)
    right[:, :, 0], right[:, :, 1] = b, probe(system.n)
    x = solutions(D, right)
    suspicious = ~(np.abs(x[:, :, 1]).max(axis=1) * SINGULAR * 64 < 1)
    x = np.where(suspicious[:, None], 0.0, x[:, :, 0])
    values, slopes, resonant = np.einsum("ki,ki->k", c, x), None, np.zeros(len(s), bool)
    if steep:
        y = solutions(D.transpose(0, 2, 1), c[:, :, None])[:, :, 0]
        slopes = along(system, s, x * scale, np.where(suspicious[:, None], 0.0, y) * scale)
    for k in np.flatnonzero(suspicious):
        values[k], resonant[k] = apart_from_poles(D[k], b[k], c[k])
    return values + polynomial(system.d, s), slopes, resonant


def solutions(D: np.ndarray, right: np.ndarray) -> np.ndarray:
    """D⁻¹·right of each frequency, NaN where D is singular."""
    try:
        return np.linalg.solve(D, right)
    except np.linalg.LinAlgError:
        if len(D) == 1:
            return np.full(right.shape, np.nan + 0j)
        half = len(D) // 2
        return np.concatenate([solutions(D[:half], right[:half]), solutions(D[half:], right[half:])])


def repaired(system: Any, s: np.ndarray, values: np.ndarray, slopes: np.ndarray | None, lost: np.ndarray,
             otherwise: Any = direct) -> tuple[np.ndarray, np.ndarray | None, np.ndarray]:
    """(H, dH/ds or None, whether there is a pole), by another method at the frequencies that are lost."""
    resonant = np.zeros(len(s), bool)
    if len(lost):
        values[lost], steep, resonant[lost] = otherwise(system, s[lost], slopes is not None)
        if slopes is not None:
            slopes[lost] = steep
    return values, slopes, resonant


def _fields(system: "TransferFunction", s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    at, b, c = s[:, None, None], polynomial(system.b, s), polynomial(system.c, s)
    D = system.K + at * system.C + at * at * system.M
    if symmetric(system):
        found = _least(D, np.stack([b, c], axis=2))
        return found[:, :, 0], found[:, :, 1]
    return _least(D, b[:, :, None])[:, :, 0], _least(D.transpose(0, 2, 1), c[:, :, None])[:, :, 0]


def _least(D: np.ndarray, right: np.ndarray) -> np.ndarray:
    found = solutions(D, right)
    for k in np.flatnonzero(np.isnan(found).any(axis=(1, 2))):
        found[k] = np.linalg.pinv(D[k]) @ right[k]
    return found


def symmetric(system: Any) -> bool:
    """Is D the same as Dᵀ?"""
    return all((matrix == matrix.T).all() for matrix in (system.K, system.C, system.M))


def along(system: Any, s: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """dH/ds from x = D⁻¹b and y = D⁻ᵀc."""
    moved = x @ system.C.T + 2 * s[:, None] * (x @ system.M.T)
    found: np.ndarray = (np.einsum("ki,ki->k", slope(system.c, s), x) + slope(system.d, s)
                         + np.einsum("ki,ki->k", y, slope(system.b, s) - moved))
    return found


def apart_from_poles(D: np.ndarray, b: np.ndarray, c: np.ndarray) -> tuple[complex, bool]:
    """(cᵀD⁻¹b, False), or (0, True) where D is singular along a mode that b drives and c sees."""
    count_floats(len(D))
    u, size, v = np.linalg.svd(D)
    driven, seen = u.conj().T @ b, c @ v.conj().T
    small = size <= SINGULAR * max(size[0], 1.0)
    takes_part = (np.abs(driven) > UNSEEN * np.linalg.norm(b)) & (np.abs(seen) > UNSEEN * np.linalg.norm(c))
    if takes_part[small].any():
        return 0.0, True
    return np.sum((driven * seen)[~small] / size[~small]), False
