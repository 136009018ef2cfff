"""Shapes of uniform members with classical ends in closed form, to the last digits at any place of any mode.

    u = A cos βx + B sin βx + C e^(−βx) + D e^(−β(L−x)),    ∫ u² dx = L, bars, shafts and strings without C and D

x counts from the end on rollers where one is pinned or guided, else from the left. With q = e^(−βL), p = −(−1)ⁿ,

    both ends clamped or free      C = 1/(1 + pq)   D = pC   A = ∓1   B = ±(1 − pq)C                clamped, free left
    clamped or free and pinned     D = ∓1/(1 − q²)  C = −qD  B = (−1)ⁿ √(1 + coth² βL)              clamped, free
    clamped or free and guided     D = ∓1/(1 + q²)  C = qD   A = (−1)ⁿ √(1 + tanh² βL)
    pinned and guided alone, all of order 2                  A or B = √2                Blevins, Formulas for Dynamics

Angles βx are reduced as (n + c) x/L half-turns and a small rest: π(n + c) itself would be rounded.
"""

from itertools import repeat
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.analyses.continuous.uniform_members import GUIDED, PINNED
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.half_turns import half_turns

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.analyses.continuous.uniform_members import UniformMember

CLAMPED = (False, False)
ROUND = {PINNED: "sine", GUIDED: "cosine", (False,): "sine", (True,): "cosine"}


class UniformCurves(NamedTuple):
    """u of unit modal mass of one mode or, as arrays, of many: βL = π turns + rest; x counts from the right where
    mirrored; bends: is it a beam."""

    length: float
    turns: Any
    rest: Any
    cosine: Any
    sine: Any
    left: Any
    right: Any
    mirrored: bool
    bends: bool

    def each(self) -> "Iterator[UniformCurves]":
        """Those of each of many modes."""
        return map(UniformCurves, *(part if part.__class__ is np.ndarray else repeat(part) for part in self))

    def along(self, x: Any) -> np.ndarray:
        """(u, u′), of beams (u, u′, u″, u‴), at places x, (…, order); of many modes x and these broadcast."""
        x = np.clip(np.asarray(x, float), 0.0, self.length)
        turn, rest, share = half_turns(self.turns, x, self.length, self.mirrored)
        angle, total = np.pi * turn + (np.pi * rest + self.rest * share), np.pi * self.turns + self.rest
        cosine, sine = np.cos(angle), np.sin(angle)
        left = right = 0.0
        if self.bends:
            left, right = self.left * np.exp(-total * share), self.right * np.exp(-total * (1 - share))
        even, odd = self.cosine * cosine + self.sine * sine, self.sine * cosine - self.cosine * sine
        factor = (-1 if self.mirrored else 1) * total / self.length
        found = [even + (left + right), factor * (odd + (right - left))]
        if self.bends:
            found += [factor**2 * ((left + right) - even), factor**3 * ((right - left) - odd)]
        return np.stack(np.broadcast_arrays(*found), axis=-1)


def uniform_curves(member: "UniformMember", numbers: np.ndarray) -> UniformCurves:
    """The shapes of so numbered modes, those that rest along the whole member not counted."""
    turns, rest = member.phases(numbers)
    piece, (first, last), zero = member.piece, member.ends, 0.0 * turns
    mirrored = first not in ROUND and last in ROUND
    near, far = (last, first) if mirrored else (first, last)
    total = np.pi * turns + rest
    sign, q = np.where(numbers % 2, -1.0, 1.0), np.exp(-total)
    cosine = sine = left = right = zero
    if near not in ROUND:
        left = 1 / (1 - sign * q)
        right, tilt = -sign * left, (1 + sign * q) * left
        cosine, sine = (zero - 1, tilt) if near == CLAMPED else (zero + 1, -tilt)
    elif far in ROUND:
        cosine, sine = (zero, zero + 2**0.5) if ROUND[near] == "sine" else (zero + 2**0.5, zero)
    else:
        tanh, turned = np.tanh(total), -1 if far == CLAMPED else 1
        if near == PINNED:
            right, sine = turned / (1 - q * q), sign * np.sqrt(1 + 1 / tanh**2)
            left = -q * right
        else:
            right, cosine = turned / (1 + q * q), sign * np.sqrt(1 + tanh**2)
            left = q * right
    unit = (piece.inertia * piece.length) ** 0.5
    return UniformCurves(piece.length, turns, rest, cosine / unit, sine / unit, left / unit, right / unit, mirrored,
                         piece.order == 4)
