"""Exact sums of functions of time: Σ p(t) e^{r t + r₀} cos(w t + w₀ + q π/2) [t ≥ T] g₁(t) g₂(t) …

A Sum is {(T, gates, wave): p}: T the instant from which a term counts (None: always), gates a tuple of functions that
change from piece to piece (gates.py), wave = (r, w, r₀, w₀, q) and p the coefficients of a polynomial in t from the
constant on. All are rationals, so that nothing cancels wrongly before the terms are counted from the start of a
segment; q keeps sines exact: sin u = cos(u − π/2), sin² + cos² = 1.
"""

from collections.abc import Sequence
from fractions import Fraction
from operator import add
from typing import Any

Exact = Fraction | int
ExactWave = tuple[Exact, Exact, Exact, Exact, int]      # (r, w, r₀, w₀, q)
Waves = dict[ExactWave, tuple[Exact, ...]]
Sum = dict[tuple[Exact | None, tuple[Any, ...], ExactWave], tuple[Exact, ...]]

HALF = Fraction(1, 2)
STILL: ExactWave = (0, 0, 0, 0, 0)
ALWAYS: tuple[None, tuple[Any, ...], ExactWave] = (None, (), STILL)
MOST, STEEPEST = 2000, 60       # terms of a sum, power of t


class TooManyTerms(ArithmeticError):
    """More terms, or higher powers, than can be kept."""


def constant(value: Exact) -> Sum:
    return {ALWAYS: (value,)} if value else {}


def linear(b: Exact, a: Exact) -> Sum:
    """a·t + b."""
    return {ALWAYS: (b, a)} if a else constant(b)


def wave(r: Any, w: Any, r0: Any, w0: Any, q: int, size: Any = 1) -> Sum:
    """size·e^{r t + r0} cos(w t + w0 + q π/2) as a Sum."""
    sign, key = _upright(r, w, r0, w0, q)
    return {(None, (), key): (sign * size,)} if sign and size else {}


def _upright(r: Exact, w: Exact, r0: Exact, w0: Exact, q: int) -> tuple[int, ExactWave]:
    """(sign, wave) of the same cosine with a positive argument and q = 0 or 1."""
    if (w, w0) < (0, 0):
        w, w0, q = -w, -w0, -q
    q %= 4
    sign = -1 if q >= 2 else 1
    if not (w or w0) and q % 2:
        return 0, STILL
    return sign, (r, w, r0, w0, q % 2)


def gate(function: Any) -> Sum:
    """A function that changes from piece to piece, as a Sum."""
    return {(None, (function,), STILL): (1,)}


def since(instant: Exact) -> Sum:
    """1 from an instant on, 0 before; those before t = 0 do not count."""
    return {(instant, (), STILL): (1,)} if instant >= 0 else constant(1)


def added(*parts: tuple[Sum, Exact]) -> Sum:
    """Σ c·Sum of (Sum, c) pairs."""
    found = {}
    for part, c in parts:
        for key, p in part.items():
            _gather(found, key, p, c)
    return found


def _gather(found: dict[Any, tuple[Exact, ...]], key: tuple[Any, ...], p: tuple[Exact, ...], c: Exact = 1) -> None:
    old, new = found.get(key, ()), list(p) if c == 1 else [c * x for x in p]
    total = [*map(add, old, new), *old[len(new):], *new[len(old):]]
    while total and not total[-1]:
        total.pop()
    if total:
        found[key] = tuple(total)
        if len(found) > MOST or len(total) > STEEPEST + 1:
            raise TooManyTerms
    else:
        found.pop(key, None)


def multiplied(left: Sum, right: Sum) -> Sum:
    if len(left) * len(right) > 20 * MOST:
        raise TooManyTerms
    found = {}
    for (T, gates, one), p in left.items():
        for (start, others, other), o in right.items():
            later = T if start is None else start if T is None else max(T, start)
            together = tuple(sorted(gates + others, key=hash)) if others else gates
            product = convolved(p, o)
            for sign, key in _products(one, other):
                _gather(found, (later, together, key), product, sign)
    return found


def convolved(p: Sequence[float | Fraction], o: Sequence[float | Fraction]) -> tuple[Any, ...]:
    """The coefficients of a product of polynomials."""
    if len(o) == 1:
        return tuple(x * o[0] for x in p)
    found: list[Any] = [0] * (len(p) + len(o) - 1)
    for i, x in enumerate(p):
        for j, y in enumerate(o):
            found[i + j] += x * y
    return tuple(found)


def _products(one: ExactWave, other: ExactWave) -> list[tuple[Exact, ExactWave]]:
    """[(factor, wave)]: 2 cos A cos B = cos(A + B) + cos(A − B)."""
    r, w, r0, w0, q = one
    s, v, s0, v0, p = other
    if not (w or w0 or q) or not (v or v0 or p):
        return [(1, (r + s, w + v, r0 + s0, w0 + v0, q + p))]
    found = (_upright(r + s, w + v, r0 + s0, w0 + v0, q + p), _upright(r + s, w - v, r0 + s0, w0 - v0, q - p))
    return [(HALF * sign, key) for sign, key in found if sign]


def raised(base: Sum, power: int) -> Sum:
    """A whole power of a Sum, 1 or more."""
    found = None
    while power:
        if power & 1:
            found = base if found is None else multiplied(found, base)
        power >>= 1
        base = multiplied(base, base) if power else base
    return found


def smooth_pieces(total: Sum) -> list[tuple[Exact | None, Waves]]:
    """[(T, {wave: p})] of a Sum without gates: what it is from each T on; the first T is None."""
    instants = sorted({T for T, _, _ in total if T is not None})
    found = []
    for T in [None, *instants]:
        here = {}
        for (start, _, key), p in total.items():
            if start is None or (T is not None and start <= T):
                _gather(here, key, p)
        found.append((T, here))
    return found


def shifted(p: Sequence[Exact], start: Fraction) -> list[Exact]:
    """The coefficients in τ = t − start of the polynomial p(t), exactly."""
    found = list(p)
    if start:
        for i in range(len(found) - 1):
            for k in range(len(found) - 2, i - 1, -1):
                found[k] += start * found[k + 1]
    return found
