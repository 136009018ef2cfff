"""How many rigid-body motions a set of springs leaves free: n less the rank of the unscaled rows ∇s.

Stiffness plays no part in it. Rows of rational numbers are eliminated modulo two large primes: a rank could
come out too small by chance only, with odds of n²/2^120. Rows that are not rational carry rounding and count as
dependent where what is left of them by complete pivoting is below 1e-14 n.
"""

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from vibcli.analyses.modal.scaling import exponent

PRIMES = (1 << 61) - 1, (1 << 59) - 55
MANY = 200


def undamped_rigid(elements: Any, zeros: int | None, data: Any) -> int | None:
    """How many of the `zeros` rigid motions no damper resists; None where the structure does not tell.

    data: the elements in the arithmetic that decides about rows which are not rational.
    """
    pushed = any(c < 0 for c, _ in elements.dampers)
    if zeros is None or pushed or any(elements.C.values()) or any(elements.G.values()):
        return None
    if not zeros:
        return 0
    rows = [row for k, row in data.springs if k] + [row for c, row in data.dampers if c]
    rational = all(isinstance(x, (int, Fraction)) for row in rows for x in row.values())
    found: int | None = elements.n - rank(elements.n, rows, rows if rational else None)
    return found


def rank(n: int, rows: Sequence[dict[int, float]], exact_rows: Sequence[dict[int, Fraction]] | None = None) -> int:
    """The rank of sparse rows {coordinate: component}; exact_rows: the same as Fractions where they are rational."""
    known: Sequence[dict[int, Any]] = rows if exact_rows is None else exact_rows
    if all(_is_difference(row) for row in known):
        return n - _floating_components(n, known)
    if exact_rows is not None:
        return max(_rank_modulo(known, prime) for prime in PRIMES)
    return _rank_of_floats(n, rows)


def _is_difference(row: Mapping[int, float | Fraction]) -> bool:
    """Whether a row is a(qᵢ − qⱼ), a qᵢ, or nothing."""
    parts = [x for x in row.values() if x]
    return len(parts) < 2 or (len(parts) == 2 and parts[0] == -parts[1])


def _floating_components(n: int, rows: Sequence[dict[int, float | Fraction]]) -> int:
    """How many connected parts of the coordinates no row ties to the ground."""
    head, count = list(range(n + 1)), n
    for row in rows:
        ends = [i for i, x in row.items() if x]
        if ends:
            i, j = _head(head, ends[0]), _head(head, ends[1] if len(ends) == 2 else n)
            head[i] = j
            count -= i != j
    return count


def _head(head: list[int], i: int) -> int:
    """The one that stands for the part of i, the way there halved (Tarjan & van Leeuwen 1984)."""
    while head[i] != i:
        head[i] = i = head[head[i]]
    return i


def _rank_modulo(rows: Sequence[dict[int, Fraction | int]], prime: int) -> int:
    """Rank over the integers modulo a prime, sparse, the shortest row first; never more than the rank."""
    pivots = {}
    for row in sorted(rows, key=len):
        rest, cleared = {}, math.lcm(*(x.denominator for x in row.values()))
        for i, x in row.items():
            value = x.numerator * cleared // x.denominator % prime
            if value:
                rest[i] = value
        while rest:
            lead = min(rest)
            if lead not in pivots:
                scale = pow(rest[lead], -1, prime)
                pivots[lead] = {i: x * scale % prime for i, x in rest.items()}
                break
            factor = rest[lead]
            for i, x in pivots[lead].items():
                value = (rest.get(i, 0) - factor * x) % prime
                if value:
                    rest[i] = value
                else:
                    rest.pop(i, None)
    return len(pivots)


def _rank_of_floats(n: int, rows: Sequence[dict[int, float]]) -> int:
    """Rank of rows with rounding in their components, by Gaussian elimination with complete pivoting."""
    a = np.zeros((len(rows), n))
    for place, row in enumerate(rows):
        top = max((exponent(x) for x in row.values() if x), default=0)
        for i, x in row.items():
            a[place, i] = float(np.ldexp(float(x), -top)) if x else 0.0
    for axis in (0, 1, 0, 1):
        size = np.abs(a).max(axis=1 - axis, initial=0.0, keepdims=True)
        a = a / np.where(size > 0, 2.0 ** np.round(np.log2(np.where(size > 0, size, 1.0))), 1.0)
    if n > MANY:
        return int(np.linalg.matrix_rank(a, tol=1e-14 * n))
    found, limit = 0, 1e-14 * n
    while found < min(a.shape):
        at = np.argmax(np.abs(a[found:, found:]))
        i, j = divmod(int(at), n - found)
        i, j = i + found, j + found
        if abs(a[i, j]) <= limit:
            break
        a[[found, i]] = a[[i, found]]
        a[:, [found, j]] = a[:, [j, found]]
        factor = a[found + 1:, found] / a[found, found]
        a[found + 1:, found:] -= np.multiply.outer(factor, a[found, found:])
        found += 1
    return found
