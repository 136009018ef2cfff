"""Matrices of fixed-point numbers: arrays of Python integers a with the value a / 2^bits.

Sums and products of the data are exact before the one rounding to `bits`, so stiff and soft springs may
share a coordinate. A product of n × n matrices costs about 0.1 µs n³: 0.4 ms at n = 16, 6 ms at n = 40.
"""

import math
from collections.abc import Mapping, Sequence
from math import isqrt
from typing import Any

import numpy as np

from vibcli.base.work import counted
from vibcli.numerics.precision import price

DOUBLE = 53
FRACTION = 4096
MILLION = 1_000_000


def mantissa(x: Any) -> tuple[int, int]:
    """(m, e) with x = m 2^e: exactly for a float, an integer or an mpf, to FRACTION bits for a Fraction."""
    if hasattr(x, "_mpf_"):
        sign, man, exp, _ = x._mpf_
        return (-int(man) if sign else int(man)), exp
    if hasattr(x, "denominator"):
        up = FRACTION + x.denominator.bit_length()
        return (x.numerator << up) // x.denominator, -up
    m, e = math.frexp(x)
    return int(m * 9007199254740992.0), e - DOUBLE


def shifted(m: int, by: int) -> int:
    """m 2^by, rounded to the nearest integer."""
    if by >= 0:
        return m << by
    return (m + (1 << (-by - 1))) >> -by


def fixed(x: np.ndarray, bits: int) -> Any:
    """The float array or number x in fixed point."""
    if np.ndim(x) == 0:
        m, e = mantissa(x)
        return shifted(m, e + bits)
    m, e = np.frexp(np.asarray(x, float))
    m, e = (m * 9007199254740992.0).astype(np.int64).ravel().tolist(), e.ravel().tolist()
    out = np.empty(len(m), object)
    out[:] = [shifted(a, b + bits - DOUBLE) for a, b in zip(m, e, strict=True)]
    return out.reshape(np.shape(x))


def to_float(a: int, bits: int) -> float:
    """The value of one fixed-point number as the nearest float, however many digits it has."""
    extra = abs(a).bit_length() - 64
    if extra > 0:
        return math.ldexp(float(a >> extra), extra - bits)
    return math.ldexp(float(a), -bits)


def times_power(x: Any, power: int) -> float:
    """x 2^power as a float, of whatever mantissa() takes."""
    m, e = mantissa(x)
    return to_float(m, -(e + power))


def log2(a: int, bits: int) -> float:
    """log2 |a / 2^bits|, to half a unit; −inf for 0."""
    return abs(a).bit_length() - bits - 0.5 if a else -math.inf


def magnitude(a: int, bits: int) -> float:
    """log2 |a / 2^bits| as a float; −inf for 0."""
    return math.log2(abs(a)) - bits if a else -math.inf


def floats(a: Any, bits: int) -> np.ndarray:
    """The values of an array of fixed-point numbers as floats."""
    if bits < 900:
        try:
            found: np.ndarray = np.ldexp(a.astype(float), -bits)
            return found
        except OverflowError:
            pass
    out = np.array([to_float(x, bits) for x in a.ravel().tolist()], float)
    return out.reshape(a.shape)


def identity(n: int, bits: int) -> np.ndarray:
    """The unit matrix."""
    return np.eye(n, dtype=object) << bits


def count_floats(n: int, many: float = 1) -> None:
    """The steps of the eigenvectors of n × n matrices of floats: a fourth of those of a product of integers."""
    counted(many * n**3 / (4 * MILLION))


def product(a: np.ndarray, b: np.ndarray, bits: int) -> np.ndarray:
    """a b, in groups of rows with a few million products each, which are counted."""
    columns = b.size // len(b) if len(b) else 0
    cost = price(bits) * a.size * columns / MILLION
    if cost <= 1 or a.ndim == 1:
        counted(cost)
        found: np.ndarray = a.dot(b) >> bits
        return found
    rows, parts = max(1, int(len(a) / cost)), []
    for first in range(0, len(a), rows):
        part = a[first:first + rows]
        counted(cost * len(part) / len(a))
        parts.append(part.dot(b) >> bits)
    return np.concatenate(parts)


def assembled(n: int, terms: Sequence[tuple[Any, dict[int, Any]]], matrix: Mapping[tuple[int, int], Any],
              powers: Sequence[int], scale: int, bits: int) -> np.ndarray:
    """2^-scale D (Σ w s sᵀ + matrix) D in fixed point, D = diag(2^powers)."""
    out = [[0] * n for _ in range(n)]
    for weight, row in terms:
        m, e = mantissa(weight)
        entries = [(i, *mantissa(x), powers[i]) for i, x in row.items() if x]
        e += bits - scale
        for i, mi, ei, pi in entries:
            for j, mj, ej, pj in entries:
                if j >= i:
                    value = shifted(m * mi * mj, e + ei + ej + pi + pj)
                    out[i][j] += value
                    if i != j:
                        out[j][i] += value
    for (i, j), x in matrix.items():
        m, e = mantissa(x)
        out[i][j] += shifted(m, e + powers[i] + powers[j] + bits - scale)
    return np.array(out, object).reshape(n, n)


def is_diagonal(a: np.ndarray) -> bool:
    """Whether every entry off the diagonal is exactly zero."""
    n = len(a)
    return not any(a[i, j] for i in range(n) for j in range(n) if i != j)


def cholesky(a: np.ndarray, bits: int) -> tuple[np.ndarray, Any]:
    """Lower triangular L with L Lᵀ = a; None and the first pivot that is not positive or but rounding."""
    n = len(a)
    lower, rest = np.zeros((n, n), object), a.copy()
    for j in range(n):
        if rest[j, j] <= abs(a[j, j]) >> (bits - bits // 3):
            return None, j
        pivot = isqrt(rest[j, j] << bits)
        lower[j, j] = pivot
        if j + 1 < n:
            column = (rest[j + 1:, j] << bits) // pivot
            lower[j + 1:, j] = column
            rest[j + 1:, j + 1:] -= np.multiply.outer(column, column) >> bits
    return lower, None


def forward(lower: np.ndarray, b: np.ndarray, bits: int) -> np.ndarray:
    """L⁻¹ b for a lower triangular L and an array b of columns."""
    x = b.copy()
    for i in range(len(lower)):
        if i:
            x[i] = x[i] - (lower[i, :i].dot(x[:i]) >> bits)
        x[i] = (x[i] << bits) // lower[i, i]
    return x


def backward(lower: np.ndarray, b: np.ndarray, bits: int) -> np.ndarray:
    """L⁻ᵀ b for a lower triangular L and an array b of columns."""
    x = b.copy()
    for i in reversed(range(len(lower))):
        if i + 1 < len(lower):
            x[i] = x[i] - (lower[i + 1:, i].dot(x[i + 1:]) >> bits)
        x[i] = (x[i] << bits) // lower[i, i]
    return x
