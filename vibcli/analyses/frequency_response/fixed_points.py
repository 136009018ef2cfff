"""Fixed points: frequencies at which |H| does not depend on a damper (Den Hartog 1956, §3.3).

A damper c adds s c r rᵀ to K + sC + s²M, so that H = (A + c B)/(1 + c E) at each frequency. Where nothing else damps,
|H| is the same for all c exactly where it is the same for c = 0 and c → ∞: |A| = |B/E|.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.analyses.frequency_response.evaluate import sampled
from vibcli.analyses.frequency_response.extremes import places, reaches
from vibcli.base.named_tuple import NamedTuple
from vibcli.numerics.ascending import ascending
from vibcli.numerics.bracketing import zeros_between

if TYPE_CHECKING:
    from vibcli.analyses.frequency_response.frequency_response_function import FrequencyResponseFunction

SAME, STATIC, STRONG, FELT = 1e-8, 1e-3, 1e4, 1e-6


class FixedPoint(NamedTuple):
    """Omega in rad/s and |H| there."""

    Omega: float
    value: float


def fixed_points(without: "FrequencyResponseFunction",
                 with_one: "FrequencyResponseFunction") -> list[FixedPoint]:
    """The FixedPoints with Ω > 0, ascending, from the responses with c = 0 and c = 1 (in any unit)."""
    if not reaches(with_one):
        return []
    typical = without.felt(with_one)
    systems = [without, *(without.with_damper(with_one, typical * share) for share in (1.0, 2.0, STRONG))]
    Omega = ascending(np.concatenate([places(system) for system in systems]))

    def difference(Omega: np.ndarray) -> np.ndarray:
        values = [sampled(system, Omega)[0] for system in systems[:3]]
        free, held = values[0], limit(*values)
        with np.errstate(all="ignore"):
            found: np.ndarray = np.log(np.abs(free)) - np.log(np.abs(held))
            return found

    def felt(Omega: np.ndarray) -> np.ndarray:    # elsewhere the limit is lost in rounding
        free, once = (sampled(system, Omega)[0] for system in systems[:2])
        found: np.ndarray = np.abs(once - free) > FELT * np.abs(free)
        return found

    gaps = difference(Omega)
    gaps[(np.abs(gaps) <= 1e-12) | ~felt(Omega)] = np.nan
    known = np.flatnonzero(np.isfinite(gaps))
    change = known[:-1][np.sign(gaps[known[:-1]]) != np.sign(gaps[known[1:]])]
    after = known[np.searchsorted(known, change) + 1]
    found = zeros_between(difference, Omega[change], Omega[after]) if len(change) else np.zeros(0)
    heights = [np.abs(sampled(system, found)[0]) for system in systems]
    low = STATIC * without.pace
    return [FixedPoint(float(at), float(height)) for at, height, *others in zip(found, *heights, strict=True)
            if at > low and all(abs(other - height) <= SAME * height for other in others)]


def limit(free: np.ndarray, once: np.ndarray, twice: np.ndarray) -> np.ndarray:
    """H for c → ∞ from those for c = 0, c₁ and 2c₁."""
    with np.errstate(all="ignore"):
        one, two = once - free, (twice - free) / 2
        E = (one - two) / (twice - once)
        found: np.ndarray = (one + once * E) / E
        return found

