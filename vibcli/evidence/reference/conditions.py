"""Numbers that conditions determine, to many digits, from what floats know of them: Newton's method,

    p ← p − J⁻¹ F(p),   F = L − R,   J = ∂F/∂p by differences,      |δp| ≤ |J⁻¹| (|F| + e),

where F is known to e."""

from collections.abc import Callable, Sequence
from typing import Any

import mpmath

from vibcli.base.named_tuple import NamedTuple
from vibcli.evidence.reference.settled import DIGITS, DoesNotSettle, TrueValues

WORKING, STEP = 60, 1e-20      # digits; a difference, of a number
STEPS, LEAST = 4, 24            # of the method; digits that are to be found


class Residual(NamedTuple):
    """L − R of each condition, and the bounds of what it is known to."""

    values: list[Any]
    errors: list[Any]


def determined(residual: Callable[..., Residual], near: Sequence[Any]) -> TrueValues:
    """The numbers at which all conditions hold, next to these."""
    with mpmath.workdps(WORKING):
        p = [mpmath.mpf(x) for x in near]
        here = residual(p)
        inverse = _inverse(residual, p, here)
        for _ in range(STEPS):
            p = [x - step for x, step in zip(p, inverse * mpmath.matrix(here.values), strict=True)]
            here = residual(p)
            off = _off(inverse, here)
            digits = min([DIGITS, *(int(-mpmath.log10(e / abs(x))) for e, x in zip(off, p, strict=True) if e)])
            if digits >= DIGITS - 3 or all(abs(f) <= e for f, e in zip(here.values, here.errors, strict=True)):
                break
    if digits < LEAST:
        raise DoesNotSettle("the reference does not settle: Newton's method does not end at what the conditions "
                            "determine", "leave this quantity out of the comparison")
    return TrueValues(p, digits, WORKING, WORKING)


def _inverse(residual: Callable[..., Residual], p: list[mpmath.mpf], here: Residual) -> mpmath.matrix:
    """J⁻¹"""
    J = mpmath.zeros(len(here.values), len(p))
    for j, x in enumerate(p):
        h = mpmath.mpf(STEP) * (abs(x) or 1)
        moved = residual([*p[:j], x + h, *p[j + 1:]])
        for i, (there, f) in enumerate(zip(moved.values, here.values, strict=True)):
            J[i, j] = (there - f) / h
    try:
        return J**-1
    except (ZeroDivisionError, ValueError):
        raise DoesNotSettle("the reference does not settle: the conditions only touch what they determine, or there "
                            "are more of them than numbers", "leave this quantity out of the comparison") from None


def _off(inverse: mpmath.matrix, here: Residual) -> list[mpmath.mpf]:
    """The bounds of |δp|."""
    left = [abs(f) + e for f, e in zip(here.values, here.errors, strict=True)]
    return [mpmath.fsum(abs(inverse[i, j]) * x for j, x in enumerate(left)) for i in range(inverse.rows)]
