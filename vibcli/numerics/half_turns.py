"""Angles m π x/l of many half-turns m, reduced without loss: m x/l with its rounding, less whole turns."""

from typing import Any

import numpy as np

from vibcli.numerics.error_free import whole_product


def half_turns(m: Any, x: Any, length: Any, mirrored: bool) -> tuple[Any, Any, Any]:
    """(t, rest, x/l): m x/l = t + rest + a multiple of 2, |t| ≤ 1, |rest| of the order m eps; mirrored: of l − x."""
    place = length - x if mirrored else x
    lost = (length - place) - x if mirrored else 0.0
    share = place / length
    product, rest = whole_product(share, length)
    lost = (((place - product) - rest) + lost) / length
    turns, rest = whole_product(m, share)
    return turns - 2 * np.rint(turns / 2), rest + m * lost, share
