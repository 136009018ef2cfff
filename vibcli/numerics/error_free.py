"""Products and sums of doubles with what their rounding took: a b = p + r, a + b = s + e (Veltkamp, Dekker 1971; Knuth
1969)."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np

SPLIT = 2.0 ** 27 + 1


def whole_product(a: Any, b: Any) -> tuple[Any, Any]:
    """a b as (fl(a b), what rounding took)."""
    product = a * b
    (high, low), (other, rest) = _halves(a), _halves(b)
    return product, ((high * other - product) + high * rest + low * other) + low * rest


def whole_sum(a: Any, b: Any) -> tuple[Any, Any]:
    """a + b as (fl(a + b), what rounding took)."""
    total = a + b
    added = total - a
    return total, (a - (total - added)) + (b - added)


def _halves(a: "np.ndarray") -> "tuple[np.ndarray, np.ndarray]":
    """A double as the sum of two of 26 digits."""
    large = SPLIT * a
    high = large - (large - a)
    return high, a - high
