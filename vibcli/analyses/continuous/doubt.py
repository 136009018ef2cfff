"""How far a motion by modes is off for what rounds in these: its states Σ r C e^{λτ} by their λ, by r C, and by

    |δφⱼ| = share |φₖ|,    share = 2 √(zⱼ zₖ) Σ bⱼ bₖ/|zⱼ − zₖ|

what one shape holds of another, b² being what rounds at each coordinate, as a part of ω = √z. Of near modes whose
shapes are orthogonal, two such shares cancel but for what their frequencies differ by: |zⱼ − zₖ| is no more in it.
"""

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.analyses.continuous.modal_states import FreeStretch, States
    from vibcli.analyses.continuous.mode_basis import ModeBasis

EPSILON = 2.0**-52
BESIDE = 8          # neighbours of which a shape may hold something
SAME = 1e-5         # a relative gap that only shapes orthogonal to each other, or in more digits, tell


class Doubt(NamedTuple):
    """Relative bounds `phase` of λ and `size` of amplitudes, (states,); pairs: states that are mixed, (2, pairs), with
    early and late: what a mix is of |rⱼ Cₖ| + |rₖ Cⱼ| at once, and by the time, (pairs,)."""

    phase: np.ndarray
    size: np.ndarray
    pairs: np.ndarray = np.zeros((2, 0), int)
    early: np.ndarray = np.zeros(0)
    late: np.ndarray = np.zeros(0)

    def of(self, rates: np.ndarray, reads: np.ndarray, free: np.ndarray, tau: float = 0.0) -> tuple[float, float]:
        """Of states that are read by r and begin with C, as they have faded after a time: at once, and by the time."""
        r, C, fade = np.abs(reads), np.abs(free), np.exp(rates.real * tau)
        felt, (j, k) = r * C * fade, self.pairs
        crossed = (r[j] * C[k] + r[k] * C[j]) * np.maximum(fade[j], fade[k])
        return (float(self.size @ felt + self.early @ crossed),
                float((self.phase * np.abs(rates)) @ felt + self.late @ crossed))


def aged(doubt: Doubt, rates: np.ndarray, stretches: "Sequence[FreeStretch]") -> list[np.ndarray]:
    """How far each C is off at the start of each stretch, as phases are by then, and for what cancels in it,
    (states,)."""
    cancelled = [4 * EPSILON * (one.sizes - np.abs(one.free)) for one in stretches]
    found, pace = cancelled[:1], (doubt.phase + EPSILON) * np.abs(rates)
    for (one, after), own in zip(pairwise(stretches), cancelled[1:], strict=True):
        tau = after.start - one.start
        fade = np.exp(rates.real * tau)
        found.append(found[-1] * fade + pace * tau * np.maximum(np.abs(one.free) * fade, np.abs(after.free)) + own)
    return found


def doubt_of(basis: "ModeBasis", states: "States") -> Doubt:
    """Of modes that move each by itself."""
    z, errors, known = basis.squares, basis.errors, np.full(len(basis.squares), -1)
    first = np.flatnonzero(np.append(True, np.diff(states.modes) != 0))
    known[states.modes[first[::-1]]] = first[::-1]      # of two λ of a mode the first
    phase, size = errors[states.modes] + EPSILON, np.full(len(states.modes), 8 * EPSILON)
    moving = np.flatnonzero(known >= 0)
    pairs, early, late = [], [], []
    for away in range(1, min(BESIDE, len(moving) - 1) + 1):
        j, k = moving[:-away], moving[away:]
        apart, one = abs(z[k] - z[j]), basis.numbers[j] == basis.numbers[k]
        with np.errstate(divide="ignore", invalid="ignore"):
            both = np.einsum("jn,jn->j", basis.blurred[j], basis.blurred[k])
            share = 4 * both * np.sqrt(abs(z[j] * z[k])) / apart
            gap = apart / (2 * np.maximum(abs(z[j]), abs(z[k])))
        unsure = ~one & (gap < SAME)
        pairs.append(known[[j, k]])
        early.append(np.where(one, 4 * both, np.where(unsure, 2.0, np.minimum(share, 2.0))))
        late.append(np.where(one, 4 * both * abs(z[j] * z[k]) ** 0.25, 0.0))
    return Doubt(phase, size, np.concatenate(pairs, axis=1), *map(np.concatenate, (early, late))) if pairs else Doubt(
        phase, size)
