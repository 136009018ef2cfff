"""A value is true where two precisions find it alike: more digits are taken until they do, or it is refused."""

from collections.abc import Callable, Sequence
from typing import Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

DIGITS = 47         # of what is held against floats: thirty more than they have
START, LIMIT = 60, 960
LOST = (ZeroDivisionError, RuntimeError, ValueError)    # what too few digits end in


class DoesNotSettle(PhysicsError):
    """No two precisions find the same value."""


class TrueValues(NamedTuple):
    """Numbers of mpmath, in which `digits` digits are alike in two precisions, `working` and `before`; about: what else
    was found with them."""

    values: list[Any]
    digits: int
    working: int
    before: int
    about: Any = None


def settled(found: Callable[..., Any], digits: int = DIGITS, start: int = START, limit: int = LIMIT,
            growth: float = 2.0, sized: bool = False) -> TrueValues:
    """The values that `found()`, (numbers, anything), gives at the working precision, at `growth` times as many digits
    until `digits` of each agree, of what is `sized` relative to `anything`, the size of them all; DoesNotSettle where
    they do not within `limit`."""
    before, last, working = None, 0, start
    while working <= limit:
        with mpmath.workdps(working):
            try:
                values, about = found()
            except LOST:
                values = None
            else:
                if before is not None and alike(before, values, digits, about if sized else None):
                    return TrueValues(list(values), digits, working, last, about)
        before, last, working = values, working, int(growth * working)
    raise DoesNotSettle(f"the reference does not settle: {digits} digits of it are not alike up to {limit}",
                        "leave this quantity out of the comparison")


def alike(before: Sequence[mpmath.mpc | mpmath.mpf], values: Sequence[mpmath.mpc | mpmath.mpf], digits: int,
          size: Any = None) -> bool:
    """Are these as many numbers, each part of each the same to so many digits, of itself unless a size is given? A zero
    is one in both, but for a size."""
    if len(before) != len(values):
        return False
    small = mpmath.mpf(10) ** -digits
    return all(abs(a - b) <= small * (abs(b) if size is None else size) for pair in zip(before, values, strict=True)
               for a, b in zip(*map(_parts, pair), strict=True))


def _parts(x: mpmath.mpc | mpmath.mpf) -> tuple[mpmath.mpf, mpmath.mpf]:
    return mpmath.re(x), mpmath.im(x)


def relative_error(found: Sequence[complex], true: TrueValues) -> float:
    """The largest |x − x*|/|x*| of values, each beside its own true one; what is left over stands beside the zeros
    among these, relative to the largest. Infinite where one has no partner or is not finite."""
    exact = [x for x in true.values if x]
    if not len(exact) <= len(found) <= len(true.values) or not all(map(mpmath.isfinite, found)):
        return float("inf")
    with mpmath.workdps(true.working):
        left, worst = [mpmath.mpmathify(x) for x in found], mpmath.mpf(0)
        for x in sorted(exact, key=abs, reverse=True):
            nearest = min(range(len(left)), key=lambda i: abs(left[i] - x))
            worst = max(worst, abs(left.pop(nearest) - x) / abs(x))
        largest = max(map(abs, exact), default=mpmath.mpf(1))
        return float(max([worst, *(abs(x) / largest for x in left)]))
